// Triangles of an old mesh in a triangulation: at which vertices they are a surface of facets
// still, and what they tell there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cocone/facet_set.h"
#include "cocone/facets/half_star.h"
#include "cocone/known_labels.h"
#include "cocone/marking/cell_label.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// What cells were told by old triangles: bits.
enum Told : std::uint8_t { told_out = 1, told_in = 2, told_both = 3 };

// What it was told, told nothing or both: unmarked.
inline CellLabel label_told(unsigned told) {
  return told == told_out ? CellLabel::out : told == told_in ? CellLabel::in : CellLabel::unmarked;
}

// Whether a cell is labeled as it was told: all four vertices are corners of old triangles, or
// those that are are intact (known_labels.h). Bit i: vertex i of the cell is one.
inline bool is_believed(unsigned corners, unsigned intact) {
  return corners == 15 || corners == intact;
}

class OldTriangles {
 public:
  // Keeps references, which must outlive the object. Complexity: O(cells + triangles).
  OldTriangles(const Triangulation& triangulation, std::span<const KnownTriangle> triangles,
               const Execution& execution = {});

  std::size_t size() const { return facet_of_.size(); }
  // The facet that the triangle is, seen from behind it; none: it has not been entered.
  FacetId facet(std::size_t triangle) const { return facet_of_[triangle]; }
  // All facets that were entered.
  const FacetSet& facets() const { return facets_; }

  // A facet that is an old triangle.
  struct Found {
    FacetId facet;  // seen from behind the triangle
    std::uint32_t triangle;
  };
  // Appends the triangles with the corners of the facet, the first one of each orientation; none
  // has an infinite cell behind it. Complexity: O(triangles at a corner).
  void find(FacetId f, std::vector<Found>& found) const;
  void enter(const Found& found) {
    facet_of_[found.triangle] = found.facet;
    facets_.insert(triangulation_, found.facet);
  }

  // Whether an old triangle has the vertex. O(1).
  bool is_corner(VertexId v) const {
    return v != infinite_vertex && begins_[v.index()] != begins_[v.index() + 1];
  }
  // Whether all old triangles at the vertex are facets, and leave no gap. Precondition: those that
  // are were entered. Complexity: O(triangles at v), as a rule.
  bool is_intact(VertexId v) const;
  // Whether there are old triangles at the vertex, facets or not, and they leave no gap.
  // Complexity: as is_intact.
  bool is_closed(VertexId v) const;
  // Tells the cells at an intact vertex that lie on that side of a triangle there. Complexity:
  // O(cells at v).
  template <class Cells>
  void tell_around(VertexId v, Told side, HalfStar& half, Cells& told) const {
    bool any = false;
    for (const Spoke& spoke : fan(v)) {
      const FacetId f = facet_of_[spoke.triangle];
      const CellId c = cell_of(side == told_in ? f : triangulation_.mirror(f));
      if (any && half.contains(c)) continue;  // one of those told last
      any = true;
      for (const CellId d : half.flood(v, c)) told[d] = static_cast<std::uint8_t>(told[d] | side);
    }
  }

 private:
  // An old triangle at one of its corners.
  struct Spoke {
    VertexId from;  // the other two corners, counterclockwise
    VertexId to;
    std::uint32_t triangle;
  };
  std::span<const Spoke> fan(VertexId v) const {
    const std::uint32_t begin = begins_[v.index()];
    return std::span(spokes_).subspan(begin, begins_[v.index() + 1] - begin);
  }
  static bool is_balanced(std::span<const Spoke> fan);

  const Triangulation& triangulation_;
  std::vector<std::uint32_t> begins_;
  std::vector<Spoke> spokes_;  // by vertex
  std::vector<FacetId> facet_of_;
  FacetSet facets_;
};

}  // namespace cocoon
