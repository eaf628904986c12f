// The linked candidates of a changing triangulation: what is there already is not linked again.
//
// Kept are the candidates of the last surface, with their rings (linked_facets.h). Of those of the
// next one that are not among them, or not in cells as they were, each takes the place of one that
// went, or comes at the end. Rings change only at edges of triangles that come or go: both
// ends of such an edge are corners of these, so all triangles with two such corners are linked
// anew, as a mesh of their own, and take over the rings at these edges.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/facet_set.h"
#include "cocone/facets/facet_removal.h"
#include "cocone/facets/linked_facets.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/renumbering.h"
#include "delaunay/star_finder.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

class KeptLinks {
 public:
  // Whether triangles are kept.
  bool exists() const { return exists_; }
  void clear() { *this = KeptLinks(); }

  // Keeps the candidates of an extraction: those of the surface, with their set, and the rest.
  // Complexity: that of put_back.
  void keep(LinkedFacets surface, RemovedFacets rest);
  // After a change of the triangulation, and when gaps are closed. Complexity: O(change).
  void update(const DynamicDelaunay& delaunay, const DelaunayChange& change);
  void renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay);

  // What link_facets gives, in another order; nothing is kept then. Complexity: a look at a byte of
  // each cell and at each triangle, and O(change); or as link_facets.
  LinkedFacets link(const Triangulation& triangulation, FacetSet facets,
                    const Execution& execution = {});

 private:
  bool is_kept(const FacetSet& facets, FacetId facet, FacetId mirror) const;
  std::vector<FacetId> new_facets(const Triangulation& triangulation, const FacetSet& facets) const;

  bool exists_ = false;
  LinkedFacets triangles_;                // without set
  IdVector<CellId, std::uint8_t> cells_;  // bit i: facet i is one of them; or that it is new
  StarFinder stars_;
};

}  // namespace cocoon
