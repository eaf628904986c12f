// Saved triangulations come back as they were; damaged files are refused with one line.
#include "io/triangulation_file.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/gallery.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

std::string error_of(const std::filesystem::path& path,
                     const LoadTriangulationOptions& options = {}) {
  try {
    load_triangulation(path, options);
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

void expect_equal(const Triangulation& actual, const Triangulation& expected) {
  EXPECT_TRUE(actual.points() == expected.points());
  EXPECT_TRUE(actual.cell_records() == expected.cell_records());
  EXPECT_TRUE(actual.vertex_of_point() == expected.vertex_of_point());
  EXPECT_EQ(actual.num_finite_cells(), expected.num_finite_cells());
}

TEST(TriangulationFile, ComesBackAsItWas) {
  const TemporaryFolder folder;
  for (const auto& points :
       {gallery::uniform_cube(5000), gallery::repeated(gallery::integer_grid(4), 3),
        gallery::box_faces(5), gallery::scaled(gallery::uniform_cube(11), 1e-300)}) {
    const Triangulation original = delaunay(points).triangulation;
    save_triangulation(folder / "t.dt", original);
    expect_equal(load_triangulation(folder / "t.dt"), original);
    expect_equal(load_triangulation(folder / "t.dt", {.certify = true}), original);
    EXPECT_EQ(folder.names().size(), 1U);
  }
}

// What has no size that is known beforehand.
TEST(TriangulationFile, ComesThroughAPipe) {
  const TemporaryFolder folder;
  const Triangulation original = delaunay(gallery::uniform_cube(3000)).triangulation;
  save_triangulation(folder / "t.dt", original);
  const std::string bytes = content_of(folder / "t.dt");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(folder / "pipe", std::ios::binary) << bytes; });
  expect_equal(load_triangulation(folder / "pipe"), original);
  writer.join();
}

TEST(TriangulationFile, HoldsAnEmptyTriangulation) {
  const TemporaryFolder folder;
  save_triangulation(folder / "empty.dt", {});
  EXPECT_EQ(content_of(folder / "empty.dt").size(), 56U);
  EXPECT_EQ(load_triangulation(folder / "empty.dt").num_cells(), 0U);
}

// The first bytes of a file, so that other programs and later versions can rely on them.
TEST(TriangulationFile, HasTheLayoutOfItsDescription) {
  const TemporaryFolder folder;
  const std::vector<Point> points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}};
  save_triangulation(folder / "t.dt", delaunay(points).triangulation);
  const std::string bytes = content_of(folder / "t.dt");
  EXPECT_EQ(bytes.size(), 48U + 24 * 4 + 32 * 5 + 24 + 8);
  const std::string header(
      "COCOONDT\1\0\0\0\0\0\0\0"
      "\4\0\0\0\0\0\0\0\5\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0\5\0\0\0\0\0\0\0",
      48);
  EXPECT_EQ(bytes.substr(0, 48), header);
}

TEST(TriangulationFile, EveryDamagedByteIsFound) {
  const TemporaryFolder folder;
  save_triangulation(folder / "t.dt", delaunay(gallery::uniform_cube(6)).triangulation);
  const std::string good = content_of(folder / "t.dt");
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
    folder.write("bad.dt", bad);
    ASSERT_NE(error_of(folder / "bad.dt"), "") << "byte " << i;
  }
  // The highest bits of two words, which a plain product would forget.
  std::string bad = good;
  bad[48 + 7] = static_cast<char>(bad[48 + 7] ^ 0x80);
  bad[48 + 31] = static_cast<char>(bad[48 + 31] ^ 0x80);
  folder.write("bad.dt", bad);
  EXPECT_NE(error_of(folder / "bad.dt").find("checksum"), std::string::npos);
}

TEST(TriangulationFile, EveryTruncationIsFound) {
  const TemporaryFolder folder;
  save_triangulation(folder / "t.dt", delaunay(gallery::uniform_cube(12)).triangulation);
  const std::string good = content_of(folder / "t.dt");
  for (std::size_t size = 0; size < good.size(); size += size < 64 ? 1 : 13) {
    folder.write("bad.dt", good.substr(0, size));
    ASSERT_NE(error_of(folder / "bad.dt"), "") << size << " bytes";
  }
  folder.write("bad.dt", good.substr(0, good.size() - 8));
  EXPECT_NE(error_of(folder / "bad.dt").find("cut off"), std::string::npos);
  folder.write("bad.dt", good + "01234567");
  EXPECT_NE(error_of(folder / "bad.dt").find("its header promises"), std::string::npos);
  folder.write("bad.dt", "ply\n");
  EXPECT_NE(error_of(folder / "bad.dt").find("no triangulation file"), std::string::npos);
  EXPECT_NE(error_of(folder / "missing.dt"), "");
}

// Files with a right checksum and wrong content: written by ourselves from arrays that are no
// triangulation.
TEST(TriangulationFile, WrongContentIsNamed) {
  const TemporaryFolder folder;
  const auto error_after = [&](auto change) {
    TriangulationArrays arrays =
        std::move(delaunay(gallery::uniform_cube(12)).triangulation).release();
    const auto finite = static_cast<std::size_t>(
        std::count_if(arrays.cells.begin(), arrays.cells.end(),
                      [](const Cell& cell) { return !is_infinite(cell); }));
    change(arrays);
    save_triangulation(folder / "bad.dt", Triangulation(std::move(arrays), finite));
    return error_of(folder / "bad.dt", {.certify = true});
  };
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_EQ(error_after([](TriangulationArrays&) {}), "");
  EXPECT_TRUE(contains(error_after([](TriangulationArrays& a) {
                         a.points[VertexId(3)].y = std::numeric_limits<double>::infinity();
                       }),
                       "vertex 3 has a coordinate that is not finite"));
  EXPECT_TRUE(contains(
      error_after([](TriangulationArrays& a) { a.cells[CellId(2)].vertices[1] = VertexId(12); }),
      "cell 2 has a vertex out of range"));
  EXPECT_TRUE(contains(error_after([](TriangulationArrays& a) {
                         a.cells[CellId(2)].vertices[1] = a.cells[CellId(2)].vertices[0];
                       }),
                       "cell 2 has a vertex out of range or out of place"));
  EXPECT_TRUE(contains(error_after([](TriangulationArrays& a) {
                         std::swap(a.cells[CellId(1)].neighbors[0],
                                   a.cells[CellId(1)].neighbors[1]);
                       }),
                       "do not name each other"));
  EXPECT_TRUE(contains(error_after([](TriangulationArrays& a) {
                         a.cells[CellId(0)].neighbors[0] = FacetId(0xFFFFFFF0U);
                       }),
                       "do not name each other"));
  EXPECT_TRUE(contains(error_after([](TriangulationArrays& a) {
                         a.vertex_of_point[PointId(5)] = a.vertex_of_point[PointId(6)];
                       }),
                       "has no input point"));
  // A triangulation, but no longer of these points.
  EXPECT_TRUE(contains(error_after([](TriangulationArrays& a) {
                         a.points[VertexId(3)] = a.points[VertexId(3)] + Vec3{5, 0, 0};
                       }),
                       "no Delaunay triangulation"));
}

TEST(TriangulationFile, KeepsAFrozenTriangulationForEditing) {
  const TemporaryFolder folder;
  DynamicDelaunay dynamic;
  dynamic.insert(gallery::uniform_cube(200));
  dynamic.remove(std::vector{VertexId(3), VertexId(4)});
  save_triangulation(folder / "t.dt", dynamic.freeze().triangulation);
  DynamicDelaunay again(load_triangulation(folder / "t.dt", {.certify = true}));
  again.insert(gallery::uniform_cube(20, 5));
  EXPECT_EQ(again.num_vertices(), 218U);
}

}  // namespace
}  // namespace cocoon
