#include "delaunay/voronoi_dual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cocoon {
namespace {

constexpr std::size_t grain = 8192;  // cells per chunk of the parallel loop

// For the counters of one chunk; added up in the end, in any order: sums of integers.
struct ChunkCounts {
  std::size_t extended_precision = 0;
  std::size_t facet_fallbacks = 0;
};

struct Circumcenter {
  Point center;
  bool extended_precision = false;
  bool facet_fallback = false;
};

// c - a = (|b-a|^2 (c-a)x(d-a) + |c-a|^2 (d-a)x(b-a) + |d-a|^2 (b-a)x(c-a)) / (2 det)
Circumcenter circumcenter(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = d - a;
  const Vec3 vw = cross(v, w);
  const Vec3 numerator =
      squared_norm(u) * vw + squared_norm(v) * cross(w, u) + squared_norm(w) * cross(u, v);
  Circumcenter result{a + numerator / (2 * dot(u, vw))};
  if (!is_finite(result.center)) {
    result = {(a + b + c + d) / 4};
    result.facet_fallback = true;
  }
  return result;
}

Circumcenter cell_center(const Triangulation& triangulation, const Cell& cell) {
  // Lexicographic order: equal cells give equal bits, whatever their vertices' ids.
  std::array<Point, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = triangulation.point(cell.vertices[i]);
  std::sort(p.begin(), p.end());
  return circumcenter(p[0], p[1], p[2], p[3]);
}

// Outward unit normal of the hull facet of an infinite cell.
Vec3 ray_direction(const Triangulation& triangulation, const Cell& cell) {
  std::array<Point, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = triangulation.point(cell.vertices[i]);
  // A cell with a point beyond the facet as vertex 3 has orient3d > 0: (p1-p0)x(p2-p0) points
  // outward. Sorting for equal bits may exchange that for its opposite; an odd permutation does.
  bool odd = false;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) odd ^= p[j] < p[i];
  }
  std::sort(p.begin(), p.end());
  const Vec3 u = p[1] - p[0];
  const Vec3 v = p[2] - p[0];
  // To edges of about length one by a power of two, which is exact: no product over- or underflows.
  const auto scaled = [](const Vec3& e) {
    const int exponent = -std::ilogb(std::max({std::abs(e.x), std::abs(e.y), std::abs(e.z)}));
    return Vec3{std::ldexp(e.x, exponent), std::ldexp(e.y, exponent), std::ldexp(e.z, exponent)};
  };
  const Vec3 normal = unit(cross(scaled(u), scaled(v)));
  return odd ? -normal : normal;
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
                    for (std::size_t i = begin; i < end; ++i) {
                      const CellId c(i);
                      const Cell& cell = triangulation.cell(c);
                      if (triangulation.is_infinite(c)) {
                        dual.centers[c] = ray_direction(triangulation, cell);
                        continue;
                      }
                      const Circumcenter result = cell_center(triangulation, cell);
                      dual.centers[c] = result.center;
                      if (result.extended_precision) ++count.extended_precision;
                      if (result.facet_fallback) ++count.facet_fallbacks;
                    }
                  });
  for (const ChunkCounts& count : counts) {
    dual.extended_precision += count.extended_precision;
    dual.facet_fallbacks += count.facet_fallbacks;
  }
  report_progress(execution, "voronoi_dual", 1);
  return dual;
}

DualEdge dual_edge(const Triangulation& triangulation, const Dual& dual, FacetId f) {
  CellId from = cell_of(f);
  CellId to = cell_of(triangulation.mirror(f));
  if (triangulation.is_infinite(from)) std::swap(from, to);
  return {dual.centers[from], dual.centers[to], triangulation.is_infinite(to)};
}

}  // namespace cocoon
