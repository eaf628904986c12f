// A set of facets as triangles linked around their edges: what pruning, the search for umbrellas,
// the extraction of a manifold and the marking read.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/point.h"
#include "geom/side_links.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Structure of arrays over the triangles of the set; a triangle is its position in them. They are
// ordered by their smallest vertex, so that neighbors in space are neighbors in memory (but for
// those that without() or kept_links.h moves).
struct LinkedFacets {
  FacetSet set;
  std::vector<FacetId> facets;    // canonical ids
  std::vector<FacetId> mirrors;   // the same facets as the cells behind number them
  std::vector<Triangle> corners;  // facet_vertices(facet): counterclockwise seen from behind
  std::vector<Vec3> normals;      // unit, out of cell_of(facet); zero if degenerate
  std::vector<SideId> links;      // rings of the sides on each edge: geom/side_links.h

  std::size_t size() const { return facets.size(); }
  // The two ends of a side, in the direction of its triangle.
  std::array<VertexId, 2> ends(SideId side) const {
    const Triangle& triangle = corners[triangle_of_side(side)];
    const std::size_t i = corner_of_side(side);
    return {triangle[next_corner(i)], triangle[previous_corner(i)]};
  }
  // Exactly two triangles at the edge of the side.
  bool is_two_sided(SideId side) const { return links[side] != side && links[links[side]] == side; }
};

// Complexity: O(triangles) and one byte per cell, parallel. The normals are functions of the
// triangles alone, up to their sign.
LinkedFacets link_facets(const Triangulation& triangulation, FacetSet facets,
                         const Execution& execution = {});

// Fills in normals and links of triangles with corners at these points. Complexity: O(triangles +
// points), parallel.
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
// their places (moves_into_places). Complexity: one look at every flag, and O(triangles removed).
LinkedFacets without(const Triangulation& triangulation, LinkedFacets triangles,
                     const std::vector<std::uint8_t>& removed);

// Cosine of the dihedral of two triangles at their common edge: the angle in [0, pi] between the
// parts of their third vertices orthogonal to it; pi = flat (cosine -1), 0 = folded back (+1).
// The normals say it, with the sign that the directions of the two sides demand; degenerate
// triangles give 0. Precondition: the sides are on one edge.
inline double dihedral_cosine(const LinkedFacets& triangles, SideId a, SideId b) {
  const double cosine =
      dot(triangles.normals[triangle_of_side(a)], triangles.normals[triangle_of_side(b)]);
  return triangles.ends(a)[0] == triangles.ends(b)[0] ? cosine : -cosine;
}

// Calls visit(side) for the first (smallest) side of every edge of the triangles begin .. end.
template <class Visit>
void for_each_edge(const LinkedFacets& triangles, std::size_t begin, std::size_t end, Visit visit) {
  // Which of two sides is the first cannot be foreseen: they are listed without a branch on it.
  // What dihedral_cosine() is to read there lies here and there in memory: it is asked for in
  // advance.
  constexpr std::size_t sides_per_block = 96;
  std::array<SideId, sides_per_block> sides;
  const auto last = static_cast<SideId>(3 * end);
  for (auto first = static_cast<SideId>(3 * begin); first < last;) {
    const SideId next = std::min<SideId>(first + sides_per_block, last);
    std::size_t count = 0;
    for (; first < next; ++first) {
      sides[count] = first;
      count += triangles.links[first] >= first ? 1U : 0U;
      __builtin_prefetch(&triangles.normals[triangle_of_side(triangles.links[first])]);
      __builtin_prefetch(&triangles.corners[triangle_of_side(triangles.links[first])]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const SideId side = sides[k];
      SideId other = triangles.links[side];
      while (other > side) other = triangles.links[other];
      if (other == side) visit(side);
    }
  }
}

// The edges that are not two flat triangles: the first sides of those with another number of
// triangles than two, or with a larger dihedral cosine than this. Ascending. Of candidates on the
// samples of a surface few of all. Complexity: O(triangles), parallel.
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
