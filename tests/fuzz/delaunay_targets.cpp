// Predicates and triangulations of the worst points.
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "delaunay/canonical_order.h"
#include "delaunay/check_delaunay.h"
#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"
#include "geom/errors.h"
#include "geom/insphere.h"
#include "geom/orient3d.h"
#include "geom/perturbation.h"
#include "ref/brute_force_delaunay.h"
#include "ref/rational_predicates.h"
#include "tests/fuzz/fuzz_target.h"

namespace cocoon::fuzz {

namespace {

constexpr std::size_t most_points = 28;

// The canonical triangulation; nothing where the points do not span space.
std::optional<Triangulation> triangulate(Points points) {
  try {
    return canonical_order(delaunay(points).triangulation);
  } catch (const InputError&) {
    return {};
  }
}

std::vector<Point> sorted_points(const DynamicDelaunay& dynamic) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < dynamic.num_vertex_slots(); ++i) {
    if (dynamic.contains(VertexId(i))) points.push_back(dynamic.point(VertexId(i)));
  }
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace

void predicates_target(Bytes bytes) {
  ByteReader reader(bytes);
  const std::vector<Point> points = take_points(reader, 5);
  if (points.size() < 5) return;
  std::array<Point, 5> p;
  std::copy(points.begin(), points.end(), p.begin());
  const Sign orientation = orient3d(p[0], p[1], p[2], p[3]);
  require(orientation == ref::orient3d(p[0], p[1], p[2], p[3]), "orient3d is exact");
  require(orient2d(p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y) ==
              ref::orient2d(p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y),
          "orient2d is exact");
  if (orientation == Sign::zero) return;
  if (orientation == Sign::negative) std::swap(p[0], p[1]);
  require(insphere(p[0], p[1], p[2], p[3], p[4]) == ref::insphere(p[0], p[1], p[2], p[3], p[4]),
          "insphere is exact");
}

void delaunay_target(Bytes bytes) {
  ByteReader reader(bytes);
  std::vector<Point> points = take_points(reader, most_points);
  const std::optional<Triangulation> built = triangulate(points);
  std::reverse(points.begin(), points.end());
  const std::optional<Triangulation> reversed = triangulate(points);
  require(built.has_value() == reversed.has_value(), "order does not decide what is refused");
  if (!built) return;
  const DelaunayReport report = check_delaunay(*built);
  require(report.ok(), report.first_violation);
  require(ref::occupied_pairs(*built) == 0, "no sphere has a vertex inside");
  require(
      built->points() == reversed->points() && built->cell_records() == reversed->cell_records(),
      "order does not change the triangulation");
  voronoi_dual(*built);
  vertex_stars(*built);
}

// Histories: after each operation the triangulation is that of the points; an operation that is
// refused changes nothing.
void dynamic_delaunay_target(Bytes bytes) {
  ByteReader reader(bytes);
  DynamicDelaunay dynamic;
  for (int operation = 0; operation < 6 && !reader.done(); ++operation) {
    const std::vector<Point> before = sorted_points(dynamic);
    const std::uint8_t what = reader.byte();
    std::vector<VertexId> removed;
    for (int i = 0; i < what % 8; ++i) {
      if (dynamic.num_vertex_slots() == 0) break;
      const VertexId v(reader.byte() % dynamic.num_vertex_slots());
      if (dynamic.contains(v)) removed.push_back(v);
    }
    const std::vector<Point> added = take_points(reader, what / 16);
    try {
      if (what % 3 == 0) dynamic.insert(added);
      if (what % 3 == 1) dynamic.remove(removed);
      if (what % 3 == 2) dynamic.replace(removed, added);
    } catch (const InputError&) {
      require(sorted_points(dynamic) == before, "what is refused changes nothing");
      continue;
    }
    if (dynamic.num_vertices() == 0) continue;
    const Triangulation frozen = canonical_order(dynamic.freeze().triangulation);
    const DelaunayReport report = check_delaunay(frozen);
    require(report.ok(), report.first_violation);
    const std::optional<Triangulation> fresh = triangulate(sorted_points(dynamic));
    require(fresh && fresh->cell_records() == frozen.cell_records(), "no history remains");
  }
}

}  // namespace cocoon::fuzz
