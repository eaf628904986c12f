// A certificate: is this value a Delaunay triangulation, whoever made it?
#pragma once

#include <cstddef>
#include <string>

#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// How often each property is violated. All decisions are exact.
struct DelaunayReport {
  std::size_t malformed_cells = 0;     // vertex out of range, repeated, or infinite in a wrong slot
  std::size_t broken_neighbors = 0;    // facets: neighbor out of range, not mutual, other triangle
                                       // or the same side of it
  std::size_t misoriented_cells = 0;   // finite, orient3d <= 0
  std::size_t reflex_hull_edges = 0;   // a neighboring hull facet's vertex lies beyond the facet
  std::size_t hidden_hull_facets = 0;  // not seen from inside, or one behind another
  std::size_t unused_vertices = 0;     // in no cell
  std::size_t bad_links = 0;           // cells around a vertex, also the infinite one, do not fit
                                       // together like a sphere (by Euler's relation)
  std::size_t vertices_without_point = 0;  // no input point was mapped to them
  std::size_t occupied_spheres = 0;  // facets between finite cells that are not locally Delaunay
  // The first violation, one line; empty if there is none. The same for every thread count.
  std::string first_violation;

  bool ok() const { return first_violation.empty(); }
};

// Tests all that makes a Triangulation a Delaunay triangulation under the perturbation of
// geom/perturbation.h: positively oriented cells that fit together along mutual facets into a
// closed manifold with a convex hull, every vertex in use, and no vertex inside the sphere of the
// cell behind a facet. That is enough:
//
//   1. The hull is convex at its edges. Each of its facets is seen from one place inside, and some
//      ray from there meets only one: so every ray does, and the hull is convex as a whole.
//   2. The two cells at a facet lie on its two sides, so the number of cells that cover a place
//      changes at the hull only: inside it is how often the hull winds around, which is once.
//   3. So the cells fill the hull once, and local emptiness at every facet implies global emptiness
//      (Delaunay's lemma: a lifted surface above the hull is convex if it is so at each facet).
//   4. The perturbed Delaunay triangulation is unique: what passes is THE one of its points.
//
// If cells are malformed or neighbors are broken, only that is reported: the rest cannot be read.
// Complexity: O(cells) for bounded vertex degrees.
// Deterministic for any thread count. Source: Mehlhorn et al., Checking geometric programs or
// verification of geometric structures (1999), for the ray; Devillers, Liotta, Preparata &
// Tamassia, Checking the convexity of polytopes and the planarity of subdivisions (1998), for
// certifying by local tests.
DelaunayReport check_delaunay(const Triangulation& triangulation, const Execution& execution = {});

}  // namespace cocoon
