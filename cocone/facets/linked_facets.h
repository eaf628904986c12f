// A set of facets as triangles linked around their edges: what pruning, the search for umbrellas,
// the extraction of a manifold and the marking read.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/candidate_triangles.h"
#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"
#include "geom/side_links.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Structure of arrays over the triangles of the set; a triangle is its position in them. They are
// ordered by their smallest vertex, so that neighbors in space are neighbors in memory (but for
// those that without() or kept_links.h moves).
struct LinkedFacets {
  FacetSet set;
  OverwriteVector<FacetId> facets;    // canonical ids
  OverwriteVector<FacetId> mirrors;   // the same facets as the cells behind number them
  OverwriteVector<Triangle> corners;  // facet_vertices(facet): counterclockwise seen from behind
  OverwriteVector<Vec3> normals;      // unit, out of cell_of(facet); zero if degenerate
  SideLinks links;                    // rings of the sides on each edge: geom/side_links.h
  // The edges that are not two triangles with a dihedral cosine of at most steep_cosine, by their
  // first (smallest) sides; ascending. Of candidates on the samples of a surface few of all: most
  // stages look at these alone.
  std::vector<SideId> steep;
  static constexpr double steep_cosine = 0;  // a right angle

  std::size_t size() const { return facets.size(); }
  // The two ends of a side, in the direction of its triangle.
  std::array<VertexId, 2> ends(SideId side) const {
    const Triangle& triangle = corners[triangle_of_side(side)];
    const std::size_t i = corner_of_side(side);
    return {triangle[next_corner(i)], triangle[previous_corner(i)]};
  }
  // Exactly two triangles at the edge of the side.
  bool is_two_sided(SideId side) const { return links[side] != side && links[links[side]] == side; }
  bool is_three_sided(SideId side) const {
    const SideId second = links[side];
    const SideId third = links[second];
    return second != side && third != side && links[third] == side;
  }
  // The smallest of the sides on its edge: each edge has one. After without() moved triangles rings
  // need not ascend.
  SideId first_at_edge(SideId side) const {
    SideId first = side;
    for (SideId other = links[side]; other != side; other = links[other]) {
      first = std::min(first, other);
    }
    return first;
  }
  bool is_first(SideId side) const { return first_at_edge(side) == side; }
};

// Complexity: O(triangles) and one byte per cell, parallel. The normals are functions of the
// triangles alone, up to their sign.
LinkedFacets link_facets(const Triangulation& triangulation, FacetSet facets,
                         const Execution& execution = {});

// The same for who has them as a list: without a look at the cells that have none.
LinkedFacets link_facets(const Triangulation& triangulation, CandidateTriangles candidates,
                         const Execution& execution = {});

// Fills in normals, links and steep edges of triangles with corners at these points. Complexity:
// O(triangles + points), parallel.
void link_corners(const IdVector<VertexId, Point>& points, LinkedFacets& triangles,
                  const Execution& execution = {});

// Where the last triangles go when those with a flag leave their places, in the order of `to`.
// Complexity: one look at every flag.
struct TriangleMove {
  std::uint32_t from;
  std::uint32_t to;
};
std::vector<TriangleMove> moves_into_places(const std::vector<std::uint8_t>& removed);

// The triangles whose flag is 0. Rings close over those that go, and the last triangles move to
// their places (moves_into_places). Complexity: one look at every flag, and O(triangles removed +
// steep edges).
LinkedFacets without(const Triangulation& triangulation, LinkedFacets triangles,
                     const std::vector<std::uint8_t>& removed);

// Cosine of the dihedral of two triangles at their common edge: the angle in [0, pi] between the
// parts of their third vertices orthogonal to it; pi = flat (cosine -1), 0 = folded back (+1).
// The normals say it, with the sign that the directions of the two sides demand; degenerate
// triangles give 0. Precondition: the sides are on one edge.
inline double dihedral_cosine(const LinkedFacets& triangles, SideId a, SideId b) {
  const double cosine =
      dot(triangles.normals[triangle_of_side(a)], triangles.normals[triangle_of_side(b)]);
  // From a table: a branch could not be foreseen.
  constexpr std::array<double, 2> signs = {-1, 1};
  return signs[triangles.ends(a)[0] == triangles.ends(b)[0] ? 1 : 0] * cosine;
}

// Whether the edge of the side is not two triangles with at most this dihedral cosine.
inline bool is_steep(const LinkedFacets& triangles, SideId side, double largest_cosine) {
  return !triangles.is_two_sided(side) ||
         !(dihedral_cosine(triangles, side, triangles.links[side]) <= largest_cosine);
}

// The edges that are steep in this sense: like LinkedFacets::steep, with another limit. Complexity:
// O(steep edges) for limits from steep_cosine on; O(triangles), parallel, for smaller ones.
std::vector<SideId> steep_edges(const LinkedFacets& triangles, double largest_cosine,
                                const Execution& execution = {});

// Calls visit(side) for every side on the edge of `side`, beginning with it.
template <class Visit>
void for_each_side_at_edge(const LinkedFacets& triangles, SideId side, Visit visit) {
  SideId other = side;
  do {
    visit(other);
    other = triangles.links[other];
  } while (other != side);
}

}  // namespace cocoon
