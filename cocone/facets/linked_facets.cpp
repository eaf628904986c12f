#include "cocone/facets/linked_facets.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "cocone/facets/corner_normals.h"
#include "geom/parallel_list.h"
#include "geom/sort_by_vertex.h"

namespace cocoon {
namespace {

constexpr std::size_t triangles_per_chunk = 2048;

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

// Puts facets, mirrors and corners in order, and returns where the triangles of each smallest
// vertex begin. Of the k-th facet: the smallest vertex; then its id and corners.
template <class SmallestOf, class FacetOf, class CornersOf>
std::vector<std::uint32_t> sort_facets(const Triangulation& triangulation, std::size_t count,
                                       SmallestOf smallest_of, FacetOf facet_of,
                                       CornersOf corners_of, LinkedFacets& triangles,
                                       const Execution& execution) {
  return sort_by_vertex<std::uint32_t>(
      count, triangulation.num_vertices(), execution,
      [&](std::size_t) {
        triangles.facets.resize(count);
        triangles.mirrors.resize(count);
        triangles.corners.resize(count);
      },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (std::size_t k = begin; k < end; ++k) {
          put(smallest_of(k), static_cast<std::uint32_t>(k));
        }
      },
      [&](std::uint32_t t) {
        __builtin_prefetch(&triangles.facets[t], 1);
        __builtin_prefetch(&triangles.mirrors[t], 1);
        __builtin_prefetch(&triangles.corners[t], 1);
      },
      [&](std::uint32_t t, std::uint32_t k) {
        const FacetId f = facet_of(k);
        triangles.facets[t] = f;
        triangles.mirrors[t] = triangulation.mirror(f);
        triangles.corners[t] = corners_of(k);
      });
}

void find_normals(const IdVector<VertexId, Point>& points, LinkedFacets& triangles,
                  const Execution& execution) {
  triangles.normals.resize(triangles.size());
  parallel_chunks(execution, triangles.size(), triangles_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    corner_normals(points, triangles.corners, begin, end, triangles.normals);
                  });
}

// By a look at all of them. Which of two halfedges is the first cannot be foreseen: they are listed
// without a branch on it. What is to be read at the other one lies here and there in memory: it is
// asked for in advance.
std::vector<Halfedge> find_steep_edges(const LinkedFacets& triangles, double largest_cosine,
                                       const Execution& execution) {
  constexpr std::size_t halfedges_per_block = 96;
  const auto find = [&](std::size_t begin, std::size_t end, std::vector<Halfedge>& found) {
    std::array<Halfedge, halfedges_per_block> halfedges;
    const auto last = static_cast<Halfedge>(3 * end);
    for (auto first = static_cast<Halfedge>(3 * begin); first < last;) {
      const Halfedge next = std::min<Halfedge>(first + halfedges_per_block, last);
      std::size_t count = 0;
      for (; first < next; ++first) {
        const Halfedge other = triangles.links[first];
        halfedges[count] = first;
        count += other >= first ? 1U : 0U;
        __builtin_prefetch(&triangles.links[other]);
        __builtin_prefetch(&triangles.normals[triangle_of_halfedge(other)]);
        __builtin_prefetch(&triangles.corners[triangle_of_halfedge(other)]);
      }
      for (std::size_t k = 0; k < count; ++k) {
        const Halfedge halfedge = halfedges[k];
        if (is_steep(triangles, halfedge, largest_cosine) && triangles.is_first(halfedge)) {
          found.push_back(halfedge);
        }
      }
    }
  };
  return parallel_list<Halfedge>(execution, triangles.size(), triangles_per_chunk, find);
}

LinkedFacets finish_links(const Triangulation& triangulation, LinkedFacets triangles,
                          std::vector<std::uint32_t> begins, const Execution& execution) {
  // First: its scratch memory is as large as the normals.
  triangles.links = halfedge_links(triangles.corners, begins, execution);
  // Not {}, which would keep the memory: it is short while links and normals come.
  begins = std::vector<std::uint32_t>();
  find_normals(triangulation.points(), triangles, execution);
  triangles.steep = find_steep_edges(triangles, LinkedFacets::steep_cosine, execution);
  return triangles;
}

// The halfedge whose link leads to this one.
Halfedge halfedge_before(const LinkedFacets& triangles, Halfedge halfedge) {
  Halfedge before = halfedge;
  while (triangles.links[before] != halfedge) before = triangles.links[before];
  return before;
}

// To a place whose triangle is gone.
void move_triangle(LinkedFacets& triangles, std::uint32_t from, std::uint32_t to) {
  triangles.facets[to] = triangles.facets[from];
  triangles.mirrors[to] = triangles.mirrors[from];
  triangles.corners[to] = triangles.corners[from];
  triangles.normals[to] = triangles.normals[from];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Halfedge before = halfedge_before(triangles, 3 * from + i);
    triangles.links[3 * to + i] = triangles.links[3 * from + i];
    triangles.links[before == 3 * from + i ? 3 * to + i : before] = 3 * to + i;
  }
}

// The halfedges, some of whose triangles have moved to places before `end`.
std::vector<Halfedge> moved(std::vector<Halfedge> halfedges, const std::vector<TriangleMove>& moves,
                            std::size_t end, std::size_t size) {
  std::vector<std::uint32_t> places(size - end);
  for (const auto& [from, to] : moves) places[from - end] = to;
  for (Halfedge& halfedge : halfedges) {
    const std::uint32_t t = triangle_of_halfedge(halfedge);
    if (t >= end) halfedge = 3 * places[t - end] + corner_of_halfedge(halfedge);
  }
  return halfedges;
}

// The steep ones of the edges with one of these halfedges.
std::vector<Halfedge> steep_among(const LinkedFacets& triangles, std::vector<Halfedge> halfedges) {
  for (Halfedge& halfedge : halfedges) halfedge = first_at_edge(triangles.links, halfedge);
  std::sort(halfedges.begin(), halfedges.end());
  halfedges.erase(std::unique(halfedges.begin(), halfedges.end()), halfedges.end());
  std::erase_if(halfedges, [&](Halfedge halfedge) {
    return !is_steep(triangles, halfedge, LinkedFacets::steep_cosine);
  });
  return halfedges;
}

}  // namespace

void link_corners(const IdVector<VertexId, Point>& points, LinkedFacets& triangles,
                  const Execution& execution) {
  triangles.links = halfedge_links(triangles.corners, points.size(), execution);
  find_normals(points, triangles, execution);
  triangles.steep = find_steep_edges(triangles, LinkedFacets::steep_cosine, execution);
}

LinkedFacets link_facets(const Triangulation& triangulation, FacetSet facets,
                         const Execution& execution) {
  LinkedFacets triangles;
  triangles.set = std::move(facets);
  std::vector<FoundFacet> found = list_facets(triangulation, triangles.set, execution);
  std::vector<std::uint32_t> begins = sort_facets(
      triangulation, found.size(), [&](std::size_t k) { return found[k].smallest; },
      [&](std::size_t k) { return found[k].facet; },
      [&](std::size_t k) { return triangulation.facet_vertices(found[k].facet); }, triangles,
      execution);
  found = std::vector<FoundFacet>();
  return finish_links(triangulation, std::move(triangles), std::move(begins), execution);
}

LinkedFacets link_facets(const Triangulation& triangulation, CandidateTriangles candidates,
                         const Execution& execution) {
  LinkedFacets triangles;
  triangles.set = std::move(candidates.set);
  std::vector<std::uint32_t> begins = sort_facets(
      triangulation, candidates.facets.size(),
      [&](std::size_t k) { return smallest(candidates.corners[k]); },
      [&](std::size_t k) { return candidates.facets[k]; },
      [&](std::size_t k) { return candidates.corners[k]; }, triangles, execution);
  candidates = CandidateTriangles();
  return finish_links(triangulation, std::move(triangles), std::move(begins), execution);
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
  std::vector<Halfedge> doubtful = std::move(triangles.steep);  // at edges that may be steep
  for (std::uint32_t t = 0; t < size; ++t) {
    if (removed[t] == 0) continue;
    triangles.set.erase(triangulation, triangles.facets[t]);
    for (Halfedge halfedge = 3 * t; halfedge < 3 * t + 3; ++halfedge) {
      const Halfedge before = halfedge_before(triangles, halfedge);
      triangles.links[before] = triangles.links[halfedge];
      doubtful.push_back(before);
    }
  }
  std::erase_if(doubtful,
                [&](Halfedge halfedge) { return removed[triangle_of_halfedge(halfedge)] != 0; });
  const std::vector<TriangleMove> moves = moves_into_places(removed);
  for (const auto& [from, to] : moves) move_triangle(triangles, from, to);
  const auto end = static_cast<std::size_t>(std::count(removed.begin(), removed.end(), 0));
  triangles.steep = steep_among(triangles, moved(std::move(doubtful), moves, end, size));
  triangles.facets.resize(end);
  triangles.mirrors.resize(end);
  triangles.corners.resize(end);
  triangles.normals.resize(end);
  triangles.links.resize(3 * end);
  return triangles;
}

std::vector<Halfedge> steep_edges(const LinkedFacets& triangles, double largest_cosine,
                                  const Execution& execution) {
  if (largest_cosine < LinkedFacets::steep_cosine) {
    return find_steep_edges(triangles, largest_cosine, execution);
  }
  std::vector<Halfedge> steep;
  std::copy_if(triangles.steep.begin(), triangles.steep.end(), std::back_inserter(steep),
               [&](Halfedge halfedge) { return is_steep(triangles, halfedge, largest_cosine); });
  return steep;
}

}  // namespace cocoon
