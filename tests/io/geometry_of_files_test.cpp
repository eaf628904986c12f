// The geometric step between a file and a mesh, cutting polygons; and the small writers: polylines,
// base64.
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <vector>

#include "geom/errors.h"
#include "io/encoding/base64.h"
#include "io/mesh_file.h"
#include "io/polygons/triangulate_polygon.h"
#include "io/polyline_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

std::vector<Triangle> cut(const std::vector<Point>& points) {
  std::vector<VertexId> corners;
  for (std::size_t i = 0; i < points.size(); ++i) corners.push_back(VertexId(i));
  std::vector<Triangle> triangles = {{}, {}};  // what was there before goes away
  triangulate_polygon(points, corners, triangles);
  return triangles;
}

Vec3 area_of(const std::vector<Point>& points, const Triangle& t) {
  const Point& a = points[t[0].index()];
  return 0.5 * cross(points[t[1].index()] - a, points[t[2].index()] - a);
}

// Every triangle turns as the polygon does, and all together have its area: they tile it.
void expect_tiling(const std::vector<Point>& points, const Vec3& unit_normal, double area) {
  const std::vector<Triangle> triangles = cut(points);
  ASSERT_EQ(triangles.size(), points.size() - 2);
  double sum = 0;
  for (const Triangle& t : triangles) {
    EXPECT_GE(dot(area_of(points, t), unit_normal), -1e-12);
    sum += norm(area_of(points, t));
  }
  EXPECT_NEAR(sum, area, 1e-9);
}

// Edges of the triangles that no other triangle runs through in the opposite direction.
std::map<std::pair<VertexId, VertexId>, int> border_of(const std::vector<Triangle>& triangles) {
  std::map<std::pair<VertexId, VertexId>, int> border;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = t[i];
      const VertexId b = t[(i + 1) % 3];
      if (--border[{b, a}] == 0) border.erase({b, a});
      if (++border[{a, b}] == 0) border.erase({a, b});
    }
  }
  std::erase_if(border, [](const auto& edge) { return edge.second < 0; });
  return border;
}

TEST(TriangulatePolygon, ConvexPolygonsBecomeFans) {
  const std::vector<Triangle> expected = {{VertexId(0), VertexId(1), VertexId(2)},
                                          {VertexId(0), VertexId(2), VertexId(3)}};
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), expected);
  EXPECT_EQ(cut({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}), expected);
  EXPECT_EQ(cut({{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}), expected);
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}), expected);
}

TEST(TriangulatePolygon, ConcavePolygonsAreTiled) {
  // An L, a spike and a comb; a fan from the first corner would fold over.
  expect_tiling({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {0, 0, 1}, 3);
  expect_tiling({{0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}}, {0, 0, 1}, 3);
  expect_tiling({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 4, 0}}, {0, 0, 1}, 5);
  std::vector<Point> comb;
  for (int i = 0; i < 9; ++i) comb.push_back({static_cast<double>(i), i % 2 == 0 ? 0.5 : 5.0, 0});
  comb.push_back({8, -1, 0});
  comb.push_back({0, -1, 0});
  double area = 0;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    area += 0.5 * cross(comb[i], comb[(i + 1) % comb.size()]).z;
  }
  expect_tiling(comb, {0, 0, -1}, std::abs(area));
  for (Point& p : comb) p = {p.z, p.x, p.y};
  expect_tiling(comb, {-1, 0, 0}, std::abs(area));
}

// Whatever the corners, the triangles are n - 2 and bounded by the polygon's edges.
TEST(TriangulatePolygon, AlwaysKeepsTheBoundary) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Point> points(3 + random() % 12);
    for (Point& p : points) {  // small integers: collinear, repeated and crossing corners
      p = {static_cast<double>(random() % 4), static_cast<double>(random() % 4),
           static_cast<double>(random() % 2)};
    }
    const std::vector<Triangle> triangles = cut(points);
    EXPECT_EQ(triangles.size(), points.size() - 2);
    std::map<std::pair<VertexId, VertexId>, int> polygon;
    for (std::size_t i = 0; i < points.size(); ++i) {
      polygon[{VertexId(i), VertexId((i + 1) % points.size())}] = 1;
    }
    EXPECT_EQ(border_of(triangles), polygon) << "trial " << trial;
  }
}

TEST(PolylineFile, LoopsAreClosedAndOnlyTheirPointsAreWritten) {
  const TemporaryFolder folder;
  const std::vector<Point> points = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {8, 8, 8}};
  const std::vector<std::vector<VertexId>> loops = {{VertexId(3), VertexId(1), VertexId(2)},
                                                    {VertexId(2), VertexId(4), VertexId(3)}};
  write_polylines(folder / "a.obj", points, loops);
  EXPECT_EQ(content_of(folder / "a.obj"),
            "# written by cocoon\nv 0 1 0.1\nv 0 0 0\nv 1 0 0\nv 8 8 8\nl 1 2 3 1\nl 3 4 1 3\n");
  EXPECT_EQ(read_mesh(folder / "a.obj").points.size(), 4U);
  EXPECT_THROW(write_polylines(folder / "a.ply", points, loops), FileError);
  const std::vector<std::vector<VertexId>> wrong = {{VertexId(5)}};
  EXPECT_THROW(write_polylines(folder / "b.obj", points, wrong), FileError);
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(Base64, VectorsOfRfc4648) {
  const std::vector<std::pair<std::string, std::string>> vectors = {{"", ""},
                                                                    {"f", "Zg=="},
                                                                    {"fo", "Zm8="},
                                                                    {"foo", "Zm9v"},
                                                                    {"foob", "Zm9vYg=="},
                                                                    {"fooba", "Zm9vYmE="},
                                                                    {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, code] : vectors) {
    std::string text = "before ";
    append_base64(text, bytes);
    EXPECT_EQ(text, "before " + code);
  }
  std::string high;
  append_base64(high, "\xFF\xFE\x80");
  EXPECT_EQ(high, "//6A");
}

}  // namespace
}  // namespace cocoon
