// Polygons that touch themselves: holes joined to the outline by bridges, doubled corners, spikes.
#include "io/polygons/triangulate_polygon.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "geom/orient3d.h"
#include "io/mesh_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

using Ring = std::vector<Point>;  // whole numbers in the plane z = 0: all sums below are exact

Sign turn(const Point& a, const Point& b, const Point& c) {
  return orient2d(a.x, a.y, b.x, b.y, c.x, c.y);
}

double twice_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += cross(ring[i], ring[(i + 1) % ring.size()]).z;
  return sum;
}

std::vector<Triangle> cut(const Ring& points) {
  std::vector<VertexId> corners;
  for (std::size_t i = 0; i < points.size(); ++i) corners.push_back(VertexId(i));
  std::vector<Triangle> triangles;
  triangulate_polygon(points, corners, triangles);
  return triangles;
}

// The triangles have the polygon as their boundary, and none is turned over: so they lie side by
// side, and cover what the polygon goes around once. `flat` of them have no area.
void expect_tiling(const Ring& polygon, std::size_t flat = 0) {
  Ring tilted = polygon;
  for (Point& p : tilted) p = {p.x + 2 * p.y, p.x, p.y};
  const std::vector<Triangle> triangles = cut(polygon);
  EXPECT_EQ(cut(tilted).size(), triangles.size());
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0;
  std::size_t without_area = 0;
  std::map<std::pair<VertexId, VertexId>, int> border;
  for (const Triangle& t : triangles) {
    const Ring corners = {polygon[t[0].index()], polygon[t[1].index()], polygon[t[2].index()]};
    EXPECT_GE(twice_area(corners), 0);
    sum += twice_area(corners);
    without_area += twice_area(corners) == 0 ? 1 : 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = t[i];
      const VertexId b = t[(i + 1) % 3];
      ++border[{a, b}];
      --border[{b, a}];
    }
  }
  EXPECT_EQ(sum, twice_area(polygon));
  EXPECT_EQ(without_area, flat);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const VertexId a(i);
    const VertexId b((i + 1) % polygon.size());
    EXPECT_EQ((border[{a, b}]), 1);
    EXPECT_EQ((border[{b, a}]), -1);
  }
  const auto inner = std::count_if(border.begin(), border.end(),
                                   [](const auto& edge) { return edge.second == 0; });
  EXPECT_EQ(border.size(), 2 * polygon.size() + static_cast<std::size_t>(inner));
}

// A square with a square hole; from the bridge's end on the outline, or on the hole.
TEST(TriangulatePolygon, AHoleAtTheEndOfABridgeStaysOpen) {
  Ring polygon = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                  {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    expect_tiling(polygon);
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
}

TEST(TriangulatePolygon, DoubledCornersChangeNothing) {
  Ring polygon = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {0, 2, 0}};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    expect_tiling(polygon, 2);
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
}

// To a point inside, to one outside; both lie on a corner's line, so that nothing turns right.
TEST(TriangulatePolygon, SpikesHaveNoArea) {
  Ring inward = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {2, 2, 0}};
  Ring outward = {{0, 0, 0}, {4, 0, 0}, {6, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  for (std::size_t i = 0; i < inward.size(); ++i) {
    expect_tiling(inward);
    expect_tiling(outward, 2);
    std::rotate(inward.begin(), inward.begin() + 1, inward.end());
    std::rotate(outward.begin(), outward.begin() + 1, outward.end());
  }
}

// The outline comes back to its corner (4, 0) from inside: what is cut off there must not go over.
TEST(TriangulatePolygon, ACornerThatTouchesAnotherFromInsideIsNotCutOver) {
  Ring polygon = {{0, -9, 0}, {4, 0, 0}, {0, 9, 0},   {-8, 9, 0},
                  {-2, 1, 0}, {4, 0, 0}, {-2, -1, 0}, {-8, -9, 0}};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    expect_tiling(polygon, 2);
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
}

// As the file of a mesh: a repeated corner is a triangle without area, which is left out.
TEST(TriangulatePolygon, RepeatedVerticesOfAFaceAreLeftOut) {
  const TemporaryFolder folder;
  MeshReadReport report;
  const TriangleMesh mesh = read_mesh(
      folder.write("a.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 .5 0\nv 0 2 0\nf 1 2 3 4 4 5\n"),
      report);
  EXPECT_EQ(mesh.triangles.size(), 3U);
  EXPECT_EQ(report.degenerate_triangles, 1U);
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += 0.5 * std::abs(twice_area({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}));
  }
  EXPECT_EQ(sum, 2.5);
}

// With a look at all corners for each triangle, each of these takes a minute or more.
TEST(TriangulatePolygon, ManyCornersTakeNoMoreThanSorting) {
  constexpr std::size_t count = 100000;
  const auto start = std::chrono::steady_clock::now();
  Ring gear;
  Ring comb;
  Ring spiral;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / count;
    const double radius = i % 2 == 0 ? 1e7 : 1.5e7;
    gear.push_back({std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle)), 0});
    const bool back = i >= count / 2;
    const auto along = static_cast<double>(back ? count - 1 - i : i);
    comb.push_back({along, ((i % 2 == 0) != back ? 10.0 : 0.0) + (back ? 2.0 : 0.0), 0});
    const double turned = 80 * std::numbers::pi * along / count;
    const double wide = 1e5 * (turned + (back ? 1 : 3));
    spiral.push_back({std::round(wide * std::cos(turned)), std::round(wide * std::sin(turned)), 0});
  }
  expect_tiling(gear);
  expect_tiling(comb);
  expect_tiling(spiral);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

// ---- random outlines with holes ----

// Corners at growing angles around `center`.
Ring star(const Point& center, double least, double most, std::size_t size, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(least, most);
  std::uniform_real_distribution<double> shift(0, 0.9);
  Ring ring;
  for (std::size_t i = 0; i < size; ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + shift(random)) / static_cast<double>(size);
    const double r = radius(random);
    ring.push_back({std::round(center.x + r * std::cos(angle)),
                    std::round(center.y + r * std::sin(angle)), 0});
  }
  return ring;
}

bool is_on_segment(const Point& a, const Point& b, const Point& p) {
  return turn(a, b, p) == Sign::zero && dot(p - a, p - b) <= 0;
}

// Whether the segments have a point in common, other than a common end.
bool cross_or_touch(const Point& a, const Point& b, const Point& c, const Point& d) {
  for (const auto& [p, q] : {std::pair(a, b), std::pair(b, a)}) {
    if (p != c && p != d) continue;
    const Point& other = p == c ? d : c;
    return is_on_segment(a, b, other) || is_on_segment(c, d, q);
  }
  if (is_on_segment(a, b, c) || is_on_segment(a, b, d)) return true;
  if (is_on_segment(c, d, a) || is_on_segment(c, d, b)) return true;
  return turn(a, b, c) != turn(a, b, d) && turn(c, d, a) != turn(c, d, b);
}

bool meets(const Point& a, const Point& b, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (cross_or_touch(a, b, ring[i], ring[(i + 1) % ring.size()])) return true;
  }
  return false;
}

bool meets(const Ring& a, const Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::find(b.begin(), b.end(), a[i]) != b.end()) return true;
    if (meets(a[i], a[(i + 1) % a.size()], b)) return true;
  }
  return false;
}

bool is_simple(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t k = i + 1; k < ring.size(); ++k) {
      if (ring[i] == ring[k]) return false;
      if (cross_or_touch(ring[i], ring[(i + 1) % ring.size()], ring[k],
                         ring[(k + 1) % ring.size()]))
        return false;
    }
  }
  return true;
}

// Whether the direction from corner i to p goes into the polygon, which lies to the left.
bool goes_inside(const Ring& ring, std::size_t i, const Point& p) {
  const Point& at = ring[i];
  const Point& last = ring[(i + ring.size() - 1) % ring.size()];
  const Point& next = ring[(i + 1) % ring.size()];
  const bool left_of_next = turn(at, next, p) == Sign::positive;
  const bool right_of_last = turn(at, last, p) == Sign::negative;
  if (turn(last, at, next) == Sign::positive) return left_of_next && right_of_last;
  if (last == next) return turn(at, next, p) != Sign::zero;  // the end of a spike
  return left_of_next || right_of_last;
}

// The polygon with the hole, which runs clockwise, joined to it by a bridge at a random place. One
// corner in two is searched from those that have a bridge.
bool join(Ring& polygon, const Ring& hole, const std::vector<Ring>& others, std::mt19937& random) {
  for (int attempt = 0; attempt < 2000; ++attempt) {
    std::size_t i = random() % polygon.size();
    const bool used = std::count(polygon.begin(), polygon.end(), polygon[i]) > 1;
    if (attempt % 2 == 0 && attempt < 1000 && !used) continue;
    const std::size_t k = random() % hole.size();
    if (!goes_inside(polygon, i, hole[k]) || meets(polygon[i], hole[k], polygon)) continue;
    if (meets(polygon[i], hole[k], hole)) continue;
    if (std::any_of(others.begin(), others.end(),
                    [&](const Ring& ring) { return meets(polygon[i], hole[k], ring); })) {
      continue;
    }
    Ring inserted = {hole.begin() + static_cast<std::ptrdiff_t>(k), hole.end()};
    inserted.insert(inserted.end(), hole.begin(),
                    hole.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    inserted.push_back(polygon[i]);
    polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1, inserted.begin(),
                   inserted.end());
    return true;
  }
  return false;
}

TEST(TriangulatePolygon, RandomOutlinesWithHolesAreTiled) {
  std::mt19937 random(11);
  std::size_t polygons = 0;
  std::size_t holes_in_all = 0;
  for (unsigned trial = 0; trial < 400; ++trial) {
    Ring polygon = star({0, 0, 0}, 60, 150, 5 + random() % 12, random);
    if (!is_simple(polygon)) continue;
    std::vector<Ring> holes;
    for (int i = 0; i < 8; ++i) {
      const Point center = {static_cast<double>(random() % 160) - 80,
                            static_cast<double>(random() % 160) - 80, 0};
      Ring hole = star(center, 4, 20, 3 + random() % 5, random);
      if (!is_simple(hole) || twice_area(hole) <= 0 || norm(center) > 60) continue;
      const auto touches = [&](const Ring& ring) { return meets(hole, ring); };
      if (touches(polygon) || std::any_of(holes.begin(), holes.end(), touches)) continue;
      std::reverse(hole.begin(), hole.end());
      holes.push_back(std::move(hole));
    }
    double area = twice_area(polygon);
    bool joined = true;
    while (!holes.empty() && joined) {
      const Ring hole = std::move(holes.back());
      holes.pop_back();
      area += twice_area(hole);
      joined = join(polygon, hole, holes, random);
      ++holes_in_all;
    }
    if (!joined) continue;
    ASSERT_EQ(twice_area(polygon), area);
    std::size_t doubled = 0;
    for (; doubled < trial % 3; ++doubled) {
      const auto corner = polygon.begin() + static_cast<std::ptrdiff_t>(random() % polygon.size());
      polygon.insert(corner, *corner);
    }
    SCOPED_TRACE(trial);
    expect_tiling(polygon, doubled);
    if (HasFailure()) return;
    ++polygons;
  }
  EXPECT_GT(polygons, 200U);
  EXPECT_GT(holes_in_all, 600U);
}

}  // namespace
}  // namespace cocoon
