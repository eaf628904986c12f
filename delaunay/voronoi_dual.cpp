#include "delaunay/voronoi_dual.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

#include "delaunay/block_lanes.h"
#include "geom/circumsphere.h"
#include "geom/triangle_normal.h"

namespace cocoon {
namespace {

constexpr std::size_t grain = 8192;  // cells per chunk of the parallel loop

// Notes down how a center or direction was obtained.
void count_level(CenterLevel level, CellId c, HardCenters& hard) {
  if (level == CenterLevel::doubles) return;
  ++(level == CenterLevel::exact ? hard.exact_centers : hard.facet_fallbacks);
  hard.cells.push_back(c);
}

// Voronoi vertex of a finite cell.
Circumcenter center_of_cell(const Triangulation& triangulation, CellId cell) {
  const auto& [a, b, c, d] = triangulation.cell(cell).vertices;
  return circumcenter(triangulation.point(a), triangulation.point(b), triangulation.point(c),
                      triangulation.point(d));
}

void set_center(CellBlock& block, std::size_t k, const Point& center) {
  BatchOfPoints& centers = block.batches[k / circumcenter_batch_size].centers;
  const std::size_t lane = k % circumcenter_batch_size;
  centers[0][lane] = center.x;
  centers[1][lane] = center.y;
  centers[2][lane] = center.z;
}

// Fills in the centers that are not certified: otherwise(k) of cell k of the block.
template <class Otherwise>
void complete_centers(CellBlock& block, Otherwise otherwise) {
  for (std::size_t first = 0; first < block.size; first += circumcenter_batch_size) {
    const std::size_t size = std::min(circumcenter_batch_size, block.size - first);
    const unsigned all = (1U << size) - 1U;
    for (unsigned rest = all & ~block.batches[first / circumcenter_batch_size].certified; rest != 0;
         rest &= rest - 1) {
      const std::size_t k = first + static_cast<std::size_t>(std::countr_zero(rest));
      set_center(block, k, otherwise(k));
    }
  }
}

void compute_centers(CellBlock& block) {
  circumcenters_in_doubles(std::span(block.batches).first(block.used().size()));
}

// Voronoi vertex of a finite cell that no batch certifies.
Point hard_center(const Triangulation& triangulation, const Dual& dual, CellId c) {
  const auto end =
      dual.not_in_doubles.begin() + static_cast<std::ptrdiff_t>(dual.hard_centers.size());
  const auto place = std::lower_bound(dual.not_in_doubles.begin(), end, c);
  if (place == end || *place != c) return center_of_cell(triangulation, c).center;
  return dual.hard_centers[static_cast<std::size_t>(place - dual.not_in_doubles.begin())];
}

// Direction of the Voronoi ray of an infinite cell: with a point beyond its hull facet as vertex 3
// the cell would have orient3d > 0, so the facet's normal in the order of the vertices points out.
Vec3 ray_direction(const Triangulation& triangulation, CellId cell, HardCenters& hard) {
  const auto& [a, b, c, infinite] = triangulation.cell(cell).vertices;
  const TriangleNormal normal =
      triangle_normal(triangulation.point(a), triangulation.point(b), triangulation.point(c));
  count_level(normal.exact ? CenterLevel::exact : CenterLevel::doubles, cell, hard);
  return normal.direction;
}

// Puts the notes of successive cells behind those that the dual has.
void append(std::span<const HardCenters> parts, Dual& dual) {
  for (const HardCenters& part : parts) {
    dual.exact_centers += part.exact_centers;
    dual.facet_fallbacks += part.facet_fallbacks;
    dual.not_in_doubles.insert(dual.not_in_doubles.end(), part.cells.begin(), part.cells.end());
    dual.hard_centers.insert(dual.hard_centers.end(), part.centers.begin(), part.centers.end());
  }
}

// Of all infinite cells.
template <class Keep>
void find_rays(const Triangulation& triangulation, Dual& dual, const Execution& execution,
               Keep keep) {
  const std::size_t finite = triangulation.num_finite_cells();
  const std::size_t count = triangulation.num_cells() - finite;
  std::vector<HardCenters> hard((count + grain - 1) / grain);
  parallel_chunks(execution, count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      keep(k, ray_direction(triangulation, CellId(finite + k), hard[begin / grain]));
    }
  });
  append(hard, dual);
}

}  // namespace

Dual voronoi_dual(const Triangulation& triangulation, const Execution& execution) {
  report_progress(execution, "voronoi_dual", 0);
  Dual dual;
  dual.centers.resize(triangulation.num_cells());
  const std::size_t finite = triangulation.num_finite_cells();
  std::vector<HardCenters> hard((finite + grain - 1) / grain);
  parallel_chunks(execution, finite, grain, [&](std::size_t begin, std::size_t end) {
    CellBlock block;
    for (std::size_t first = begin; first < end; first += max_block_cells) {
      const std::size_t count = std::min(max_block_cells, end - first);
      load_new_run(triangulation, CellId(first), count, block, hard[begin / grain]);
      for (std::size_t k = 0; k < count; ++k) dual.centers[CellId(first + k)] = block.center(k);
    }
  });
  append(hard, dual);
  dual.hard_centers = {};
  find_rays(triangulation, dual, execution,
            [&](std::size_t k, const Vec3& ray) { dual.centers[CellId(finite + k)] = ray; });
  report_progress(execution, "voronoi_dual", 1);
  return dual;
}

void load_new_run(const Triangulation& triangulation, CellId first, std::size_t count,
                  CellBlock& block, HardCenters& hard, const ReadSoon& soon) {
  load_centers(triangulation, first, count, soon, block);
  complete_centers(block, [&](std::size_t k) {
    const CellId c(first.index() + k);
    const Circumcenter found = center_of_cell(triangulation, c);
    count_level(found.level, c, hard);
    if (found.level != CenterLevel::doubles) hard.centers.push_back(found.center);
    return found.center;
  });
}

Dual lean_dual(const Triangulation& triangulation, std::span<const HardCenters> parts,
               const Execution& execution) {
  Dual dual;
  append(parts, dual);
  dual.rays.resize(triangulation.num_cells() - triangulation.num_finite_cells());
  find_rays(triangulation, dual, execution,
            [&](std::size_t k, const Vec3& ray) { dual.rays[k] = ray; });
  return dual;
}

void load_run(const Triangulation& triangulation, const Dual& dual, CellId first, std::size_t count,
              CellBlock& block, const ReadSoon& soon) {
  const auto cell_at = [first](std::size_t k) { return CellId(first.index() + k); };
  if (dual.is_lean()) {
    load_centers(triangulation, first, count, soon, block);
    complete_centers(block,
                     [&](std::size_t k) { return hard_center(triangulation, dual, cell_at(k)); });
    return;
  }
  load_corners(triangulation, first, count, block);
  for (std::size_t k = 0; k < count; ++k) set_center(block, k, dual.centers[cell_at(k)]);
}

void load_cells(const Triangulation& triangulation, const Dual& dual, std::span<const CellId> cells,
                CellBlock& block) {
  // They lie here and there in memory: all are asked for in advance.
  for (const CellId c : cells) {
    __builtin_prefetch(&triangulation.cell(c));
    if (!dual.is_lean()) __builtin_prefetch(&dual.centers[c]);
  }
  load_corners(triangulation, cells, block);
  if (dual.is_lean()) {
    compute_centers(block);
    complete_centers(block,
                     [&](std::size_t k) { return hard_center(triangulation, dual, cells[k]); });
    return;
  }
  for (std::size_t k = 0; k < cells.size(); ++k) set_center(block, k, dual.centers[cells[k]]);
}

void load_cells(const Triangulation& triangulation, std::span<const CellId> cells,
                CellBlock& block) {
  load_corners(triangulation, cells, block);
  compute_centers(block);
  complete_centers(block,
                   [&](std::size_t k) { return center_of_cell(triangulation, cells[k]).center; });
}

Point center_of(const Triangulation& triangulation, const Dual& dual, CellId c) {
  if (!dual.is_lean()) return dual.centers[c];
  if (triangulation.is_infinite(c)) return dual.rays[c.index() - triangulation.num_finite_cells()];
  return hard_center(triangulation, dual, c);
}

Point voronoi_vertex(const Triangulation& triangulation, CellId c) {
  HardCenters uncounted;
  return triangulation.is_infinite(c) ? ray_direction(triangulation, c, uncounted)
                                      : center_of_cell(triangulation, c).center;
}

DualEdge dual_edge(const Triangulation& triangulation, const Dual& dual, FacetId f) {
  CellId from = cell_of(f);
  CellId to = cell_of(triangulation.mirror(f));
  if (triangulation.is_infinite(from)) std::swap(from, to);
  return {center_of(triangulation, dual, from), center_of(triangulation, dual, to),
          triangulation.is_infinite(to)};
}

}  // namespace cocoon
