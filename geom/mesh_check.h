// A certificate: what kind of surface a triangle mesh is, in counts that anyone can recompute.
// Independent on purpose: of this library's mesh code it uses only linked_mesh.h (links, and which
// edges are irregular), what finds parts that hang together (edge_components.h, disjoint_sets.h)
// and equal points (equal_points.h), and the exact collinearity test, so that it can judge what the
// stages produce. See docs/stages/mesh_check.md.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/mesh/linked_mesh.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

using VertexPair = std::array<VertexId, 2>;  // smaller id first

// Triangles that hang together by edges (whatever number of triangles meets there).
struct MeshComponent {
  TriangleId first_triangle;  // the smallest id in it
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::ptrdiff_t euler = 0;          // vertices - edges + triangles
  bool closed = false;               // every edge has exactly two of its triangles
  bool manifold = false;             // no edge with more than two, no pinched vertex in it
  bool orientable = false;           // triangles can be turned so that no two conflict
  std::optional<std::size_t> genus;  // (2 - euler) / 2 if closed, manifold and orientable
};

// Ids of the first offenders, in increasing order, at most MeshCheckOptions::max_examples each.
struct MeshExamples {
  std::vector<VertexPair> open_edges;
  std::vector<VertexPair> overfull_edges;
  std::vector<VertexPair> orientation_conflicts;
  std::vector<VertexId> pinched_vertices;
  std::vector<VertexId> non_finite_vertices;
  std::vector<TriangleId> repeated_vertex_triangles;
  std::vector<TriangleId> zero_area_triangles;
  std::vector<TriangleId> duplicate_triangles;
};

struct MeshReport {
  std::size_t vertices = 0;
  std::size_t used_vertices = 0;        // corners of at least one triangle
  std::size_t unused_vertices = 0;      // vertices - used_vertices
  std::size_t coincident_vertices = 0;  // vertices minus distinct coordinates
  std::size_t non_finite_vertices = 0;  // a coordinate is infinite or not a number
  std::size_t triangles = 0;            // all, bad ones included

  // Triangles that name a vertex twice have no edges: they are counted here and left out of
  // everything below.
  std::size_t repeated_vertex_triangles = 0;
  std::size_t zero_area_triangles = 0;  // corners exactly on one line (three different vertices)
  std::size_t duplicate_triangles = 0;  // same three vertices as an earlier one, in any order

  std::size_t edges = 0;
  std::size_t open_edges = 0;             // exactly one triangle
  std::size_t overfull_edges = 0;         // more than two triangles
  std::size_t odd_edges = 0;              // an odd number of triangles, open edges included
  std::size_t unbalanced_edges = 0;       // not run through equally often in both directions
  std::size_t orientation_conflicts = 0;  // two triangles, both in the same direction
  std::size_t boundary_curves = 0;        // connected sets of open edges
  std::size_t pinched_vertices = 0;       // the link is not one single path or cycle
  std::size_t components = 0;             // connected by edges
  std::size_t vertex_components = 0;      // connected by vertices: at most `components`
  std::ptrdiff_t euler = 0;               // used vertices - edges + triangles with edges
  std::optional<std::size_t> genus;       // sum over components, if each has one

  bool watertight = false;       // there are triangles, and no edge has an odd number of them
  bool balanced = false;         // watertight, and every edge is balanced: bounds a volume
  bool edge_manifold = false;    // no edge has more than two triangles
  bool vertex_manifold = false;  // no vertex is pinched
  bool oriented = false;         // no orientation conflict, and no unbalanced overfull edge
  bool orientable = false;       // every component is

  std::vector<MeshComponent> component_reports;  // by first triangle
  MeshExamples examples;

  // Closed 2-manifold with consistent orientation, and no triangle that names a vertex twice.
  bool is_closed_manifold() const {
    return balanced && edge_manifold && vertex_manifold && repeated_vertex_triangles == 0;
  }
};

struct MeshCheckOptions {
  std::size_t max_examples = 8;
};

// Checks `mesh`. Throws InputError if a triangle names a vertex that is not there; everything
// else that can be wrong with a mesh is a count. Self-intersections are a question of geometry
// and cost more: see self_intersection.h.
// Complexity: O((t + v) log (t + v)), O(t + v) expected for bounded valence and few vertices at one
// place; parallel but for the search for components. Deterministic: counts do not depend on the
// order of vertices and triangles.
MeshReport mesh_check(const TriangleMesh& mesh, const MeshCheckOptions& options = {},
                      const Execution& execution = {});

// The same of a mesh that is linked already; examples and first triangles have the ids of the mesh
// that was linked.
MeshReport mesh_check(const LinkedMesh& mesh, const MeshCheckOptions& options = {},
                      const Execution& execution = {});

}  // namespace cocoon
