#include "geom/side_links.h"

#include <algorithm>

#include "geom/id_vector.h"
#include "geom/sort_by_vertex.h"
#include "geom/zeroed_array.h"

namespace cocoon {
namespace {

// A side by the larger of its vertices; it lies in the list of the smaller one.
struct ListedSide {
  VertexId larger;
  SideId side;
};

// Of each vertex the sides of which it is the smaller one, ascending.
struct SideLists {
  std::vector<std::uint32_t> begins;  // of each vertex, and the end
  std::vector<ListedSide, OverwriteAllocator<ListedSide>> sides;
};

SideLists list_sides(std::span<const Triangle> triangles, std::size_t num_vertices,
                     const Execution& execution) {
  SideLists lists;
  lists.begins = sort_by_vertex(
      triangles.size(), num_vertices, execution,
      [&](std::size_t count) { lists.sides.resize(count); },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (std::size_t t = begin; t < end; ++t) {
          const auto& [a, b, c] = triangles[t];
          const auto first = static_cast<SideId>(3 * t);
          const auto put_side = [&](SideId side, VertexId from, VertexId to) {
            put(std::min(from, to), [&](std::uint32_t place) {
              lists.sides[place] = {std::max(from, to), side};
            });
          };
          put_side(first, b, c);
          put_side(first + 1, c, a);
          put_side(first + 2, a, b);
        }
      });
  return lists;
}

// The last side met between two vertices, kept with the larger one for one smaller one at a time.
struct LastSide {
  std::uint32_t smaller_plus_1;  // 0: none has been met
  SideId side;
};

// The sides between each of the vertices begin .. end - 1 and larger ones.
void link_range(const SideLists& lists, std::size_t begin, std::size_t end,
                std::vector<SideId>& links) {
  const std::size_t num_vertices = lists.begins.size() - 1;
  ZeroedArray<VertexId, LastSide> last_at(num_vertices);
  for (std::size_t v = begin; v < end; ++v) {
    const auto smaller_plus_1 = static_cast<std::uint32_t>(v + 1);
    for (std::size_t k = lists.begins[v]; k < lists.begins[v + 1]; ++k) {
      const auto [larger, side] = lists.sides[k];
      links[side] = side;
      if (larger.index() == v) continue;
      // Puts the side into the ring behind the last one: no branch on whether there is one, since
      // half of the guesses would be wrong.
      LastSide& last = last_at[larger];
      const SideId previous = last.smaller_plus_1 == smaller_plus_1 ? last.side : side;
      links[side] = links[previous];
      links[previous] = side;
      last = {smaller_plus_1, side};
    }
  }
}

}  // namespace

std::vector<SideId> side_links(std::span<const Triangle> triangles, std::size_t num_vertices,
                               const Execution& execution) {
  std::vector<SideId> links(3 * triangles.size());
  const SideLists lists = list_sides(triangles, num_vertices, execution);
  // Every range of vertices has an array of the last sides, so there are no more than threads.
  const auto ranges = static_cast<std::size_t>(thread_count(execution));
  parallel_chunks(
      execution, num_vertices, (num_vertices + ranges - 1) / ranges,
      [&](std::size_t begin, std::size_t end) { link_range(lists, begin, end, links); });
  return links;
}

}  // namespace cocoon
