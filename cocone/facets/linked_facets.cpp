#include "cocone/facets/linked_facets.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cocone/facets/corner_normals.h"
#include "geom/arrays/sort_by_vertex.h"
#include "geom/arrays/visit_where.h"
#include "geom/parallel/parallel_list.h"

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

// By a look at all of them. What is to be read at the other halfedge lies here and there in memory.
std::vector<Halfedge> find_steep_edges(const LinkedFacets& triangles, double largest_cosine,
                                       const Execution& execution) {
  const auto find = [&](std::size_t begin, std::size_t end, std::vector<Halfedge>& found) {
    const auto may_be_first = [&](Halfedge halfedge) {
      const Halfedge other = triangles.links[halfedge];
      __builtin_prefetch(&triangles.links[other]);
      __builtin_prefetch(&triangles.normals[triangle_of_halfedge(other)]);
      __builtin_prefetch(&triangles.corners[triangle_of_halfedge(other)]);
      return other >= halfedge;
    };
    const auto note_steep = [&](Halfedge halfedge) {
      if (is_steep(triangles, halfedge, largest_cosine) && triangles.is_first(halfedge)) {
        found.push_back(halfedge);
      }
    };
    visit_every_other(static_cast<Halfedge>(3 * begin), static_cast<Halfedge>(3 * end),
                      may_be_first, note_steep);
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
