#include "geom/mesh/dense_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "geom/search/nearest_point.h"

namespace cocoon {
namespace {

// A box of 4 x 3 x height from two triangles a side.
TriangleMesh box(double height) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.points.push_back({k % 2 * 4.0, k / 2 % 2 * 3.0, k / 4 * height});
  }
  const std::size_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& s : sides) {
    mesh.triangles.push_back({VertexId(s[0]), VertexId(s[1]), VertexId(s[2])});
    mesh.triangles.push_back({VertexId(s[0]), VertexId(s[2]), VertexId(s[3])});
  }
  return mesh;
}

bool on_box(const Point& p, double height) {
  const auto at = [](double x, double end) {
    return std::abs(x) < 1e-12 || std::abs(x - end) < 1e-12;
  };
  return at(p.x, 4) || at(p.y, 3) || at(p.z, height);
}

// No place of the box is far from a sample, on its own side even if the other one is close; and
// samples on a side are apart.
TEST(DenseSamples, CoverAThinBoxOnBothSides) {
  for (const double height : {2.0, 0.05}) {
    const TriangleMesh mesh = box(height);
    constexpr double spacing = 0.2;
    const std::vector<Point> added = dense_samples(mesh, {.spacing = spacing});
    for (const double z : {0.0, height}) {
      std::vector<Point> side;
      for (const Point& p : added) {
        EXPECT_TRUE(on_box(p, height));
        if (std::abs(p.z - z) < 1e-12) side.push_back(p);
      }
      for (const Point& p : mesh.points) side.push_back(p);
      const NearestPointTree tree(side);
      for (int i = 0; i <= 80; ++i) {
        for (int j = 0; j <= 60; ++j) {
          const Point place{i * 0.05, j * 0.05, z};
          EXPECT_LT(tree.nearest(place).squared_distance, 1.3 * 1.3 * spacing * spacing);
        }
      }
      for (std::size_t i = 0; i < side.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (side[i].z != side[j].z) continue;
          EXPECT_GE(distance(side[i], side[j]), 0.79 * spacing);
        }
      }
    }
  }
}

// Sharp edges are sampled evenly, the diagonals of flat sides are not.
TEST(DenseSamples, LieAlongSharpEdges) {
  const std::vector<Point> added = dense_samples(box(2), {.spacing = 0.25});
  const auto has = [&](const Point& p) {
    return std::any_of(added.begin(), added.end(),
                       [&](const Point& q) { return distance(p, q) < 1e-12; });
  };
  for (int k = 1; k < 16; ++k) EXPECT_TRUE(has({k * 0.25, 0, 0})) << k;
  for (int k = 1; k < 12; ++k) EXPECT_TRUE(has({4, k * 0.25, 2})) << k;
}

// An edge with a third triangle is sharp, whichever two of them lie in one plane.
TEST(DenseSamples, LieAlongEdgesOfThreeTriangles) {
  std::vector<Triangle> triangles = {{VertexId(0U), VertexId(1U), VertexId(2U)},
                                     {VertexId(1U), VertexId(0U), VertexId(3U)},
                                     {VertexId(0U), VertexId(1U), VertexId(4U)}};
  for (int round = 0; round < 3; ++round) {
    TriangleMesh mesh;
    for (const Point& p :
         {Point{0, 0, 0}, Point{3, 0, 0}, Point{1, 2, 0}, Point{2, -2, 0}, Point{1, 0, 2}}) {
      mesh.points.push_back(p);
    }
    std::rotate(triangles.begin(), triangles.begin() + 1, triangles.end());
    for (const Triangle& t : triangles) mesh.triangles.push_back(t);
    const std::vector<Point> added = dense_samples(mesh, {.spacing = 0.5});
    for (int k = 1; k < 6; ++k) {
      EXPECT_EQ(std::count(added.begin(), added.end(), Point{0.5 * k, 0, 0}), 1) << k;
    }
  }
}

// A disk of slivers from its middle, as CAD programs make them: no triangle is a thirtieth of a
// square in size, but together they are many squares.
TEST(DenseSamples, CoverADiskOfSlivers) {
  constexpr std::size_t slivers = 4000;
  constexpr double spacing = 0.4;
  TriangleMesh disk;
  disk.points.push_back({0, 0, 0});
  for (std::size_t i = 0; i < slivers; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / slivers;
    disk.points.push_back({2 * std::cos(angle), 2 * std::sin(angle), 0});
    disk.triangles.push_back({VertexId(0U), VertexId(1 + i), VertexId(1 + (i + 1) % slivers)});
  }
  std::vector<Point> samples = dense_samples(disk, {.spacing = spacing});
  for (const Point& p : disk.points) samples.push_back(p);
  const NearestPointTree tree(samples);
  for (int i = -15; i <= 15; ++i) {
    for (int j = -15; j <= 15; ++j) {
      const Point place{0.1 * i, 0.1 * j, 0};
      EXPECT_LT(tree.nearest(place).squared_distance, 1.3 * 1.3 * spacing * spacing);
    }
  }
}

TEST(DenseSamples, SameMeshSameSamples) {
  EXPECT_EQ(dense_samples(box(1), {.spacing = 0.3}), dense_samples(box(1), {.spacing = 0.3}));
}

TEST(DenseSamples, AddsNothingToAMeshWithoutTriangles) {
  EXPECT_TRUE(dense_samples({}, {.spacing = 1}).empty());
}

TEST(DenseSamples, RefusesSpacingsThatCannotBe) {
  for (const double spacing : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(dense_samples(box(1), {.spacing = spacing}), InputError) << spacing;
    if (spacing > 0) continue;
    EXPECT_THROW(dense_samples(box(1), {.spacing = 0.1, .closest = spacing}), InputError)
        << spacing;
  }
  try {
    dense_samples(box(1), {.spacing = 1e-9});
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("choose a spacing of 0.0006"), std::string::npos)
        << error.what();
  }
}

// Long edges and hardly any area.
TEST(DenseSamples, RefusesTooManyAlongEdges) {
  TriangleMesh needle;
  for (const Point& p : {Point{0, 0, 0}, Point{1, 0, 0}, Point{1, 1e-12, 0}})
    needle.points.push_back(p);
  needle.triangles.push_back({VertexId(0U), VertexId(1U), VertexId(2U)});
  EXPECT_THROW(dense_samples(needle, {.spacing = 1e-9}), InputError);
  EXPECT_FALSE(dense_samples(needle, {.spacing = 1e-3}).empty());
}

// Where squares of areas leave the range of double.
TEST(DenseSamples, CoordinatesOfAnySize) {
  const std::vector<Point> expected = dense_samples(box(1), {.spacing = 0.5});
  for (const double factor : {0x1p-600, 0x1p-270, 0x1p300, 0x1p1000}) {
    TriangleMesh mesh = box(1);
    for (Point& p : mesh.points) p = factor * p;
    std::vector<Point> samples = dense_samples(mesh, {.spacing = 0.5 * factor});
    for (Point& p : samples) p = p / factor;
    EXPECT_EQ(samples, expected) << factor;
  }
  TriangleMesh large = box(1);
  for (Point& p : large.points) p = 0x1p300 * p;
  try {
    dense_samples(large, {.spacing = 0x1p300 * 1e-9});
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("samples 2.03704e+81 apart"), std::string::npos)
        << error.what();
  }
}

// The spacing that a refusal advises is in units of the coordinates, whatever size these have.
TEST(DenseSamples, ARefusalAdvisesASpacingThatIsPossible) {
  TriangleMesh needle;
  for (const Point& p : {Point{0, 0, 0}, Point{4, 0, 0}, Point{4, 1e-12, 0}})
    needle.points.push_back(p);
  needle.triangles.push_back({VertexId(0U), VertexId(1U), VertexId(2U)});
  const auto advised = [](TriangleMesh mesh, double factor) {
    for (Point& p : mesh.points) p = factor * p;
    try {
      dense_samples(mesh, {.spacing = 1e-9 * factor});
    } catch (const InputError& error) {
      const std::string text = error.what();
      return std::strtod(text.c_str() + text.find("spacing of ") + 11, nullptr) / factor;
    }
    return 0.0;
  };
  for (const double factor : {1.0, 0x1p300, 0x1p-300}) {
    EXPECT_NEAR(advised(box(1), factor), std::sqrt(38 / most_dense_samples), 1e-8) << factor;
    EXPECT_NEAR(advised(needle, factor), 8 / most_dense_samples, 1e-12) << factor;
  }
}

TEST(DenseSamples, FarFromTheOriginToo) {
  const std::size_t usual = dense_samples(box(1), {.spacing = 0.5}).size();
  TriangleMesh far = box(1);
  for (Point& p : far.points) p.x += 0x1p40;
  const std::vector<Point> samples = dense_samples(far, {.spacing = 0.5});
  EXPECT_NEAR(static_cast<double>(samples.size()), static_cast<double>(usual),
              0.1 * static_cast<double>(usual));
  for (const Point& p : samples) {
    EXPECT_TRUE(p.x >= 0x1p40 && p.x <= 0x1p40 + 4) << p.x - 0x1p40;
    EXPECT_TRUE(p.y >= 0 && p.y <= 3) << p.y;
    EXPECT_TRUE(p.z >= 0 && p.z <= 1) << p.z;
  }
  // There, beside the distance from the origin, the box has no area.
  for (Point& p : far.points) p.x = 1e300;
  EXPECT_TRUE(dense_samples(far, {.spacing = 0.5}).empty());
}

}  // namespace
}  // namespace cocoon
