#include "update/trim_long_edges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/median.h"
#include "geom/mesh_adjacency.h"
#include "update/triangle_set.h"

namespace cocoon {

namespace {

// Where a slot is bridged, few vertices take most of the long edges: their median is long, too.
constexpr double lower_quartile = 0.25;

using EdgeSet = IdVector<EdgeId, std::uint8_t>;

// Numbers at the vertices of a mesh: one for a vertex itself and one for each of its edges.
class VertexNumbers {
 public:
  VertexNumbers(std::size_t vertices, const IdVector<EdgeId, std::array<VertexId, 2>>& edges)
      : begin_(vertices + 1, 0) {
    for (const auto& ends : edges) {
      for (const VertexId v : ends) ++begin_[v.index() + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v) begin_[v + 1] += begin_[v] + 1;
    numbers_.resize(begin_.back());
  }

  // Begins the lists anew, each with value(v).
  template <class Value>
  void start(const Value& value) {
    next_.assign(begin_.begin(), begin_.end() - 1);
    for (std::size_t v = 0; v < next_.size(); ++v) numbers_[next_[v]++] = value(VertexId(v));
  }
  void append(VertexId v, double number) { numbers_[next_[v.index()]++] = number; }

  std::span<double> with_own(std::size_t v) {
    return std::span(numbers_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }
  std::span<double> of_edges(std::size_t v) { return with_own(v).subspan(1); }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> next_;
  std::vector<double> numbers_;
};

// The local spacing at each vertex: the lower quartile of its edge lengths, smoothed to the median
// over the vertex and its neighbors, since two samples may lie close together by chance.
std::vector<double> local_spacing(const TriangleMesh& mesh, const MeshAdjacency& adjacency,
                                  const IdVector<EdgeId, double>& lengths) {
  const std::size_t n = mesh.points.size();
  VertexNumbers numbers(n, adjacency.edges);
  numbers.start([](VertexId) { return 0.0; });
  for (const EdgeId e : adjacency.edges.ids()) {
    for (const VertexId v : adjacency.edges[e]) numbers.append(v, lengths[e]);
  }
  std::vector<double> quartiles(n);
  for (std::size_t v = 0; v < n; ++v) {
    quartiles[v] = quantile_in_place(numbers.of_edges(v), lower_quartile);
  }
  numbers.start([&](VertexId v) { return quartiles[v.index()]; });
  for (const auto& [a, b] : adjacency.edges) {
    numbers.append(a, quartiles[b.index()]);
    numbers.append(b, quartiles[a.index()]);
  }
  std::vector<double> spacing(n);
  for (std::size_t v = 0; v < n; ++v) spacing[v] = quantile_in_place(numbers.with_own(v), 0.5);
  return spacing;
}

EdgeSet long_edges(const TriangleMesh& mesh, const MeshAdjacency& adjacency, double max_edge) {
  IdVector<EdgeId, double> lengths(adjacency.edges.size());
  for (const EdgeId e : adjacency.edges.ids()) {
    const auto [a, b] = adjacency.edges[e];
    lengths[e] = distance(mesh.points[a], mesh.points[b]);
  }
  const std::vector<double> spacing = local_spacing(mesh, adjacency, lengths);
  EdgeSet is_long(adjacency.edges.size(), 0);
  for (const EdgeId e : adjacency.edges.ids()) {
    const auto [a, b] = adjacency.edges[e];
    const double local = std::min(spacing[a.index()], spacing[b.index()]);
    is_long[e] = lengths[e] > max_edge * local ? 1 : 0;
  }
  return is_long;
}

bool has_long_edge(const MeshAdjacency& adjacency, const EdgeSet& is_long, TriangleId t) {
  for (int i = 0; i < 3; ++i) {
    const EdgeId e = adjacency.edge_of[halfedge_of(t, i)];
    if (!e.is_none() && is_long[e] != 0) return true;
  }
  return false;
}

// Marks the edge-connected clusters of triangles with a long edge; returns how many triangles.
std::size_t mark_clusters(const MeshAdjacency& adjacency, const EdgeSet& is_long,
                          std::size_t min_cluster, TriangleSet& removed) {
  std::size_t count = 0;
  TriangleSet seen(removed.size(), 0);
  for (const TriangleId seed : removed.ids()) {
    if (seen[seed] != 0 || !has_long_edge(adjacency, is_long, seed)) continue;
    std::vector<TriangleId> cluster(1, seed);
    seen[seed] = 1;
    for (std::size_t head = 0; head < cluster.size(); ++head) {
      for (const TriangleId next : adjacency.neighbors[cluster[head]]) {
        if (next.is_none() || seen[next] != 0 || !has_long_edge(adjacency, is_long, next)) continue;
        seen[next] = 1;
        cluster.push_back(next);
      }
    }
    if (cluster.size() < min_cluster) continue;
    for (const TriangleId t : cluster) removed[t] = 1;
    count += cluster.size();
  }
  return count;
}

// Marks triangles with a long edge at which no other triangle is left; returns how many.
std::size_t mark_from_rim(const MeshAdjacency& adjacency, const EdgeSet& is_long,
                          TriangleSet& removed) {
  IdVector<EdgeId, std::uint32_t> triangles_at(is_long.size(), 0);
  for (const TriangleId t : removed.ids()) {
    for (int i = 0; i < 3; ++i) {
      const EdgeId e = adjacency.edge_of[halfedge_of(t, i)];
      if (!e.is_none() && removed[t] == 0) ++triangles_at[e];
    }
  }
  std::vector<EdgeId> open;
  for (const EdgeId e : is_long.ids()) {
    if (is_long[e] != 0 && triangles_at[e] == 1) open.push_back(e);
  }
  std::size_t count = 0;
  while (!open.empty()) {
    const EdgeId edge = open.back();
    open.pop_back();
    for (const HalfedgeId side : adjacency.halfedges_at(edge)) {
      const TriangleId t = triangle_of(side);
      if (removed[t] != 0) continue;
      removed[t] = 1;
      ++count;
      for (int i = 0; i < 3; ++i) {
        const EdgeId e = adjacency.edge_of[halfedge_of(t, i)];
        if (!e.is_none() && --triangles_at[e] == 1 && is_long[e] != 0) open.push_back(e);
      }
    }
  }
  return count;
}

}  // namespace

TrimmedSurface trim_long_edges(const TriangleMesh& surface, const TrimOptions& options) {
  TrimmedSurface result;
  if (!(options.max_edge > 0)) {
    result.mesh = surface;
    result.adjacency = mesh_adjacency(surface);
    return result;
  }
  MeshAdjacency adjacency = mesh_adjacency(surface);
  const EdgeSet is_long = long_edges(surface, adjacency, options.max_edge);
  TriangleSet removed(surface.triangles.size(), 0);
  result.in_clusters = mark_clusters(adjacency, is_long, options.min_cluster, removed);
  result.at_rim = mark_from_rim(adjacency, is_long, removed);

  result.mesh.points = surface.points;
  result.mesh.triangles.reserve(surface.triangles.size());
  for (const TriangleId t : surface.triangles.ids()) {
    if (removed[t] == 0) result.mesh.triangles.push_back(surface.triangles[t]);
  }
  const bool trimmed = result.mesh.triangles.size() < surface.triangles.size();
  result.adjacency = trimmed ? mesh_adjacency(result.mesh) : std::move(adjacency);
  return result;
}

}  // namespace cocoon
