// Facets of a changing triangulation at some of its vertices, linked around their edges.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cocone/facets/linked_facets.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/star_finder.h"
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
    const TriangulationView view = delaunay.view();
    in_list_.resize(delaunay.num_vertex_slots(), 0);
    for (const VertexId v : vertices) in_list_[v] = 1;
    std::vector<FacetId> facets;
    for (const CellId c : stars_.stars(delaunay, vertices)) {
      const unsigned set = bits(c);
      for (int i = 0; set >> i != 0; ++i) {
        const FacetId f = facet_id(c, i);
        if (((set >> i) & 1U) == 0 || view.canonical(f) != f) continue;
        const auto [a, b, d] = view.facet_vertices(f);
        if ((in_list_[a] | in_list_[b] | in_list_[d]) != 0) facets.push_back(f);
      }
    }
    for (const VertexId v : vertices) in_list_[v] = 0;
    return link(view, std::move(facets));
  }

  // These facets, each once, by canonical ids.
  LocalFacets link(const TriangulationView& view, std::vector<FacetId> facets);

 private:
  StarFinder stars_;
  // Scratch by vertex.
  IdVector<VertexId, std::uint8_t> in_list_;
  IdVector<VertexId, VertexId> vertex_here_;
};

}  // namespace cocoon
