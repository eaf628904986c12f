// The triangles of a facet set around each vertex, with their normals: what pruning and the search
// for umbrellas read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/point.h"

namespace cocoon {

// Structure of arrays over the triangles of the set; a triangle is its position in them.
struct TriangleFans {
  std::vector<FacetId> facets;                   // canonical ids, ascending
  std::vector<std::array<VertexId, 3>> corners;  // in lexicographic order of their points
  std::vector<Vec3> normals;                     // unit((c1 - c0) x (c2 - c0)); zero if degenerate
  std::vector<std::uint32_t> offsets;            // per vertex and one past the end
  std::vector<std::uint32_t> triangles;  // those around each vertex, one vertex after the other

  std::size_t size() const { return facets.size(); }
  std::span<const std::uint32_t> around(VertexId v) const {
    return std::span(triangles).subspan(offsets[v.index()],
                                        offsets[v.index() + 1] - offsets[v.index()]);
  }
};

// Complexity: O(cells + vertices). The normals are functions of the triangles alone.
TriangleFans triangle_fans(const Triangulation& triangulation, const FacetSet& facets,
                           const Execution& execution = {});

// An edge as one triangle at a vertex sees it.
struct Spoke {
  VertexId other;          // the far end
  std::uint32_t triangle;  // position in the fans
  std::uint32_t local;     // position of the triangle in around(center)
  double sign;             // +1 if the corners run center -> other, -1 against
};

// The spokes of all triangles around `center`, grouped by their far ends; two for each triangle.
// `spokes` is overwritten. Complexity: O(k log k) for k triangles.
void collect_spokes(const TriangleFans& fans, VertexId center, std::vector<Spoke>& spokes);

// Calls visit(span) for each group of spokes with the same far end.
template <class Visit>
void for_each_edge(std::span<const Spoke> spokes, Visit visit) {
  for (std::size_t begin = 0; begin < spokes.size();) {
    std::size_t end = begin + 1;
    while (end < spokes.size() && spokes[end].other == spokes[begin].other) ++end;
    visit(spokes.subspan(begin, end - begin));
    begin = end;
  }
}

// Cosine of the dihedral of two triangles at their common edge: the angle in [0, pi] between the
// parts of their third vertices orthogonal to it; pi = flat (cosine -1), 0 = folded back (+1).
// cos = sign_a sign_b n_a . n_b, since both turn about the same axis. Degenerate triangles give 0.
inline double dihedral_cosine(const TriangleFans& fans, const Spoke& a, const Spoke& b) {
  return a.sign * b.sign * dot(fans.normals[a.triangle], fans.normals[b.triangle]);
}

}  // namespace cocoon
