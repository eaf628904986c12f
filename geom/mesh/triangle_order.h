// The canonical order of triangles: each with its smallest vertex first, then lexicographic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/arrays/sort_by_vertex.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/mesh/halfedges.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Not above any triangle. (An id that is not set is `none`, above all others.)
constexpr Triangle lowest_triangle = {VertexId(0), VertexId(0), VertexId(0)};

// The same triangle with the same orientation, whatever vertex came first; of equal vertices the
// earlier one counts as smaller. Complexity: O(1).
constexpr Triangle smallest_first(const Triangle& t) {
  const std::size_t i = smallest_corner(t);
  return {t[i], t[next_corner(i)], t[previous_corner(i)]};
}

// a < b, by two words: a loop over the corners costs as much as all else where millions of
// triangles are merged.
constexpr bool precedes(const Triangle& a, const Triangle& b) {
  const auto edge = [](const Triangle& t) { return std::uint64_t{t[0].value} << 32 | t[1].value; };
  return edge(a) != edge(b) ? edge(a) < edge(b) : a[2] < b[2];
}

// Sorts the triangles begins[v] .. begins[v + 1] - 1 of each v. Complexity: O(triangles) for groups
// of a few, parallel.
void sort_groups(std::span<Triangle> triangles, std::span<const std::uint32_t> begins,
                 const Execution& execution = {});

// The triangles triangle(t) of t < count, with their smallest vertices first, in this order.
// Precondition: they name vertices below num_vertices. Complexity: O(count + num_vertices) for
// bounded valence, parallel: two calls for each t.
template <class TriangleOf>
IdVector<TriangleId, Triangle> canonical_triangles(std::size_t count, std::size_t num_vertices,
                                                   const TriangleOf& triangle,
                                                   const Execution& execution = {}) {
  // A counting sort by the first vertex leaves a few triangles each to sort.
  IdVector<TriangleId, Triangle> sorted;
  const std::vector<std::uint32_t> begins = sort_by_vertex<Triangle>(
      count, num_vertices, execution, [&](std::size_t n) { sorted.resize(n); },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (std::size_t t = begin; t < end; ++t) {
          const Triangle first = smallest_first(triangle(t));
          put(first[0], first);
        }
      },
      [&](std::uint32_t place) { __builtin_prefetch(&sorted[TriangleId(place)], 1); },
      [&](std::uint32_t place, const Triangle& t) { sorted[TriangleId(place)] = t; });
  sort_groups(sorted.span(), begins, execution);
  return sorted;
}

}  // namespace cocoon
