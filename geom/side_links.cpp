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
  OverwriteVector<ListedSide> sides;
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

// Rings of the sides between one smaller vertex at a time and larger ones.
class RingBuilder {
 public:
  RingBuilder(std::size_t num_vertices, SideLinks& links) : last_at_(num_vertices), links_(links) {}

  void begin_vertex(std::size_t v) { smaller_plus_1_ = static_cast<std::uint32_t>(v + 1); }
  // Puts the side into the ring behind the last one: by a mask and no branch on whether there is
  // one, since half of the guesses would be wrong.
  void append(VertexId larger, SideId side) {
    LastSide& last = last_at_[larger];
    const SideId is_met = last.smaller_plus_1 == smaller_plus_1_ ? 1U : 0U;
    const SideId previous = side ^ ((side ^ last.side) & (0U - is_met));
    links_[side] = side;
    links_[side] = links_[previous];
    links_[previous] = side;
    last = {smaller_plus_1_, side};
  }

 private:
  // The last side met between two vertices, kept with the larger one.
  struct LastSide {
    std::uint32_t smaller_plus_1;  // 0: none has been met
    SideId side;
  };

  ZeroedArray<VertexId, LastSide> last_at_;
  SideLinks& links_;
  std::uint32_t smaller_plus_1_ = 0;
};

// Calls link(begin, end) for ranges of all vertices. Every range has an array of the last sides, so
// there are no more than threads.
template <class Link>
void for_each_range(std::size_t num_vertices, const Execution& execution, const Link& link) {
  const auto ranges = static_cast<std::size_t>(thread_count(execution));
  parallel_chunks(execution, num_vertices, (num_vertices + ranges - 1) / ranges, link);
}

// The sides between each of the vertices begin .. end - 1 and larger ones.
void link_range(const SideLists& lists, std::size_t begin, std::size_t end, SideLinks& links) {
  RingBuilder rings(lists.begins.size() - 1, links);
  for (std::size_t v = begin; v < end; ++v) {
    rings.begin_vertex(v);
    for (std::size_t k = lists.begins[v]; k < lists.begins[v + 1]; ++k) {
      const auto [larger, side] = lists.sides[k];
      if (larger.index() == v) {
        links[side] = side;
      } else {
        rings.append(larger, side);
      }
    }
  }
}

// The sides opposite to the smallest corners; the others lie in the groups of the triangles.
SideLists list_opposite_sides(std::span<const Triangle> triangles, std::size_t num_vertices,
                              const Execution& execution) {
  SideLists lists;
  lists.begins = sort_by_vertex(
      triangles.size(), num_vertices, execution,
      [&](std::size_t count) {
        // Room for three times as many, most of which is never touched: of millions so large a
        // block goes back to the system when it is freed, and does not stay with the process while
        // its memory is at its peak.
        lists.sides.reserve(3 * count);
        lists.sides.resize(count);
      },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (std::size_t t = begin; t < end; ++t) {
          const std::size_t i = smallest_corner(triangles[t]);
          const VertexId from = triangles[t][next_corner(i)];
          const VertexId to = triangles[t][previous_corner(i)];
          put(std::min(from, to), [&](std::uint32_t place) {
            lists.sides[place] = {std::max(from, to), static_cast<SideId>(3 * t + i)};
          });
        }
      });
  return lists;
}

// The sides between each of the vertices begin .. end - 1 and larger ones. Those opposite to a
// smallest corner come first: they are of groups before, so the rings ascend.
void link_range(std::span<const Triangle> triangles, std::span<const std::uint32_t> begins,
                const SideLists& opposite, std::size_t begin, std::size_t end, SideLinks& links) {
  RingBuilder rings(begins.size() - 1, links);
  for (std::size_t v = begin; v < end; ++v) {
    rings.begin_vertex(v);
    for (std::size_t k = opposite.begins[v]; k < opposite.begins[v + 1]; ++k) {
      rings.append(opposite.sides[k].larger, opposite.sides[k].side);
    }
    for (std::size_t t = begins[v]; t < begins[v + 1]; ++t) {
      const std::size_t i = corner_at_vertex(triangles[t], VertexId(v));
      const std::size_t next = next_corner(i);
      const std::size_t previous = previous_corner(i);
      rings.append(triangles[t][next], static_cast<SideId>(3 * t + previous));
      rings.append(triangles[t][previous], static_cast<SideId>(3 * t + next));
    }
  }
}

}  // namespace

SideLinks side_links(std::span<const Triangle> triangles, std::size_t num_vertices,
                     const Execution& execution) {
  SideLinks links(3 * triangles.size());
  const SideLists lists = list_sides(triangles, num_vertices, execution);
  for_each_range(num_vertices, execution,
                 [&](std::size_t begin, std::size_t end) { link_range(lists, begin, end, links); });
  return links;
}

SideLinks side_links(std::span<const Triangle> triangles, std::span<const std::uint32_t> begins,
                     const Execution& execution) {
  const std::size_t num_vertices = begins.size() - 1;
  SideLinks links(3 * triangles.size());
  const SideLists opposite = list_opposite_sides(triangles, num_vertices, execution);
  for_each_range(num_vertices, execution, [&](std::size_t begin, std::size_t end) {
    link_range(triangles, begins, opposite, begin, end, links);
  });
  return links;
}

}  // namespace cocoon
