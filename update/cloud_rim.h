// The rim of a cloud: the closed boundary loops of its open Cocone surface, with what the update
// needs at each point and edge of them. Plain points, so that the later stages can be fed by hand.
//
//        apex of edge i          the surface lies on this side
//           /|
//          / |
//   b_i --------- b_i+1 ----     E_i = (b_i, b_i+1), indices modulo the length of the loop
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/boundary_loops.h"
#include "geom/mesh/halfedges.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct RimLoop {
  std::vector<Point> points;  // b_i
  std::vector<Point> apexes;  // third corner of the one Cocone triangle at E_i
  // Unit surface normal at b_i, of the part of the surface that has E_i; the zero vector if there
  // is none. The normals of one loop agree with each other; which of the two sides they show is
  // arbitrary.
  std::vector<Vec3> normals;
  std::vector<VertexId> vertices;     // b_i as a vertex of the cloud's surface
  std::vector<TriangleId> triangles;  // the one at E_i, of that surface
  double perimeter = 0;
  std::uint32_t component = 0;  // the same number for all loops of one part of the surface
  // Of a one-sided part of the surface: the normals agree from edge to edge, but somewhere the
  // surface has gone over to the other side of the body.
  bool one_sided = false;
  // 1 where the cloud goes on beyond E_i (rim_seams.h): not the end of the cloud, but a seam in its
  // surface; and where another cloud does (shared_edges.h). Empty: nowhere.
  std::vector<std::uint8_t> inner;

  bool is_inner(std::size_t i) const { return !inner.empty() && inner[i] != 0; }
  // b_i lies between two such edges: it says nothing about where the cloud ends.
  bool is_inner_point(std::size_t i) const {
    return is_inner(i) && is_inner(i > 0 ? i - 1 : points.size() - 1);
  }
  std::size_t inner_edges() const {
    return static_cast<std::size_t>(std::count(inner.begin(), inner.end(), 1));
  }
  bool is_partial() const { return inner_edges() > 0; }
  std::size_t size() const { return points.size(); }
  std::size_t next(std::size_t i) const { return i + 1 < points.size() ? i + 1 : 0; }
  Point middle(std::size_t i) const { return 0.5 * (points[i] + points[next(i)]); }  // of E_i
};

struct CloudRim {
  std::vector<RimLoop> loops;
  // Too small to be rims, unless the model goes on through them (pin_holes.h); without seams, once
  // mark_rim_seams() has been here.
  std::vector<RimLoop> pin_hole_loops = {};
  double spacing = 0;  // median length of the rim edges; of all surface edges if there is no loop
  double median_edge = 0;  // of the surface: shorter where rim edges bridge dents

  // What was left out, see RimOptions.
  std::size_t pin_holes = 0;         // loops too small to be a rim, seams among them
  std::size_t small_components = 0;  // parts of the surface too small to be the patch
  std::size_t seam_loops = 0;        // taken out by mark_rim_seams()
  std::size_t seamed_loops = 0;      // left in by it, though they are seams for the most part
  std::size_t rim_edges = 0;         // of all loops that it looked at
  std::size_t seam_edges = 0;        // of these, edges with cloud beyond them, and wall_edges
  std::size_t lone_edges = 0;        // edges with a few samples beyond them and no cloud
  std::size_t non_orientable = 0;    // one-sided parts: their normals are not reliable

  std::size_t wall_edges = 0;    // inner by mark_wall_edges()
  std::size_t shared_edges = 0;  // marked by mark_shared_edges()
  bool leaves_model = false;     // by its overlap: Overlap::leaves_model

  // By its perimeter, of several the first. Precondition: there is one.
  std::size_t longest_loop() const {
    const auto longest = std::max_element(
        loops.begin(), loops.end(),
        [](const RimLoop& a, const RimLoop& b) { return a.perimeter < b.perimeter; });
    return static_cast<std::size_t>(longest - loops.begin());
  }

  // Whether parts of it are no end of what was scanned: the surface of the cloud broke up somewhere
  // inside it, another cloud goes on beyond it, or it runs over what has changed.
  bool is_partial() const { return seam_edges > 0 || shared_edges > 0 || leaves_model; }
};

// The rim of a cloud that is `factor` times as large. Precondition: factor > 0. O(rim).
CloudRim scaled(CloudRim rim, double factor);

struct RimOptions {
  BoundaryLoopOptions loops;
  // The outline of a small patch is not a pin-hole: a loop that boundary_loops() calls one counts
  // as rim if its perimeter is at least this share of that of a disk with its component's area.
  double min_outline_share = 0.5;
};

// The rim of an open surface: its boundary loops that are no pin-holes.
// Result: no loop if the surface is closed, or empty, or if nothing but pin-holes is open.
// Complexity: O(triangles + vertices + rim log rim). Deterministic: independent of the numbering
// and orientation of the surface's triangles, up to the sign of normals.
// Errors: InputError for options out of range. Source: Woo & Dey 2005, section 3.2.
CloudRim cloud_rim(const TriangleMesh& surface, const RimOptions& options = {});

// Overload for callers that already have the linked halfedges of the surface.
CloudRim cloud_rim(const TriangleMesh& surface, const HalfedgeRings& rings,
                   const RimOptions& options = {});

}  // namespace cocoon
