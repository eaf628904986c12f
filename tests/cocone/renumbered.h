// Triangulations on other numbers. Vertices are numbered along a curve through space, whatever the
// order of the input: shuffled points alone do not tell whether a stage decides by numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/random/random.h"

namespace cocoon {
namespace renumbering {

// Of begin .. end - 1; numbers outside stay.
inline void shuffle(std::size_t begin, std::size_t end, Random& random,
                    std::vector<std::size_t>& numbers) {
  for (std::size_t k = end; k > begin + 1; --k) {
    std::swap(numbers[k - 1], numbers[begin + random.below(k - begin)]);
  }
}

inline std::vector<std::size_t> shuffled_numbers(std::size_t count, std::size_t first_part,
                                                 Random& random) {
  std::vector<std::size_t> numbers(count);
  for (std::size_t k = 0; k < count; ++k) numbers[k] = k;
  shuffle(0, first_part, random, numbers);
  shuffle(first_part, count, random, numbers);
  return numbers;
}

// Places of the corners of a cell that leave its orientation, and infinity in the last one.
inline std::array<std::size_t, 4> turned_corners(bool is_infinite, Random& random) {
  std::array<std::size_t, 4> places{0, 1, 2, 3};
  const std::size_t by = random.below(3);
  for (std::size_t k = 0; k < 3; ++k) places[k] = (k + by) % 3;
  if (is_infinite || random.below(2) == 0) return places;
  std::swap(places[0], places[3]);
  std::swap(places[1], places[2]);
  return places;
}

}  // namespace renumbering

// The same cells with other numbers of vertices and cells, and other orders of their corners.
inline Triangulation renumbered(Triangulation triangulation, std::uint64_t seed) {
  const std::size_t finite = triangulation.num_finite_cells();
  const TriangulationArrays old = std::move(triangulation).release();
  Random random(seed);
  const std::size_t count = old.points.size();
  const auto vertex = renumbering::shuffled_numbers(count, count, random);
  const auto cell = renumbering::shuffled_numbers(old.cells.size(), finite, random);
  std::vector<std::array<std::size_t, 4>> places;
  for (const CellId c : old.cells.ids()) {
    places.push_back(renumbering::turned_corners(c.index() >= finite, random));
  }
  TriangulationArrays arrays = old;
  for (const VertexId v : old.points.ids())
    arrays.points[VertexId(vertex[v.index()])] = old.points[v];
  for (VertexId& v : arrays.vertex_of_point) v = VertexId(vertex[v.index()]);
  for (const CellId c : old.cells.ids()) {
    Cell& record = arrays.cells[CellId(cell[c.index()])];
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId v = old.cells[c].vertices[i];
      const FacetId behind = old.cells[c].neighbors[i];
      const std::size_t there = cell_of(behind).index();
      const std::size_t place = places[c.index()][i];
      record.vertices[place] = v == infinite_vertex ? v : VertexId(vertex[v.index()]);
      record.neighbors[place] =
          facet_id(CellId(cell[there]),
                   static_cast<int>(places[there][static_cast<std::size_t>(index_of(behind))]));
    }
  }
  return Triangulation(std::move(arrays), finite);
}

}  // namespace cocoon
