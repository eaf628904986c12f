#include "cocone/samples/sample_spacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "delaunay/circulate.h"
#include "geom/arrays/sort_ids.h"

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

// Among the others, whose last goes, unless it is one of them: then it is met before a longer one.
void insert_edge(const ShortEdge& edge, SpacingBuffer& shortest) {
  auto place = shortest.begin();
  for (; place->square <= edge.square; ++place) {
    if (place->to == edge.to) return;
  }
  std::move_backward(place, shortest.end() - 1, shortest.end());
  *place = edge;
}

}  // namespace

void collect_neighbors(const TriangulationView& triangulation, std::span<const CellId> star,
                       VertexId v, std::vector<VertexId>& neighbors) {
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

double sample_spacing(const TriangulationView& triangulation, std::span<const CellId> star,
                      VertexId v, std::size_t edges, SpacingBuffer& shortest) {
  const std::size_t count = std::max<std::size_t>(1, edges);
  // In increasing order; as long as there are fewer, the rest is infinitely long.
  shortest.assign(count, {std::numeric_limits<double>::infinity(), infinite_vertex});
  const Point p = triangulation.point(v);
  for (const CellId c : star) {
    const Cell& cell = triangulation.cell(c);
    // Not by a branch on which vertex is v: that cannot be foreseen.
    const int* others = facet_corners[index_of_vertex(cell, v)];
    for (int i = 0; i < 3; ++i) {
      const VertexId w = cell.vertices[static_cast<std::size_t>(others[i])];
      if (w == infinite_vertex) continue;
      const double square = squared_distance(p, triangulation.point(w));
      if (square < shortest.back().square) insert_edge({square, w}, shortest);
    }
  }
  while (shortest.size() > 1 && shortest.back().to == infinite_vertex) shortest.pop_back();
  double sum = 0;
  for (const ShortEdge& edge : shortest) sum += edge.square;
  return std::sqrt(sum / static_cast<double>(shortest.size()));
}

bool SpacingCache::prepare(std::span<const VertexId> vertices, const Execution& execution) {
  if (!stars_.expect(vertices.size())) return false;
  constexpr std::size_t vertices_per_chunk = 1024;
  const auto vertex_at = [&](std::size_t k) { return vertices[k]; };
  parallel_chunks(execution, vertices.size(), vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    SpacingBuffer shortest;
                    visit_stars(triangulation_, stars_, begin, end, vertex_at, [&](std::size_t k) {
                      const VertexId v = vertices[k];
                      if (spacing_[v] == 0) spacing_[v] = compute(v, shortest);
                    });
                  });
  return true;
}

double SpacingCache::of(VertexId v) {
  if (spacing_[v] == 0) spacing_[v] = compute(v, shortest_);
  return spacing_[v];
}

// Zero, when squares underflow, would stand for one that was not asked for.
double SpacingCache::compute(VertexId v, SpacingBuffer& shortest) {
  return std::max(sample_spacing(triangulation_, stars_.star(v), v, edges, shortest),
                  std::numeric_limits<double>::denorm_min());
}

bool SpacingCache::precedes(VertexId a, VertexId b) {
  const double spacing_a = of(a);
  const double spacing_b = of(b);
  if (spacing_a != spacing_b) return spacing_a < spacing_b;
  return triangulation_.point(a) < triangulation_.point(b);
}

bool SpacingCache::is_outlier(VertexId v, double ratio) {
  collect_neighbors(triangulation_, stars_.star(v), v, around_);
  return is_outlying(of(v), ratio, around_, [&](VertexId w) { return of(w); });
}

}  // namespace cocoon
