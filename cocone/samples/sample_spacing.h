// How far a sample is from the next ones, and which samples are strikingly far from theirs.
//
//   spacing   of a sample: root mean square of its shortest Delaunay edges
//   outlier   a sample whose spacing exceeds a multiple of the median of its neighbors'
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "delaunay/triangulation_view.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"

namespace cocoon {

// The finite Delaunay neighbors of v, each once, in no particular order; `star`: the cells at v.
// Complexity: O(star) expected.
void collect_neighbors(const TriangulationView& triangulation, std::span<const CellId> star,
                       VertexId v, std::vector<VertexId>& neighbors);

// From a sample to another one, with the square of its length.
struct ShortEdge {
  double square;
  VertexId to;
};
// Room for the work at one sample, to be used for the next.
using SpacingBuffer = std::vector<ShortEdge>;

// Of v, from the lengths of that many shortest edges (at least one). In units of the coordinates;
// infinite if the squares of all lengths are. Sums run in increasing order. Complexity: O(star),
// for few edges.
double sample_spacing(const TriangulationView& triangulation, std::span<const CellId> star,
                      VertexId v, std::size_t edges, SpacingBuffer& shortest);

// Whether a spacing exceeds `ratio` times the median of the neighbors' spacings, the upper one of
// two: whether more than half of them are too small. `spacing_of(w)` is asked for until that is
// clear. Precondition: there are neighbors. Complexity: O(neighbors).
template <class SpacingOf>
bool is_outlying(double spacing, double ratio, std::span<const VertexId> neighbors,
                 SpacingOf spacing_of) {
  const std::size_t enough = neighbors.size() - neighbors.size() / 2;
  std::size_t similar = 0;
  for (const VertexId w : neighbors) {
    if (spacing > ratio * spacing_of(w)) continue;
    if (++similar == enough) return false;
  }
  return true;
}

// Spacings of some vertices of a triangulation, computed when asked for, once, or ahead. Not to be
// shared by threads, but see prepare().
class SpacingCache {
 public:
  static constexpr std::size_t edges = 3;  // that make the spacing of a sample

  // Keeps references, which must outlive the object.
  SpacingCache(const Triangulation& triangulation, StarCache& stars)
      : triangulation_(triangulation), stars_(stars), spacing_(triangulation.num_vertices()) {}

  // Computes ahead what will be asked of these vertices, if they are so many that all stars are
  // listed (StarCache::expect); few are left until they are asked for. Whether they were so many:
  // then several threads may ask about these vertices. Complexity: O(stars), parallel.
  bool prepare(std::span<const VertexId> vertices, const Execution& execution);

  // Complexity: O(star) when first asked.
  double of(VertexId v);
  // The canonical order of samples, wherever the axes lie: smaller spacings first, of equal ones
  // the lexicographically smaller point. Complexity: as of().
  bool precedes(VertexId a, VertexId b);
  // Whether the spacing of v exceeds `ratio` times the median of its neighbors' spacings.
  // Complexity: O(stars of v and of its neighbors).
  bool is_outlier(VertexId v, double ratio);

 private:
  double compute(VertexId v, SpacingBuffer& shortest);

  const Triangulation& triangulation_;
  StarCache& stars_;
  ZeroedArray<VertexId, double> spacing_;  // 0: not yet asked for
  SpacingBuffer shortest_;
  std::vector<VertexId> around_;
};

}  // namespace cocoon
