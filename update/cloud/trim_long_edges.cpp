#include "update/cloud/trim_long_edges.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/arrays/sort_ids.h"
#include "geom/mesh/triangles_at_vertices.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Where a slot is bridged, few vertices take most of the long edges: their median is long, too.
constexpr double lower_quartile = 0.25;

// One flag per halfedge, the same for all of an edge; one per triangle.
using HalfedgeFlags = std::vector<std::uint8_t>;
using TriangleFlags = std::vector<std::uint8_t>;

// The local spacing at vertices that are asked for: the lower quartile of the edge lengths,
// smoothed to the median over the vertex and its neighbors, since two samples may lie close
// together by chance.
class LocalSpacing {
 public:
  explicit LocalSpacing(const TriangleMesh& mesh)
      : mesh_(mesh),
        triangles_at_(triangles_at_vertices(mesh)),
        quartiles_(mesh.points.size(), unknown),
        spacings_(quartiles_) {}

  // Precondition: v has an edge.
  double at(VertexId v) {
    double& spacing = spacings_[v];
    if (spacing != unknown) return spacing;
    const std::vector<VertexId> around = neighbors(v);
    numbers_.assign(1, quartile(v, around));
    for (const VertexId w : around) numbers_.push_back(quartile(w));
    return spacing = quantile_in_place(numbers_, 0.5);
  }

 private:
  static constexpr double unknown = -1;

  double quartile(VertexId v) {
    return quartiles_[v] != unknown ? quartiles_[v] : quartile(v, neighbors(v));
  }

  double quartile(VertexId v, const std::vector<VertexId>& around) {
    std::vector<double> lengths;
    lengths.reserve(around.size());
    for (const VertexId w : around) lengths.push_back(distance(mesh_.points[v], mesh_.points[w]));
    return quartiles_[v] = quantile_in_place(lengths, lower_quartile);
  }

  // Each once: one for each edge.
  std::vector<VertexId> neighbors(VertexId v) const {
    std::vector<VertexId> found;
    for (const TriangleId t : triangles_at_[v]) {
      const Triangle& triangle = mesh_.triangles[t];
      if (repeats_a_vertex(triangle)) continue;
      for (const VertexId w : triangle) {
        if (w != v) found.push_back(w);
      }
    }
    make_set(found);
    return found;
  }

  const TriangleMesh& mesh_;
  TrianglesAtVertices triangles_at_;
  IdVector<VertexId, double> quartiles_;
  IdVector<VertexId, double> spacings_;
  std::vector<double> numbers_;
};

// Squared, of each halfedge.
std::vector<double> squared_lengths(const TriangleMesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    const Point& a = mesh.points[triangle[0]];
    const Point& b = mesh.points[triangle[1]];
    const Point& c = mesh.points[triangle[2]];
    lengths.push_back(squared_distance(b, c));
    lengths.push_back(squared_distance(c, a));
    lengths.push_back(squared_distance(a, b));
  }
  return lengths;
}

// At each vertex the square of a length that no local spacing is below: of the shortest edge that
// ends there or at a neighbor.
IdVector<VertexId, double> shortest_around(const TriangleMesh& mesh,
                                           std::span<const double> squared_lengths) {
  IdVector<VertexId, double> at(mesh.points.size(), std::numeric_limits<double>::infinity());
  for (const TriangleId t : mesh.triangles.ids()) {
    if (repeats_a_vertex(mesh.triangles[t])) continue;  // it has no edges
    const auto& [a, b, c] = mesh.triangles[t];
    const double bc = squared_lengths[halfedge_of(t, 0)];
    const double ca = squared_lengths[halfedge_of(t, 1)];
    const double ab = squared_lengths[halfedge_of(t, 2)];
    at[a] = std::min({at[a], ca, ab});
    at[b] = std::min({at[b], ab, bc});
    at[c] = std::min({at[c], bc, ca});
  }
  IdVector<VertexId, double> around = at;
  for (const Triangle& triangle : mesh.triangles) {
    if (repeats_a_vertex(triangle)) continue;
    const double least = std::min({at[triangle[0]], at[triangle[1]], at[triangle[2]]});
    for (const VertexId v : triangle) around[v] = std::min(around[v], least);
  }
  return around;
}

// All halfedges that are long, and some more.
std::vector<Halfedge> suspects(const TriangleMesh& mesh, double max_edge) {
  constexpr double less_than_rounding = 1 - 1e-9;
  const double limit = less_than_rounding * max_edge * max_edge;
  const std::vector<double> lengths = squared_lengths(mesh);
  const IdVector<VertexId, double> shortest = shortest_around(mesh, lengths);
  std::vector<Halfedge> found;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Triangle& triangle = mesh.triangles[t];
    if (repeats_a_vertex(triangle)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Halfedge halfedge = halfedge_of(t, i);
      const VertexId a = triangle[next_corner(i)];
      const VertexId b = triangle[previous_corner(i)];
      if (lengths[halfedge] > limit * std::min(shortest[a], shortest[b])) found.push_back(halfedge);
    }
  }
  return found;
}

// Empty if there are none. Only for what may be long is the spacing looked at.
HalfedgeFlags long_edges(const TriangleMesh& mesh, double max_edge) {
  const std::vector<Halfedge> halfedges = suspects(mesh, max_edge);
  if (halfedges.empty()) return {};
  LocalSpacing spacing(mesh);
  HalfedgeFlags is_long(3 * mesh.triangles.size(), 0);
  bool any = false;
  for (const Halfedge halfedge : halfedges) {
    const auto [a, b] = ends_of_halfedge(mesh, halfedge);
    const double length = distance(mesh.points[a], mesh.points[b]);
    if (!(length > max_edge * std::min(spacing.at(a), spacing.at(b)))) continue;
    is_long[halfedge] = 1;
    any = true;
  }
  return any ? is_long : HalfedgeFlags{};
}

bool has_long_edge(const HalfedgeFlags& is_long, std::uint32_t t) {
  return (is_long[3 * t] | is_long[3 * t + 1] | is_long[3 * t + 2]) != 0;
}

// Marks the edge-connected clusters of triangles with a long edge; returns how many triangles.
std::size_t mark_clusters(const HalfedgeRings& rings, const HalfedgeFlags& is_long,
                          std::size_t min_cluster, TriangleFlags& removed) {
  std::size_t count = 0;
  TriangleFlags seen(removed.size(), 0);
  for (std::uint32_t seed = 0; seed < removed.size(); ++seed) {
    if (seen[seed] != 0 || !has_long_edge(is_long, seed)) continue;
    std::vector<std::uint32_t> cluster(1, seed);
    seen[seed] = 1;
    for (std::size_t head = 0; head < cluster.size(); ++head) {
      const Halfedge first = 3 * cluster[head];
      for (Halfedge halfedge = first; halfedge < first + 3; ++halfedge) {
        if (!rings.has_two_triangles(halfedge)) continue;
        const std::uint32_t next = triangle_of_halfedge(rings.links[halfedge]);
        if (seen[next] != 0 || !has_long_edge(is_long, next)) continue;
        seen[next] = 1;
        cluster.push_back(next);
      }
    }
    if (cluster.size() < min_cluster) continue;
    for (const std::uint32_t t : cluster) removed[t] = 1;
    count += cluster.size();
  }
  return count;
}

// The one triangle that is left at an edge; a number that is none if there is none or several.
std::uint32_t last_triangle_at(const HalfedgeRings& rings, Halfedge halfedge,
                               const TriangleFlags& removed) {
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  std::uint32_t found = none;
  std::size_t count = 0;
  for_each_at_edge(rings.links, halfedge, [&](Halfedge other) {
    if (removed[triangle_of_halfedge(other)] != 0) return;
    found = triangle_of_halfedge(other);
    ++count;
  });
  return count == 1 ? found : none;
}

// Marks triangles with a long edge at which no other triangle is left; returns how many.
std::size_t mark_from_rim(const HalfedgeRings& rings, const HalfedgeFlags& is_long,
                          TriangleFlags& removed) {
  std::vector<Halfedge> open;
  for (Halfedge halfedge = 0; halfedge < is_long.size(); ++halfedge) {
    if (is_long[halfedge] != 0) open.push_back(halfedge);
  }
  std::size_t count = 0;
  while (!open.empty()) {
    const std::uint32_t t = last_triangle_at(rings, open.back(), removed);
    open.pop_back();
    if (t >= removed.size()) continue;
    removed[t] = 1;
    ++count;
    for (Halfedge halfedge = 3 * t; halfedge < 3 * t + 3; ++halfedge) {
      if (is_long[halfedge] != 0) open.push_back(halfedge);
    }
  }
  return count;
}

}  // namespace

TrimmedSurface trim_long_edges(TriangleMesh surface, const TrimOptions& options) {
  require_options("trim_long_edges", options);
  TrimmedSurface result;
  HalfedgeRings rings = link_halfedges(surface);
  const HalfedgeFlags is_long =
      options.max_edge > 0 ? long_edges(surface, options.max_edge) : HalfedgeFlags{};
  if (is_long.empty()) {
    result.mesh = std::move(surface);
    result.rings = std::move(rings);
    return result;
  }
  TriangleFlags removed(surface.triangles.size(), 0);
  result.in_clusters = mark_clusters(rings, is_long, options.min_cluster, removed);
  result.at_rim = mark_from_rim(rings, is_long, removed);

  result.mesh.points = std::move(surface.points);
  result.mesh.triangles.reserve(surface.triangles.size());
  for (const TriangleId t : surface.triangles.ids()) {
    if (removed[t.index()] == 0) result.mesh.triangles.push_back(surface.triangles[t]);
  }
  result.rings = link_rest(rings, removed);
  return result;
}

}  // namespace cocoon
