// Facets of a changing triangulation at some of its vertices, linked around their edges.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "cocone/linked_facets.h"
#include "cocone/star_finder.h"
#include "delaunay/circulate.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// Triangles with vertices of their own, so that whatever a stage says of the triangles at a vertex
// it says here of the vertices in question as in the whole.
struct LocalFacets {
  LinkedFacets triangles;  // facets and mirrors: ids of the whole; corners: local; no set
  IdVector<VertexId, VertexId> vertex_in_whole;  // ascending

  std::size_t num_vertices() const { return vertex_in_whole.size(); }
  // None if no triangle has it. O(log vertices).
  VertexId local(VertexId in_whole) const;
};

class FacetCollector {
 public:
  // All facets that have a vertex among `vertices` and are in a set: bit i of bits(cell) for facet
  // i, equal from both sides. Complexity: O(cells at the vertices), and sorting the facets.
  template <class Bits>
  LocalFacets collect(const DynamicDelaunay& delaunay, std::span<const VertexId> vertices,
                      Bits bits) {
    facets_.clear();
    const TriangulationView view = delaunay.view();
    for (const VertexId v : vertices) {
      for (const CellId c : stars_.star(delaunay, v)) {
        const unsigned set = bits(c);
        if (set == 0) continue;
        const int opposite = index_of_vertex(view.cell(c), v);
        for (int i = 0; i < 4; ++i) {
          if (i == opposite || ((set >> i) & 1U) == 0) continue;
          facets_.push_back(view.canonical(facet_id(c, i)));
        }
      }
    }
    std::sort(facets_.begin(), facets_.end());
    facets_.erase(std::unique(facets_.begin(), facets_.end()), facets_.end());
    return link(delaunay);
  }

 private:
  LocalFacets link(const DynamicDelaunay& delaunay);

  StarFinder stars_;
  std::vector<FacetId> facets_;
  IdVector<VertexId, VertexId> vertex_here_;  // scratch by vertex
};

}  // namespace cocoon
