// What is written reads back with the same bits.
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

#include "io/mesh_file.h"
#include "io/point_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

// Numbers at the ends of the format, and 1000 random bit patterns.
std::vector<double> difficult_numbers() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> numbers = {0.0,
                                 -0.0,
                                 Limits::denorm_min(),
                                 -Limits::denorm_min(),
                                 Limits::min(),
                                 std::nextafter(Limits::min(), 0.0),
                                 Limits::max(),
                                 Limits::lowest(),
                                 1e308,
                                 0.1,
                                 1.0 / 3.0,
                                 4500000.000000123,
                                 9007199254740993.0,
                                 5e-324,
                                 1e22,
                                 1e23};
  std::mt19937_64 random(20050101);
  while (numbers.size() < 1000) {
    const auto number = std::bit_cast<double>(random());
    if (std::isfinite(number)) numbers.push_back(number);
  }
  return numbers;
}

std::vector<Point> difficult_points() {
  const std::vector<double> numbers = difficult_numbers();
  std::vector<Point> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); ++i) {
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return points;
}

// All bits, unlike ==, for which -0 equals 0.
std::vector<std::uint64_t> bits_of(Points points) {
  std::vector<std::uint64_t> bits;
  for (const Point& p : points) {
    for (int axis = 0; axis < 3; ++axis) bits.push_back(std::bit_cast<std::uint64_t>(p[axis]));
  }
  return bits;
}

// volatile: g++ 12 -O3 vectorizes double -> float -> double to nothing.
double through_float(double value) {
  volatile float rounded = static_cast<float>(value);
  return rounded;
}

TriangleMesh difficult_mesh() {
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>(difficult_points());
  for (std::size_t i = 0; i + 2 < mesh.points.size(); ++i) {
    mesh.triangles.push_back({VertexId(i + 2), VertexId(i), VertexId(i + 1)});
  }
  return mesh;
}

TEST(RoundTrip, PointsKeepAllBitsInEveryFormat) {
  const TemporaryFolder folder;
  const std::vector<Point> points = difficult_points();
  for (const char* name :
       {"a.xyz", "a.txt", "a.csv", "a.pts", "a.ply", "a.obj", "a.off", "A.PLY"}) {
    write_points(folder / name, points);
    EXPECT_EQ(bits_of(read_points(folder / name).points), bits_of(points)) << name;
  }
  write_points(folder / "a.ply", points, {.ascii = true});
  EXPECT_EQ(bits_of(read_points(folder / "a.ply").points), bits_of(points));
}

TEST(RoundTrip, MeshesKeepAllBitsAndTheirOrder) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = difficult_mesh();
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.OFF"}) {
    for (bool ascii : {false, true}) {
      write_mesh(folder / name, mesh, {.ascii = ascii});
      const TriangleMesh back = read_mesh(folder / name);
      EXPECT_EQ(bits_of(back.points.span()), bits_of(mesh.points.span())) << name;
      EXPECT_EQ(back.triangles, mesh.triangles) << name;
    }
  }
}

// STL has no vertices: they come back in the order of the corners, welded.
TEST(RoundTrip, AsciiStlKeepsAllBitsOfEveryCorner) {
  const TemporaryFolder folder;
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>(
      {{5e-324, -1e308, 0.1}, {1.0 / 3.0, 0, 1e22}, {2, 4500000.000000123, 7}, {1, 2, 3}});
  mesh.triangles = IdVector<TriangleId, Triangle>(
      {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(0), VertexId(2), VertexId(3)}});
  write_mesh(folder / "a.stl", mesh, {.ascii = true});
  const TriangleMesh back = read_mesh(folder / "a.stl");
  EXPECT_EQ(bits_of(back.points.span()), bits_of(mesh.points.span()));
  EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(RoundTrip, BinaryStlAndFloatPlyRoundToFloat) {
  const TemporaryFolder folder;
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>({{0.1, 1.0 / 3.0, 1e-40}, {1, 0, 0}, {0, 1e38, 0}});
  mesh.triangles.push_back({VertexId(0), VertexId(1), VertexId(2)});
  TriangleMesh rounded = mesh;
  for (Point& p : rounded.points) p = {through_float(p.x), through_float(p.y), through_float(p.z)};
  ASSERT_NE(rounded, mesh);
  write_mesh(folder / "a.stl", mesh);
  EXPECT_EQ(read_mesh(folder / "a.stl"), rounded);
  write_mesh(folder / "a.ply", mesh, {.single_precision = true});
  EXPECT_EQ(read_mesh(folder / "a.ply"), rounded);
}

TEST(RoundTrip, WhatNoFloatHoldsIsRefusedAndTheOldFileStays) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = difficult_mesh();
  for (const char* name : {"a.stl", "a.ply"}) {
    folder.write(name, "old");
    EXPECT_THROW(write_mesh(folder / name, mesh, {.single_precision = true}), FileError) << name;
    EXPECT_EQ(content_of(folder / name), "old") << name;
  }
  EXPECT_EQ(folder.names().size(), 2U);
}

TEST(RoundTrip, EmptyMeshesWhereTheFormatCanSayIt) {
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.off", "a.stl"}) {
    for (bool ascii : {false, true}) {
      write_mesh(folder / name, TriangleMesh(), {.ascii = ascii});
      EXPECT_EQ(read_mesh(folder / name), TriangleMesh()) << name;
    }
  }
}

TEST(RoundTrip, NothingIsWrittenThatCouldNotBeRead) {
  const TemporaryFolder folder;
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>({{0, 0, 0}, {1, 0, 0}, {0, 1, NAN}});
  EXPECT_EQ(message_of<FileError>(folder / "a.ply", [&] { write_mesh(folder / "a.ply", mesh); }),
            ": not written: vertex 2 has a coordinate that is not a finite number");
  EXPECT_THROW(write_points(folder / "a.xyz", mesh.points.span()), FileError);
  mesh.points[VertexId(2)] = {0, 1, 0};
  mesh.triangles.push_back({VertexId(0), VertexId(1), VertexId(3)});
  EXPECT_EQ(message_of<FileError>(folder / "a.ply", [&] { write_mesh(folder / "a.ply", mesh); }),
            ": not written: triangle 0 has a corner that is no vertex");
  EXPECT_EQ(folder.names().size(), 0U);
}

TEST(RoundTrip, UnknownExtensionsAreRefusedBeforeAnythingHappens) {
  const TemporaryFolder folder;
  const std::vector<Point> points = {{1, 2, 3}};
  for (const char* name : {"a", "a.stp", "a.stl", ".ply"}) {
    EXPECT_THROW(write_points(folder / name, points), FileError) << name;
  }
  for (const char* name : {"a", "a.xyz", "a.gltf"}) {
    EXPECT_THROW(write_mesh(folder / name, TriangleMesh()), FileError) << name;
    EXPECT_THROW(read_mesh(folder.write(name, "1 2 3\n")), FileError) << name;
  }
  EXPECT_THROW(read_points(folder.write("a.las", "1 2 3\n")), FileError);
}

}  // namespace
}  // namespace cocoon
