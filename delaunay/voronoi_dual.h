// The Voronoi diagram of the vertices, read off the Delaunay triangulation.
// Source: the textbook duality; which centers can be trusted is ours, docs/stages/voronoi_dual.md.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/circumsphere_batch.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

struct Dual {
  // Finite cell: its Voronoi vertex, the circumcenter. Infinite cell: the unit direction of its
  // Voronoi ray, the outward normal of the hull facet (oriented by the finite cell behind it).
  IdVector<CellId, Point> centers;  // empty in a lean dual
  // How they were obtained where floating point did not suffice (geom/circumsphere.h,
  // geom/triangle_normal.h).
  std::size_t exact_centers = 0;       // centers and directions computed in exact integers
  std::size_t facet_fallbacks = 0;     // center of a facet, or the centroid; never for exact cells
                                       // unless the true center is beyond the range of double
  std::vector<CellId> not_in_doubles;  // the cells of both counts, ascending
  // A lean dual keeps the Voronoi vertices that were hard to get and the rays; the others are
  // computed anew by who looks at them, which takes no longer than to write and read them.
  std::vector<Point> hard_centers;  // of the finite cells of not_in_doubles
  std::vector<Vec3> rays;           // of the infinite cells

  bool is_lean() const { return centers.empty(); }
};

// Complexity: O(cells). Deterministic: each center is computed from the cell's vertices in
// lexicographic order, so equal cells give equal bits.
Dual voronoi_dual(const Triangulation& triangulation, const Execution& execution = {});

// The element of Dual::centers of one cell, bit for bit: for stages that look at few cells. O(1).
Point voronoi_vertex(const Triangulation& triangulation, CellId c);

// Overload for callers that already have a dual, lean or not: O(1), O(log hard centers) if lean.
Point center_of(const Triangulation& triangulation, const Dual& dual, CellId c);

// Finite cells with their Voronoi vertices, a few at a time, for stages that go over many: as many
// batches of geom/circumsphere_batch.h as it takes. What is behind the last cell means nothing.
inline constexpr std::size_t max_block_cells = 128;
struct CellBlock {
  std::array<CircumcenterBatch, max_block_cells / circumcenter_batch_size> batches;
  std::size_t size = 0;  // cells

  std::span<const CircumcenterBatch> used() const {
    return std::span(batches).first((size + circumcenter_batch_size - 1) / circumcenter_batch_size);
  }
  Point center(std::size_t k) const {
    const BatchOfPoints& centers = batches[k / circumcenter_batch_size].centers;
    const std::size_t lane = k % circumcenter_batch_size;
    return {centers[0][lane], centers[1][lane], centers[2][lane]};
  }
};

// Per-vertex arrays that the caller reads while it works on a block, if any. Callers that go over
// consecutive runs name them, so that their elements are prefetched one run ahead.
struct ReadSoon {
  const Vec3* vectors = nullptr;  // not without the other
  const void* words = nullptr;    // of 8 bytes
};

// Fills in the block: with the cells first, first + 1, ..., or with cells anywhere. Of a run the
// points of the next one are prefetched.
// Preconditions: finite cells, at most max_block_cells. Complexity: O(cells).
void load_run(const Triangulation& triangulation, const Dual& dual, CellId first, std::size_t count,
              CellBlock& block, const ReadSoon& soon = {});
void load_cells(const Triangulation& triangulation, const Dual& dual, std::span<const CellId> cells,
                CellBlock& block);
// The same without a dual, for stages that look at few of all cells.
void load_cells(const Triangulation& triangulation, std::span<const CellId> cells,
                CellBlock& block);

// Calls visit(cells, their block) for the finite ones of some cells, a few at a time, in their
// order. Complexity: O(cells).
template <class Visit>
void for_each_block(const Triangulation& triangulation, std::span<const CellId> cells,
                    Visit visit) {
  CellBlock block;
  std::array<CellId, max_block_cells> finite;
  for (std::size_t next = 0; next < cells.size();) {
    std::size_t count = 0;
    for (; next < cells.size() && count < max_block_cells; ++next) {
      if (!triangulation.is_infinite(cells[next])) finite[count++] = cells[next];
    }
    if (count == 0) return;
    load_cells(triangulation, std::span(finite).first(count), block);
    visit(std::span<const CellId>(finite).first(count), block);
  }
}

// A lean dual is made of what a stage notes down that goes over all finite cells anyway: in parts
// of successive cells, put together in their order.
struct HardCenters {
  std::size_t exact_centers = 0;
  std::size_t facet_fallbacks = 0;
  std::vector<CellId> cells;
  std::vector<Point> centers;
};
// As load_run, without a dual.
void load_new_run(const Triangulation& triangulation, CellId first, std::size_t count,
                  CellBlock& block, HardCenters& hard, const ReadSoon& soon = {});
// Complexity: O(hard centers + infinite cells), parallel.
Dual lean_dual(const Triangulation& triangulation, std::span<const HardCenters> parts,
               const Execution& execution = {});

// The dual of a finite facet: segment between two Voronoi vertices, or a ray.
struct DualEdge {
  Point from;  // a Voronoi vertex (of the finite cell if the other one is infinite)
  Vec3 to;     // the other Voronoi vertex, or the unit direction of the ray
  bool is_ray = false;
};

// Precondition: f is a finite facet. O(1).
DualEdge dual_edge(const Triangulation& triangulation, const Dual& dual, FacetId f);

}  // namespace cocoon
