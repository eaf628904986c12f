// The rim of a cloud: the closed boundary loops of its open Cocone surface, with what the update
// needs at each point and edge of them. Plain points, so that the later stages can be fed by hand.
//
//        apex of edge i          the surface lies on this side
//           /|
//          / |
//   b_i --------- b_i+1 ----     E_i = (b_i, b_i+1), indices modulo the length of the loop
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct RimLoop {
  std::vector<Point> points;       // b_i
  std::vector<Point> apexes;       // third corner of the one Cocone triangle at E_i
  std::vector<Vec3> normals;       // unit surface normal at b_i; the zero vector if there is none
  std::vector<VertexId> vertices;  // b_i as a vertex of the cloud's surface
  // Loops of one component have normals that agree; between components the sign is free.
  std::uint32_t component = 0;
  double perimeter = 0;

  std::size_t size() const { return points.size(); }
  std::size_t next(std::size_t i) const { return i + 1 < points.size() ? i + 1 : 0; }
};

struct CloudRim {
  std::vector<RimLoop> loops;
  double spacing = 0;  // median length of the rim edges; of all surface edges if there is no loop

  // What was left out, see RimOptions.
  std::size_t pin_holes = 0;            // loops too small to be a rim
  std::size_t small_components = 0;     // parts of the surface too small to be the patch
  std::size_t discarded_triangles = 0;  // in those parts
  std::size_t orientation_conflicts = 0;
};

struct RimOptions {
  // Parts of the surface with a smaller share of its triangles are debris: their loops do not
  // count.
  double min_component_share = 0.05;
  // A loop with fewer edges or a shorter perimeter (in median surface edges) is a pin-hole: the
  // cloud is taken to cover it. The outline of a small patch is not a pin-hole: a loop counts if
  // its perimeter is at least `min_outline_share` of that of a disk with its component's area.
  std::size_t min_loop_edges = 8;
  double min_loop_perimeter = 12;
  double min_outline_share = 0.5;
};

// The rim of an open surface. Each loop starts at its lexicographically smallest point and runs
// towards the smaller one of that point's two neighbors; loops are sorted by their first points.
// So the rim is a function of the surface as a set of triangles, not of its numbering.
// Result: no loop if the surface is closed, or empty, or if nothing but pin-holes is open.
// Complexity: O(triangles + vertices + rim log rim).
// Source: Woo & Dey 2005, section 3.2. A boundary edge is an edge with exactly one triangle; the
// paper's "edge between two boundary samples" would also take chords across corners.
CloudRim cloud_rim(const TriangleMesh& surface, const RimOptions& options = {});

}  // namespace cocoon
