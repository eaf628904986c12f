#include "cocone/sample_spacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "delaunay/circulate.h"
#include "geom/sort_ids.h"

namespace cocoon {

namespace {

// Vertices met so far: open addressing, for so many that a quarter of it is filled at most.
class SmallVertexSet {
 public:
  static constexpr std::size_t most = 128;

  SmallVertexSet() { slots_.fill(none); }
  // False if it was there.
  bool insert(VertexId v) {
    std::size_t slot = (v.value * 0x9E3779B1U) >> (32 - bits);
    for (; slots_[slot] != none; slot = (slot + 1) % slots_.size()) {
      if (slots_[slot] == v.value) return false;
    }
    slots_[slot] = v.value;
    return true;
  }

 private:
  static constexpr std::size_t bits = 9;
  static constexpr std::uint32_t none = infinite_vertex.value;
  std::array<std::uint32_t, std::size_t{1} << bits> slots_;
};

}  // namespace

void collect_neighbors(const Triangulation& triangulation, std::span<const CellId> star, VertexId v,
                       std::vector<VertexId>& neighbors) {
  neighbors.clear();
  // The link of v is a sphere: it has two vertices more than half its triangles.
  const bool is_small = star.size() / 2 + 2 <= SmallVertexSet::most;
  SmallVertexSet met;
  for (const CellId c : star) {
    for (const VertexId w : triangulation.cell(c).vertices) {
      if (w == v || w == infinite_vertex) continue;
      if (!is_small || met.insert(w)) neighbors.push_back(w);
    }
  }
  if (!is_small) make_set(neighbors);
}

double sample_spacing(const Triangulation& triangulation, std::span<const CellId> star, VertexId v,
                      std::size_t edges, SpacingBuffer& shortest) {
  const std::size_t count = std::max<std::size_t>(1, edges);
  shortest.clear();  // from now on in increasing order
  const Point p = triangulation.point(v);
  for (const CellId c : star) {
    const Cell& cell = triangulation.cell(c);
    // Not by a branch on which vertex is v: that cannot be foreseen.
    const int* others = facet_corners[index_of_vertex(cell, v)];
    for (int i = 0; i < 3; ++i) {
      const VertexId w = cell.vertices[static_cast<std::size_t>(others[i])];
      if (w == infinite_vertex) continue;
      const double square = squared_distance(p, triangulation.point(w));
      if (shortest.size() == count && !(square < shortest.back().square)) continue;
      const auto is_same = [&](const ShortEdge& edge) { return edge.to == w; };
      if (std::any_of(shortest.begin(), shortest.end(), is_same)) continue;
      const auto is_longer = [&](const ShortEdge& edge) { return square < edge.square; };
      const auto place = std::find_if(shortest.begin(), shortest.end(), is_longer);
      shortest.insert(place, {square, w});
      if (shortest.size() > count) shortest.pop_back();
    }
  }
  double sum = 0;
  for (const ShortEdge& edge : shortest) sum += edge.square;
  return std::sqrt(sum / static_cast<double>(shortest.size()));
}

void SpacingCache::prepare(std::span<const VertexId> vertices, const Execution& execution) {
  if (!stars_.expect(vertices.size())) return;
  constexpr std::size_t vertices_per_chunk = 1024;
  parallel_chunks(
      execution, vertices.size(), vertices_per_chunk, [&](std::size_t begin, std::size_t end) {
        SpacingBuffer shortest;
        for (const VertexId v : vertices.subspan(begin, end - begin)) {
          spacing_[v] = sample_spacing(triangulation_, stars_.star(v), v, edges, shortest);
        }
      });
}

double SpacingCache::of(VertexId v) {
  if (spacing_[v] == 0) {
    spacing_[v] = sample_spacing(triangulation_, stars_.star(v), v, edges, shortest_);
  }
  return spacing_[v];
}

bool SpacingCache::is_outlier(VertexId v, double ratio) {
  collect_neighbors(triangulation_, stars_.star(v), v, around_);
  return is_outlying(of(v), ratio, around_, [&](VertexId w) { return of(w); });
}

}  // namespace cocoon
