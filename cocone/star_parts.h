// The parts into which a surface between two sides divides the cells around a vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/id_vector.h"
#include "geom/zeroed_array.h"

namespace cocoon {

// Cells of a star are in one part if they hang together by facets at the vertex between cells of
// the same side, `out` = 0 or 1. One part: the vertex is not on the surface. Two: it is on one
// disk. More: disks meet there.
class StarParts {
 public:
  // Keeps references, which must outlive the object. O(1).
  StarParts(const Triangulation& triangulation, StarCache& stars,
            const IdVector<CellId, std::uint8_t>& out);

  // Complexity: O(star), with the star in one machine word if it has at most 64 cells.
  std::size_t count(VertexId v);
  // Each in no particular order. O(star).
  std::vector<std::vector<CellId>> list(VertexId v);

 private:
  using Word = std::uint64_t;
  static constexpr std::size_t word_size = 64;
  // Of a small star: bit k for the k-th cell.
  struct SmallStar {
    std::vector<Word> neighbors;  // across facets at the vertex, of each cell
    Word outside = 0;             // the sides that were counted last
    std::size_t parts = 0;        // 0: none yet
  };
  SmallStar& small_star(VertexId v);
  static std::size_t count_parts(SmallStar& star, Word outside);
  Word outside(VertexId v);
  static std::size_t count_in_word(const std::vector<Word>& neighbors, Word outside);
  template <class Visit>
  void for_each_part(VertexId v, Visit visit);
  void flood(VertexId v, CellId first);

  const Triangulation& triangulation_;
  StarCache& stars_;
  const IdVector<CellId, std::uint8_t>& out_;
  ZeroedArray<VertexId, std::uint32_t> place_;  // 1 + position in small_stars_
  std::deque<SmallStar> small_stars_;
  ZeroedArray<CellId, std::uint8_t> position_;  // in a star, while its links are found
  ZeroedArray<CellId, std::uint32_t> stamp_;
  std::uint32_t token_ = 0;
  std::vector<CellId> part_;
};

}  // namespace cocoon
