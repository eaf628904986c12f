// The parts into which a surface between two sides divides the cells around a vertex.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/id_vector.h"

namespace cocoon {

// Cells of a star are in one part if they hang together by facets at the vertex between cells of
// the same side, `out` = 0 or 1. One part: the vertex is not on the surface. Two: it is on one
// disk. More: disks meet there.
class StarParts {
 public:
  // Keeps references, which must outlive the object. O(1).
  StarParts(const Triangulation& triangulation, StarCache& stars,
            IdVector<CellId, std::uint8_t>& out);

  // Complexity: O(star), with the star in one machine word if it has at most 64 cells.
  std::size_t count(VertexId v);
  // The same if these cells changed sides; they do not. There are `parts` now. For a large star a
  // look around each of the cells mostly tells: O(cells, and cells at their edges at v), else
  // O(star).
  std::size_t count_after(VertexId v, std::span<const CellId> cells, std::size_t parts);
  // More than 64 cells? O(1).
  bool is_large(VertexId v) { return stars_.star(v).size() > word_size; }
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
  // Of a large one: the positions of the cells across facets at the vertex, of each cell.
  using LargeStar = std::vector<std::array<std::uint32_t, 3>>;
  SmallStar& small_star(VertexId v);
  const LargeStar& large_star(VertexId v);
  static std::size_t count_parts(SmallStar& star, Word outside);
  Word outside(VertexId v);
  template <class Visit>
  static void for_each_part_in_word(const std::vector<Word>& neighbors, Word outside, Visit visit);
  template <class Visit>
  void for_each_part_of_large(VertexId v, Visit visit);
  void collect_part(const LargeStar& star, std::uint32_t first);
  std::optional<int> change_by(VertexId v, CellId c) const;
  bool is_fan_of_one_side(VertexId v, CellId c, int corner) const;

  const Triangulation& triangulation_;
  StarCache& stars_;
  IdVector<CellId, std::uint8_t>& out_;         // changed within count_after() only
  ZeroedArray<VertexId, std::uint32_t> place_;  // 1 + position in small_stars_ or large_stars_
  std::deque<SmallStar> small_stars_;
  std::deque<LargeStar> large_stars_;
  ZeroedArray<CellId, std::uint32_t> position_;  // in a star, while its links are found
  // Of the cells of the star that was asked about last: their sides, or that they are in a part.
  std::vector<std::uint8_t> sides_;
  std::vector<std::uint32_t> part_;  // positions
};

}  // namespace cocoon
