#include "delaunay/voronoi/lean_dual.h"

#include <algorithm>

namespace cocoon {

void HardCenters::note(CenterLevel level, CellId c) {
  if (level == CenterLevel::doubles) return;
  ++(level == CenterLevel::exact ? exact_centers : facet_fallbacks);
  cells.push_back(c);
}

Circumcenter circumcenter_of(const Triangulation& triangulation, CellId finite) {
  const auto& [a, b, c, d] = triangulation.cell(finite).vertices;
  return circumcenter(triangulation.point(a), triangulation.point(b), triangulation.point(c),
                      triangulation.point(d));
}

// With a point beyond its hull facet as vertex 3 the cell would have orient3d > 0, so the facet's
// normal in the order of the vertices points out.
TriangleNormal hull_normal(const Triangulation& triangulation, CellId infinite) {
  const auto& [a, b, c, at_infinity] = triangulation.cell(infinite).vertices;
  return triangle_normal(triangulation.point(a), triangulation.point(b), triangulation.point(c));
}

void append(std::span<const HardCenters> parts, Dual& dual) {
  for (const HardCenters& part : parts) {
    dual.exact_centers += part.exact_centers;
    dual.facet_fallbacks += part.facet_fallbacks;
    dual.not_in_doubles.insert(dual.not_in_doubles.end(), part.cells.begin(), part.cells.end());
    dual.hard_centers.insert(dual.hard_centers.end(), part.centers.begin(), part.centers.end());
  }
}

void find_rays(const Triangulation& triangulation, std::span<Vec3> rays, Dual& dual,
               const Execution& execution) {
  const std::size_t finite = triangulation.num_finite_cells();
  std::vector<HardCenters> hard((rays.size() + dual_grain - 1) / dual_grain);
  parallel_chunks(execution, rays.size(), dual_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const CellId c(finite + k);
      const TriangleNormal normal = hull_normal(triangulation, c);
      hard[begin / dual_grain].note(normal.exact ? CenterLevel::exact : CenterLevel::doubles, c);
      rays[k] = normal.direction;
    }
  });
  append(hard, dual);
}

Dual lean_dual(const Triangulation& triangulation, std::span<const HardCenters> parts,
               const Execution& execution) {
  Dual dual;
  append(parts, dual);
  dual.rays.resize(triangulation.num_cells() - triangulation.num_finite_cells());
  find_rays(triangulation, dual.rays, dual, execution);
  return dual;
}

Point hard_center(const Triangulation& triangulation, const Dual& dual, CellId finite) {
  const auto end =
      dual.not_in_doubles.begin() + static_cast<std::ptrdiff_t>(dual.hard_centers.size());
  const auto place = std::lower_bound(dual.not_in_doubles.begin(), end, finite);
  if (place == end || *place != finite) return circumcenter_of(triangulation, finite).center;
  return dual.hard_centers[static_cast<std::size_t>(place - dual.not_in_doubles.begin())];
}

}  // namespace cocoon
