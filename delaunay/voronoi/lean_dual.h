// The Voronoi vertices and rays that floating point does not tell, and the dual that keeps only
// these.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/circumsphere.h"
#include "geom/execution.h"
#include "geom/point.h"
#include "geom/triangle_normal.h"

namespace cocoon {

inline constexpr std::size_t dual_grain = 8192;  // cells per chunk of loops over all of them

// Noted down of successive cells by who computes their centers.
struct HardCenters {
  std::size_t exact_centers = 0;  // these two as in Dual
  std::size_t facet_fallbacks = 0;
  std::vector<CellId> cells;
  std::vector<Point> centers;  // of these cells, but for infinite ones

  void note(CenterLevel level, CellId c);
};

// Of the vertices of a finite cell. O(1).
Circumcenter circumcenter_of(const Triangulation& triangulation, CellId finite);

// Of the hull facet of an infinite cell, outward. O(1).
TriangleNormal hull_normal(const Triangulation& triangulation, CellId infinite);

// Puts the notes of parts of the cells, in the order of the cells, behind those that the dual has.
void append(std::span<const HardCenters> parts, Dual& dual);

// The directions of all infinite cells, one after the other, and notes of them behind those that
// the dual has. Complexity: O(infinite cells), parallel.
void find_rays(const Triangulation& triangulation, std::span<Vec3> rays, Dual& dual,
               const Execution& execution);

// A lean dual, of what a stage notes down that goes over all finite cells anyway.
// Complexity: O(hard centers + infinite cells), parallel.
Dual lean_dual(const Triangulation& triangulation, std::span<const HardCenters> parts,
               const Execution& execution = {});

// Of a finite cell that no batch certifies. `dual`: lean.
// Complexity: O(log hard centers), and exact integers if it is none of them.
Point hard_center(const Triangulation& triangulation, const Dual& dual, CellId finite);

}  // namespace cocoon
