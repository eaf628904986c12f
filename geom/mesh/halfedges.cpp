#include "geom/mesh/halfedges.h"

#include <algorithm>
#include <cstddef>

#include "geom/arrays/sort_by_vertex.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/id_vector.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {
namespace {

// A halfedge by the larger of its vertices; it lies in the list of the smaller one.
struct ListedHalfedge {
  VertexId larger;
  Halfedge halfedge;
};

// Of each vertex the halfedges of which it is the smaller one, ascending.
struct HalfedgeLists {
  std::vector<std::uint32_t> begins;  // of each vertex, and the end
  OverwriteVector<ListedHalfedge> halfedges;
};

HalfedgeLists list_halfedges(std::span<const Triangle> triangles, std::size_t num_vertices,
                             const Execution& execution) {
  HalfedgeLists lists;
  lists.begins = sort_by_vertex(
      triangles.size(), num_vertices, execution,
      [&](std::size_t count) { lists.halfedges.resize(count); },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (std::size_t t = begin; t < end; ++t) {
          const auto& [a, b, c] = triangles[t];
          const auto first = static_cast<Halfedge>(3 * t);
          const auto put_halfedge = [&](Halfedge halfedge, VertexId from, VertexId to) {
            put(std::min(from, to), [&](std::uint32_t place) {
              lists.halfedges[place] = {std::max(from, to), halfedge};
            });
          };
          put_halfedge(first, b, c);
          put_halfedge(first + 1, c, a);
          put_halfedge(first + 2, a, b);
        }
      });
  return lists;
}

// Rings of the halfedges between one smaller vertex at a time and larger ones.
class RingBuilder {
 public:
  RingBuilder(std::size_t num_vertices, HalfedgeLinks& links)
      : last_at_(num_vertices), links_(links) {}

  void begin_vertex(std::size_t v) { smaller_plus_1_ = static_cast<std::uint32_t>(v + 1); }
  // Puts the halfedge into the ring behind the last one: by a mask and no branch on whether there
  // is one, since half of the guesses would be wrong.
  void append(VertexId larger, Halfedge halfedge) {
    LastHalfedge& last = last_at_[larger];
    const Halfedge is_met = last.smaller_plus_1 == smaller_plus_1_ ? 1U : 0U;
    const Halfedge previous = halfedge ^ ((halfedge ^ last.halfedge) & (0U - is_met));
    links_[halfedge] = halfedge;
    links_[halfedge] = links_[previous];
    links_[previous] = halfedge;
    last = {smaller_plus_1_, halfedge};
  }

 private:
  // The last halfedge met between two vertices, kept with the larger one.
  struct LastHalfedge {
    std::uint32_t smaller_plus_1;  // 0: none has been met
    Halfedge halfedge;
  };

  ZeroedArray<VertexId, LastHalfedge> last_at_;
  HalfedgeLinks& links_;
  std::uint32_t smaller_plus_1_ = 0;
};

// Calls link(begin, end) for ranges of all vertices. Every range has an array of the last
// halfedges, so there are no more than threads.
template <class Link>
void for_each_range(std::size_t num_vertices, const Execution& execution, const Link& link) {
  const auto ranges = static_cast<std::size_t>(thread_count(execution));
  parallel_chunks(execution, num_vertices, (num_vertices + ranges - 1) / ranges, link);
}

// The halfedges between each of the vertices begin .. end - 1 and larger ones.
void link_range(const HalfedgeLists& lists, std::size_t begin, std::size_t end,
                HalfedgeLinks& links) {
  RingBuilder rings(lists.begins.size() - 1, links);
  for (std::size_t v = begin; v < end; ++v) {
    rings.begin_vertex(v);
    for (std::size_t k = lists.begins[v]; k < lists.begins[v + 1]; ++k) {
      const auto [larger, halfedge] = lists.halfedges[k];
      if (larger.index() == v) {
        links[halfedge] = halfedge;
      } else {
        rings.append(larger, halfedge);
      }
    }
  }
}

// The halfedges opposite to the smallest corners; the others lie in the groups of the triangles.
HalfedgeLists list_opposite_halfedges(std::span<const Triangle> triangles, std::size_t num_vertices,
                                      const Execution& execution) {
  HalfedgeLists lists;
  lists.begins = sort_by_vertex(
      triangles.size(), num_vertices, execution,
      [&](std::size_t count) {
        // Room for three times as many, most of which is never touched: of millions so large a
        // block goes back to the system when it is freed, and does not stay with the process while
        // its memory is at its peak.
        lists.halfedges.reserve(3 * count);
        lists.halfedges.resize(count);
      },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (std::size_t t = begin; t < end; ++t) {
          const std::size_t i = smallest_corner(triangles[t]);
          const VertexId from = triangles[t][next_corner(i)];
          const VertexId to = triangles[t][previous_corner(i)];
          put(std::min(from, to), [&](std::uint32_t place) {
            lists.halfedges[place] = {std::max(from, to), static_cast<Halfedge>(3 * t + i)};
          });
        }
      });
  return lists;
}

// The halfedges between each of the vertices begin .. end - 1 and larger ones. Those opposite to a
// smallest corner come first: they are of groups before, so the rings ascend.
void link_range(std::span<const Triangle> triangles, std::span<const std::uint32_t> begins,
                const HalfedgeLists& opposite, std::size_t begin, std::size_t end,
                HalfedgeLinks& links) {
  RingBuilder rings(begins.size() - 1, links);
  for (std::size_t v = begin; v < end; ++v) {
    rings.begin_vertex(v);
    for (std::size_t k = opposite.begins[v]; k < opposite.begins[v + 1]; ++k) {
      rings.append(opposite.halfedges[k].larger, opposite.halfedges[k].halfedge);
    }
    for (std::size_t t = begins[v]; t < begins[v + 1]; ++t) {
      const std::size_t i = corner_at_vertex(triangles[t], VertexId(v));
      const std::size_t next = next_corner(i);
      const std::size_t previous = previous_corner(i);
      rings.append(triangles[t][next], static_cast<Halfedge>(3 * t + previous));
      rings.append(triangles[t][previous], static_cast<Halfedge>(3 * t + next));
    }
  }
}

// Where the triangles of each smallest vertex begin, and the end; empty if they are not grouped by
// it, or one repeats a vertex. Meshes of ours are grouped.
std::vector<std::uint32_t> begins_of_groups(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> begins(mesh.points.size() + 1, 0);
  std::size_t last = 0;
  for (const Triangle& triangle : mesh.triangles) {
    const std::size_t group = triangle[smallest_corner(triangle)].index();
    if (group < last || repeats_a_vertex(triangle)) return {};
    last = group;
    ++begins[group + 1];
  }
  for (std::size_t v = 1; v < begins.size(); ++v) begins[v] += begins[v - 1];
  return begins;
}

// The next halfedge on the edge whose triangle is not one of those: at last the given one.
Halfedge next_left(const HalfedgeLinks& links, Halfedge halfedge,
                   std::span<const std::uint8_t> removed) {
  Halfedge next = links[halfedge];
  while (removed[triangle_of_halfedge(next)] != 0) next = links[next];
  return next;
}

// Takes the halfedges of triangles that repeat a vertex out of their rings.
void unlink_repeating(const TriangleMesh& mesh, HalfedgeLinks& links) {
  std::vector<std::uint8_t> repeats(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    repeats[t.index()] = repeats_a_vertex(mesh.triangles[t]) ? 1 : 0;
  }
  for (Halfedge halfedge = 0; halfedge < links.size(); ++halfedge) {
    if (repeats[triangle_of_halfedge(halfedge)] == 0) {
      links[halfedge] = next_left(links, halfedge, repeats);
    }
  }
  for (Halfedge halfedge = 0; halfedge < links.size(); ++halfedge) {
    if (repeats[triangle_of_halfedge(halfedge)] != 0) links[halfedge] = no_halfedge;
  }
}

}  // namespace

HalfedgeLinks halfedge_links(std::span<const Triangle> triangles, std::size_t num_vertices,
                             const Execution& execution) {
  HalfedgeLinks links(3 * triangles.size());
  const HalfedgeLists lists = list_halfedges(triangles, num_vertices, execution);
  for_each_range(num_vertices, execution,
                 [&](std::size_t begin, std::size_t end) { link_range(lists, begin, end, links); });
  return links;
}

HalfedgeLinks halfedge_links(std::span<const Triangle> triangles,
                             std::span<const std::uint32_t> begins, const Execution& execution) {
  const std::size_t num_vertices = begins.size() - 1;
  HalfedgeLinks links(3 * triangles.size());
  const HalfedgeLists opposite = list_opposite_halfedges(triangles, num_vertices, execution);
  for_each_range(num_vertices, execution, [&](std::size_t begin, std::size_t end) {
    link_range(triangles, begins, opposite, begin, end, links);
  });
  return links;
}

HalfedgeRings link_halfedges(const TriangleMesh& mesh, const Execution& execution) {
  require_valid_triangles(mesh);
  if (const std::vector<std::uint32_t> begins = begins_of_groups(mesh); !begins.empty()) {
    return {halfedge_links(mesh.triangles.span(), begins, execution)};
  }
  HalfedgeRings rings{halfedge_links(mesh.triangles.span(), mesh.points.size(), execution)};
  unlink_repeating(mesh, rings.links);
  return rings;
}

bool is_balanced(const TriangleMesh& mesh, const HalfedgeRings& rings, const Execution& execution) {
  if (std::all_of(rings.links.begin(), rings.links.end(),
                  [](Halfedge link) { return link == no_halfedge; })) {
    return false;
  }
  const std::size_t count = rings.links.size();
  return count == first_failing(execution, count, [&](std::size_t k) {
           const auto halfedge = static_cast<Halfedge>(k);
           if (!rings.has_edge(halfedge) || !rings.is_last(halfedge)) return true;
           const VertexId from = ends_of_halfedge(mesh, halfedge)[0];
           std::ptrdiff_t excess = 0;
           for_each_at_edge(rings.links, halfedge, [&](Halfedge other) {
             excess += ends_of_halfedge(mesh, other)[0] == from ? 1 : -1;
           });
           return excess == 0;
         });
}

bool is_balanced(const TriangleMesh& mesh, const Execution& execution) {
  return is_balanced(mesh, link_halfedges(mesh, execution), execution);
}

HalfedgeRings link_rest(const HalfedgeRings& rings, std::span<const std::uint8_t> removed) {
  std::vector<std::uint32_t> number(removed.size());  // of the triangles that are left
  std::uint32_t count = 0;
  for (std::size_t t = 0; t < removed.size(); ++t) {
    number[t] = count;
    count += removed[t] == 0 ? 1U : 0U;
  }
  HalfedgeRings rest;
  rest.links.reserve(3 * std::size_t{count});
  for (Halfedge halfedge = 0; halfedge < rings.links.size(); ++halfedge) {
    if (removed[triangle_of_halfedge(halfedge)] != 0) continue;
    if (!rings.has_edge(halfedge)) {
      rest.links.push_back(no_halfedge);
      continue;
    }
    const Halfedge next = next_left(rings.links, halfedge, removed);
    rest.links.push_back(3 * number[triangle_of_halfedge(next)] + corner_of_halfedge(next));
  }
  return rest;
}

}  // namespace cocoon
