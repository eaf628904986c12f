#include "update/model/near_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

#include "geom/arrays/sort_ids.h"
#include "geom/arrays/visit_where.h"
#include "geom/triangle_projection.h"
#include "update/model/reached_cells.h"

namespace cocoon {

namespace {

// On which sides of the box a point lies, one bit for each: a triangle whose corners share a bit
// does not meet the box (Cohen and Sutherland's clipping).
std::uint8_t sides_of(const Box& box, const Point& p) {
  const int sides = (p.x < box.low.x ? 1 : 0) | (p.x > box.high.x ? 2 : 0) |
                    (p.y < box.low.y ? 4 : 0) | (p.y > box.high.y ? 8 : 0) |
                    (p.z < box.low.z ? 16 : 0) | (p.z > box.high.z ? 32 : 0);
  return static_cast<std::uint8_t>(sides);
}

std::vector<TriangleId> all_facets(const TriangleMesh& mesh) {
  std::vector<TriangleId> facets;
  facets.reserve(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) facets.push_back(t);
  return facets;
}

std::vector<TriangleId> facets_in(const ReachedCells& cells, const TriangleMesh& mesh) {
  std::vector<std::uint8_t> sides(mesh.points.size());
  for (const VertexId v : mesh.points.ids()) {
    sides[v.index()] = sides_of(cells.extent(), mesh.points[v]);
  }
  std::vector<TriangleId> facets;
  const auto may_meet = [&](std::size_t i) {
    const auto& [a, b, c] = mesh.triangles[TriangleId(i)];
    return (sides[a.index()] & sides[b.index()] & sides[c.index()]) == 0;
  };
  visit_where(mesh.triangles.size(), may_meet, [&](std::size_t i) {
    const TriangleId t(i);
    if (cells.overlap(box_of(corners_of(mesh, t)))) facets.push_back(t);
  });
  return facets;
}

// The corners of a triangle that reaches into a box lie no farther from it than its sides are long.
std::vector<TriangleId> facets_near(const ModelIndex& model, Points centers, double reach) {
  constexpr std::size_t share = 8;  // of all vertices: if more are near, a pass over facets is fast
  const TriangleMesh& mesh = model.mesh();
  if (centers.empty()) return {};
  const double room = reach_with_rounding(centers, reach);
  if (!std::isfinite(room)) return all_facets(mesh);
  const ReachedCells cells(centers, room);
  const double longest = model.longest_extent();
  if (!std::isfinite(longest)) return facets_in(cells, mesh);
  Box wide = cells.extent();
  wide.enlarge(longest + rounding_slack * std::max(longest, largest_coordinate(wide)));
  std::vector<VertexId> vertices;
  model.for_each_vertex_in(wide, [&](VertexId v) { vertices.push_back(v); });
  if (share * vertices.size() > mesh.points.size()) return facets_in(cells, mesh);
  std::vector<TriangleId> facets;
  for (const VertexId v : vertices) {
    model.for_each_triangle_at(v, [&](TriangleId t) { facets.push_back(t); });
  }
  make_set(facets);
  std::erase_if(facets, [&](TriangleId t) { return !cells.overlap(box_of(corners_of(mesh, t))); });
  return facets;
}

BoxTree tree_of(const TriangleMesh& mesh, const std::vector<TriangleId>& facets) {
  std::vector<Box> boxes;
  boxes.reserve(facets.size());
  Box all;
  for (const TriangleId t : facets) {
    boxes.push_back(box_of(corners_of(mesh, t)));
    all.include(boxes.back());
  }
  // A closest point computed on a triangle may lie outside its box by rounding.
  const double slack = facets.empty() ? 0 : rounding_slack * largest_coordinate(all);
  for (Box& box : boxes) box.enlarge(slack);
  return BoxTree(boxes);
}

}  // namespace

NearFacets::NearFacets(const ModelIndex& model, Points centers, double reach)
    : mesh_(&model.mesh()),
      reach_(reach),
      facets_(facets_near(model, centers, reach)),
      tree_(tree_of(*mesh_, facets_)) {}

void NearFacets::improve(const Point& p, TriangleId t, ClosestFacet& best) const {
  const auto own = sorted_corners(corners_of(*mesh_, t));
  const ClosestPoint foot = closest_point_on_triangle(p, own);
  const double squared = foot.squared_distance;
  if (squared > best.squared_distance) return;
  if (squared == best.squared_distance && !best.triangle.is_none()) {
    const auto others = sorted_corners(corners_of(*mesh_, best.triangle));
    if (own > others || (own == others && t > best.triangle)) return;
  }
  best = {t, foot.point, squared};
}

std::vector<ClosestFacet> closest_facets(const ModelIndex& model, Points points, double reach,
                                         const Execution& execution) {
  constexpr double farther = 8;
  constexpr int near_rounds = 3;
  constexpr std::size_t points_per_chunk = 64;
  std::vector<ClosestFacet> closest(points.size());
  std::vector<std::size_t> open(points.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  for (int round = 0; !open.empty(); ++round, reach *= farther) {
    if (round == near_rounds) reach = std::numeric_limits<double>::infinity();
    std::vector<Point> centers;
    centers.reserve(open.size());
    for (const std::size_t k : open) centers.push_back(points[k]);
    const NearFacets near(model, centers, reach);
    const auto find = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        closest[open[i]] = near.closest(centers[i], reach * reach);
      }
    };
    parallel_chunks(execution, open.size(), points_per_chunk, find);
    std::erase_if(open, [&](std::size_t k) { return !closest[k].triangle.is_none(); });
  }
  return closest;
}

}  // namespace cocoon
