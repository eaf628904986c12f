// A set of facets as triangles linked around their edges: what pruning, the search for umbrellas,
// the extraction of a manifold and the marking read. For triangles of a mesh see
// geom/mesh/halfedges.h.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cocone/candidate_triangles.h"
#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/mesh/halfedges.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Structure of arrays over the triangles of the set; a triangle is its position in them. They are
// ordered by their smallest vertex, so that neighbors in space are neighbors in memory (but for
// those that facet_removal.h or kept_links.h moves).
struct LinkedFacets {
  FacetSet set;
  OverwriteVector<FacetId> facets;    // canonical ids
  OverwriteVector<FacetId> mirrors;   // the same facets as the cells behind number them
  OverwriteVector<Triangle> corners;  // facet_vertices(facet): counterclockwise seen from behind
  OverwriteVector<Vec3> normals;      // unit, out of cell_of(facet); zero if degenerate
  HalfedgeLinks links;                // rings of the halfedges on each edge: geom/mesh/halfedges.h
  // The edges that are not two triangles with a dihedral cosine of at most steep_cosine, by their
  // first (smallest) halfedges; ascending. Of candidates on the samples of a surface few of all:
  // most stages look at these alone.
  std::vector<Halfedge> steep;
  static constexpr double steep_cosine = 0;  // a right angle

  std::size_t size() const { return facets.size(); }
  // New triangles are not written; set and steep stay as they are.
  void resize(std::size_t count) {
    facets.resize(count);
    mirrors.resize(count);
    corners.resize(count);
    normals.resize(count);
    links.resize(3 * count);
  }
  // The two ends of a halfedge, in the direction of its triangle.
  std::array<VertexId, 2> ends(Halfedge halfedge) const {
    const Triangle& triangle = corners[triangle_of_halfedge(halfedge)];
    const std::size_t i = corner_of_halfedge(halfedge);
    return {triangle[next_corner(i)], triangle[previous_corner(i)]};
  }
  // Exactly two triangles at the edge of the halfedge.
  bool has_two_triangles(Halfedge halfedge) const {
    return cocoon::has_two_triangles(links, halfedge);
  }
  bool has_three_triangles(Halfedge halfedge) const {
    const Halfedge second = links[halfedge];
    const Halfedge third = links[second];
    return second != halfedge && third != halfedge && links[third] == halfedge;
  }
  // The smallest of the halfedges on its edge: each edge has one. Not is_last_at_edge(): after
  // without() moved triangles rings need not ascend.
  bool is_first(Halfedge halfedge) const { return first_at_edge(links, halfedge) == halfedge; }
};

// Complexity: O(triangles) and one byte per cell, parallel. The normals are functions of the
// triangles alone, up to their sign.
LinkedFacets link_facets(const Triangulation& triangulation, FacetSet facets,
                         const Execution& execution = {});

// Overload for callers that already have the facets as a list: saves a pass over all cells.
LinkedFacets link_facets(const Triangulation& triangulation, CandidateTriangles candidates,
                         const Execution& execution = {});

// Fills in normals, links and steep edges of triangles with corners at these points. Complexity:
// O(triangles + points), parallel.
void link_corners(const IdVector<VertexId, Point>& points, LinkedFacets& triangles,
                  const Execution& execution = {});

// Cosine of the dihedral of two triangles at their common edge: the angle in [0, pi] between the
// parts of their third vertices orthogonal to it; pi = flat (cosine -1), 0 = folded back (+1).
// The normals say it, with the sign that the directions of the two halfedges demand; degenerate
// triangles give 0. Precondition: the halfedges are on one edge.
inline double dihedral_cosine(const LinkedFacets& triangles, Halfedge a, Halfedge b) {
  const double cosine =
      dot(triangles.normals[triangle_of_halfedge(a)], triangles.normals[triangle_of_halfedge(b)]);
  // From a table: a branch could not be foreseen.
  constexpr std::array<double, 2> signs = {-1, 1};
  return signs[triangles.ends(a)[0] == triangles.ends(b)[0] ? 1 : 0] * cosine;
}

// Whether the edge of the halfedge is not two triangles with at most this dihedral cosine.
inline bool is_steep(const LinkedFacets& triangles, Halfedge halfedge, double largest_cosine) {
  return !triangles.has_two_triangles(halfedge) ||
         !(dihedral_cosine(triangles, halfedge, triangles.links[halfedge]) <= largest_cosine);
}

// The edges that are steep in this sense: like LinkedFacets::steep, with another limit. Complexity:
// O(steep edges) for limits from steep_cosine on; O(triangles), parallel, for smaller ones.
std::vector<Halfedge> steep_edges(const LinkedFacets& triangles, double largest_cosine,
                                  const Execution& execution = {});

}  // namespace cocoon
