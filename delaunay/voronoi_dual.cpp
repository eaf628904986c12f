#include "delaunay/voronoi_dual.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geom/circumsphere.h"
#include "geom/circumsphere_batch.h"
#include "geom/triangle_normal.h"

namespace cocoon {
namespace {

constexpr std::size_t grain = 8192;  // cells per chunk of the parallel loop

// The counters of one chunk.
struct ChunkCounts {
  std::size_t exact = 0;
  std::size_t facet_fallbacks = 0;
  std::vector<CellId> not_in_doubles;

  void add(CellId c, CenterLevel level) {
    if (level == CenterLevel::doubles) return;
    ++(level == CenterLevel::exact ? exact : facet_fallbacks);
    not_in_doubles.push_back(c);
  }
};

// Voronoi vertex of a finite cell.
Point cell_center(const Triangulation& triangulation, CellId cell, ChunkCounts& counts) {
  const auto& [a, b, c, d] = triangulation.cell(cell).vertices;
  const Circumcenter result = circumcenter(triangulation.point(a), triangulation.point(b),
                                           triangulation.point(c), triangulation.point(d));
  counts.add(cell, result.level);
  return result.center;
}

// Voronoi vertices of the cells begin .. end, all finite, in batches as far as they go.
void cell_centers(const Triangulation& triangulation, CellId begin, CellId end, Dual& dual,
                  ChunkCounts& counts) {
  CircumcenterBatch batch;
  for (CellId first = begin; first < end;) {
    const std::size_t size = std::min(circumcenter_batch_size, end.index() - first.index());
    unsigned certified = 0;
    if (size == circumcenter_batch_size) {
      for (std::size_t i = 0; i < size; ++i) {
        const Cell& cell = triangulation.cell(CellId(first.index() + i));
        for (std::size_t corner = 0; corner < 4; ++corner) {
          const Point& p = triangulation.point(cell.vertices[corner]);
          batch.corners[corner][0][i] = p.x;
          batch.corners[corner][1][i] = p.y;
          batch.corners[corner][2][i] = p.z;
        }
      }
      certified = circumcenters_in_doubles(batch);
    }
    for (std::size_t i = 0; i < size; ++i, ++first) {
      dual.centers[first] = ((certified >> i) & 1U) != 0
                                ? batch.centers[i]
                                : cell_center(triangulation, first, counts);
    }
  }
}

// Direction of the Voronoi ray of an infinite cell: with a point beyond its hull facet as vertex 3
// the cell would have orient3d > 0, so the facet's normal in the order of the vertices points out.
Vec3 ray_direction(const Triangulation& triangulation, CellId cell, ChunkCounts& counts) {
  const auto& [a, b, c, infinite] = triangulation.cell(cell).vertices;
  const TriangleNormal normal =
      triangle_normal(triangulation.point(a), triangulation.point(b), triangulation.point(c));
  counts.add(cell, normal.exact ? CenterLevel::exact : CenterLevel::doubles);
  return normal.direction;
}

}  // namespace

Dual voronoi_dual(const Triangulation& triangulation, const Execution& execution) {
  report_progress(execution, "voronoi_dual", 0);
  Dual dual;
  dual.centers.resize(triangulation.num_cells());
  std::vector<ChunkCounts> counts((triangulation.num_cells() + grain - 1) / grain);
  parallel_chunks(execution, triangulation.num_cells(), grain,
                  [&](std::size_t begin, std::size_t end) {
                    ChunkCounts& count = counts[begin / grain];
                    const CellId last(end);
                    const CellId infinite(std::clamp(triangulation.num_finite_cells(), begin, end));
                    cell_centers(triangulation, CellId(begin), infinite, dual, count);
                    for (CellId c = infinite; c < last; ++c) {
                      dual.centers[c] = ray_direction(triangulation, c, count);
                    }
                  });
  for (const ChunkCounts& count : counts) {
    dual.extended_precision += count.exact;
    dual.facet_fallbacks += count.facet_fallbacks;
    dual.not_in_doubles.insert(dual.not_in_doubles.end(), count.not_in_doubles.begin(),
                               count.not_in_doubles.end());
  }
  report_progress(execution, "voronoi_dual", 1);
  return dual;
}

Point voronoi_vertex(const Triangulation& triangulation, CellId c) {
  ChunkCounts uncounted;
  return triangulation.is_infinite(c) ? ray_direction(triangulation, c, uncounted)
                                      : cell_center(triangulation, c, uncounted);
}

DualEdge dual_edge(const Triangulation& triangulation, const Dual& dual, FacetId f) {
  CellId from = cell_of(f);
  CellId to = cell_of(triangulation.mirror(f));
  if (triangulation.is_infinite(from)) std::swap(from, to);
  return {dual.centers[from], dual.centers[to], triangulation.is_infinite(to)};
}

}  // namespace cocoon
