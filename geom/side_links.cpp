#include "geom/side_links.h"

#include <algorithm>

#include "geom/id_vector.h"
#include "geom/zeroed_array.h"

namespace cocoon {
namespace {

// Calls visit(side, smaller vertex, larger one) for all sides.
template <class Visit>
void for_each_side(std::span<const Triangle> triangles, Visit visit) {
  SideId side = 0;
  for (const auto& [a, b, c] : triangles) {
    visit(side++, std::min(b, c), std::max(b, c));
    visit(side++, std::min(c, a), std::max(c, a));
    visit(side++, std::min(a, b), std::max(a, b));
  }
}

// A side by the larger of its vertices; it lies in the list of the smaller one.
struct ListedSide {
  VertexId larger;
  SideId side;
};

// Lists of the sides whose smaller vertex is one of begin .. end - 1, each ascending.
struct SideLists {
  std::vector<std::uint32_t> ends;  // of each vertex
  std::vector<ListedSide, OverwriteAllocator<ListedSide>> sides;
};

// By a counting sort.
SideLists list_sides(std::span<const Triangle> triangles, std::size_t begin, std::size_t end) {
  SideLists lists;
  lists.ends.assign(end - begin + 1, 0);
  std::vector<std::uint32_t>& places = lists.ends;
  // Vertices below the range wrap around to beyond its end.
  const auto is_listed = [&](VertexId smaller) { return smaller.index() - begin < end - begin; };
  for_each_side(triangles, [&](SideId, VertexId smaller, VertexId) {
    if (is_listed(smaller)) ++places[smaller.index() - begin + 1];
  });
  for (std::size_t v = 1; v < places.size(); ++v) places[v] += places[v - 1];
  lists.sides.resize(places.back());
  for_each_side(triangles, [&](SideId side, VertexId smaller, VertexId larger) {
    if (is_listed(smaller)) lists.sides[places[smaller.index() - begin]++] = {larger, side};
  });
  // Placing moved the begin of each list to its end.
  places.pop_back();
  return lists;
}

// The last side met between two vertices, kept with the larger one for one smaller one at a time.
struct LastSide {
  std::uint32_t smaller_plus_1;  // 0: none has been met
  SideId side;
};

void link_range(std::span<const Triangle> triangles, std::size_t begin, std::size_t end,
                std::size_t num_vertices, std::vector<SideId>& links) {
  const SideLists lists = list_sides(triangles, begin, end);
  ZeroedArray<VertexId, LastSide> last_at(num_vertices);
  std::size_t next = 0;
  for (std::size_t v = begin; v < end; ++v) {
    const auto smaller_plus_1 = static_cast<std::uint32_t>(v + 1);
    for (; next < lists.ends[v - begin]; ++next) {
      const auto [larger, side] = lists.sides[next];
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
  // Every range of vertices reads all triangles, so there are no more ranges than threads.
  const auto ranges = static_cast<std::size_t>(thread_count(execution));
  parallel_chunks(execution, num_vertices, (num_vertices + ranges - 1) / ranges,
                  [&](std::size_t begin, std::size_t end) {
                    link_range(triangles, begin, end, num_vertices, links);
                  });
  return links;
}

}  // namespace cocoon
