#include "cocone/linked_facets.h"

#include <algorithm>
#include <span>
#include <utility>

#include "geom/parallel_list.h"
#include "geom/sort_by_vertex.h"

namespace cocoon {
namespace {

constexpr std::size_t triangles_per_chunk = 2048;

// Which is nearly always told by x: a branch that is foreseen, and none on the answer.
bool precedes(const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a < b; }

// How three corners are put in order, by the answers to 0 < 1, 1 < 2 and 0 < 2.
struct CornerOrder {
  std::array<std::uint8_t, 3> corners;
  bool turned;
};
constexpr std::array<CornerOrder, 8> corner_orders = {{{{2, 1, 0}, true},
                                                       {{2, 0, 1}, false},
                                                       {{1, 2, 0}, false},
                                                       {{}, false},
                                                       {{}, false},
                                                       {{0, 2, 1}, true},
                                                       {{1, 0, 2}, true},
                                                       {{0, 1, 2}, false}}};

// The unit normal of the corners in lexicographic order, turned as the corners run.
Vec3 oriented_normal(const IdVector<VertexId, Point>& points, const Triangle& corners) {
  const std::array<const Point*, 3> p = {&points[corners[0]], &points[corners[1]],
                                         &points[corners[2]]};
  const unsigned answers = (precedes(*p[0], *p[1]) ? 1U : 0U) | (precedes(*p[1], *p[2]) ? 2U : 0U) |
                           (precedes(*p[0], *p[2]) ? 4U : 0U);
  const CornerOrder& order = corner_orders[answers];
  const Point& first = *p[order.corners[0]];
  const Vec3 normal = unit(cross(*p[order.corners[1]] - first, *p[order.corners[2]] - first));
  const double sign = order.turned ? -1.0 : 1.0;
  return sign * normal;
}

VertexId smallest(const Triangle& corners) {
  return std::min({corners[0], corners[1], corners[2]});
}

struct FoundFacet {
  FacetId facet;
  VertexId smallest;
};

std::vector<FoundFacet> list_facets(const Triangulation& triangulation, const FacetSet& facets,
                                    const Execution& execution) {
  constexpr std::size_t cells_per_chunk = 8192;
  return parallel_list<FoundFacet>(
      execution, triangulation.num_cells(), cells_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<FoundFacet>& found) {
        facets.for_each(triangulation, begin, end, [&](FacetId f) {
          found.push_back({f, smallest(triangulation.facet_vertices(f))});
        });
      });
}

// Facets, mirrors and corners.
LinkedFacets by_smallest_vertex(const Triangulation& triangulation, const FacetSet& facets,
                                const Execution& execution) {
  const std::vector<FoundFacet> found = list_facets(triangulation, facets, execution);
  LinkedFacets triangles;
  const auto allocate = [&](std::size_t count) {
    triangles.facets.resize(count);
    triangles.mirrors.resize(count);
    triangles.corners.resize(count);
  };
  const auto for_each_found = [&](std::size_t begin, std::size_t end, auto put) {
    for (const FoundFacet& f : std::span(found).subspan(begin, end - begin)) {
      put(f.smallest, [&](std::uint32_t t) {
        triangles.facets[t] = f.facet;
        triangles.mirrors[t] = triangulation.mirror(f.facet);
        triangles.corners[t] = triangulation.facet_vertices(f.facet);
      });
    }
  };
  sort_by_vertex(found.size(), triangulation.num_vertices(), execution, allocate, for_each_found);
  return triangles;
}

// The side whose link leads to this one.
SideId side_before(const LinkedFacets& triangles, SideId side) {
  SideId before = side;
  while (triangles.links[before] != side) before = triangles.links[before];
  return before;
}

// To a place whose triangle is gone.
void move_triangle(LinkedFacets& triangles, std::uint32_t from, std::uint32_t to) {
  triangles.facets[to] = triangles.facets[from];
  triangles.mirrors[to] = triangles.mirrors[from];
  triangles.corners[to] = triangles.corners[from];
  triangles.normals[to] = triangles.normals[from];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const SideId before = side_before(triangles, 3 * from + i);
    triangles.links[3 * to + i] = triangles.links[3 * from + i];
    triangles.links[before == 3 * from + i ? 3 * to + i : before] = 3 * to + i;
  }
}

}  // namespace

void link_corners(const IdVector<VertexId, Point>& points, LinkedFacets& triangles,
                  const Execution& execution) {
  // First: its scratch memory is as large as the normals.
  triangles.links = side_links(triangles.corners, points.size(), execution);
  triangles.normals.resize(triangles.size());
  parallel_chunks(execution, triangles.size(), triangles_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t t = begin; t < end; ++t) {
                      triangles.normals[t] = oriented_normal(points, triangles.corners[t]);
                    }
                  });
}

LinkedFacets link_facets(const Triangulation& triangulation, FacetSet facets,
                         const Execution& execution) {
  LinkedFacets triangles = by_smallest_vertex(triangulation, facets, execution);
  link_corners(triangulation.points(), triangles, execution);
  triangles.set = std::move(facets);
  return triangles;
}

std::vector<TriangleMove> moves_into_places(const std::vector<std::uint8_t>& removed) {
  std::vector<TriangleMove> moves;
  auto end = static_cast<std::uint32_t>(removed.size());
  for (std::uint32_t hole = 0; hole < end; ++hole) {
    if (removed[hole] == 0) continue;
    do {
      --end;
    } while (removed[end] != 0 && end > hole);
    if (end > hole) moves.push_back({end, hole});
  }
  return moves;
}

LinkedFacets without(const Triangulation& triangulation, LinkedFacets triangles,
                     const std::vector<std::uint8_t>& removed) {
  const auto size = static_cast<std::uint32_t>(triangles.size());
  for (std::uint32_t t = 0; t < size; ++t) {
    if (removed[t] == 0) continue;
    triangles.set.erase(triangulation, triangles.facets[t]);
    for (SideId side = 3 * t; side < 3 * t + 3; ++side) {
      triangles.links[side_before(triangles, side)] = triangles.links[side];
    }
  }
  const std::vector<TriangleMove> moves = moves_into_places(removed);
  for (const auto& [from, to] : moves) move_triangle(triangles, from, to);
  const auto end = static_cast<std::size_t>(std::count(removed.begin(), removed.end(), 0));
  triangles.facets.resize(end);
  triangles.mirrors.resize(end);
  triangles.corners.resize(end);
  triangles.normals.resize(end);
  triangles.links.resize(3 * end);
  return triangles;
}

std::vector<SideId> steep_edges(const LinkedFacets& triangles, double largest_cosine,
                                const Execution& execution) {
  return parallel_list<SideId>(execution, triangles.size(), triangles_per_chunk,
                               [&](std::size_t begin, std::size_t end, std::vector<SideId>& found) {
                                 for_each_edge(triangles, begin, end, [&](SideId side) {
                                   const bool flat =
                                       triangles.is_two_sided(side) &&
                                       dihedral_cosine(triangles, side, triangles.links[side]) <=
                                           largest_cosine;
                                   if (!flat) found.push_back(side);
                                 });
                               });
}

}  // namespace cocoon
