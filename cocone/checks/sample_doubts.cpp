#include "cocone/checks/sample_doubts.h"

#include <cstddef>
#include <utility>

#include "cocone/cocones.h"
#include "cocone/noise_filter.h"
#include "cocone/poles.h"
#include "cocone/samples/cocone_radii.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/delaunay.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"
#include "geom/arrays/median.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

void find_sparse(const Triangulation& triangulation, const IdVector<VertexId, double>& spacing,
                 std::size_t most, SampleDoubts& doubts) {
  doubts.spacing = median({spacing.begin(), spacing.end()});
  for (const VertexId v : spacing.ids()) {
    doubts.sparse.push_back({triangulation.point(v), 1, spacing[v]});
  }
  keep_largest(doubts.sparse, most);
}

void find_ratios(const Triangulation& triangulation, const IdVector<VertexId, double>& spacing,
                 const ReconstructOptions& options, const Execution& execution,
                 SampleDoubts& doubts) {
  auto [dual, poles, sides] = dual_and_poles(triangulation, options.cocone.cosine, execution);
  const Cocones cocones = intersect_cocones(triangulation, std::move(sides), execution);
  const IdVector<VertexId, double> radii =
      cocone_radii(triangulation, dual, poles, cocones, options.boundary.radius_mode, execution);
  std::vector<double> heights;
  for (const VertexId v : radii.ids()) {
    if (poles.degenerate[v] != 0 || poles.heights[v] == 0) continue;
    heights.push_back(poles.heights[v] / spacing[v]);
    const double ratio = radii[v] / poles.heights[v];
    const Point& at = triangulation.point(v);
    if (ratio < doubts.least_ratio || (ratio == doubts.least_ratio && at < doubts.best)) {
      doubts.least_ratio = ratio;
      doubts.best = at;
    }
  }
  doubts.height = median(std::move(heights));
}

}  // namespace

SampleDoubts sample_doubts(Points points, const ReconstructOptions& options,
                           const SurfaceDoubtOptions& doubts, const Execution& execution) {
  const ReconstructOptions effective = effective_options(options);
  const double scale = working_scale(points);
  const Triangulation triangulation =
      delaunay(scaled(points, scale), effective.delaunay, execution).triangulation;
  const IdVector<VertexId, double> spacing = sample_spacing(
      triangulation, vertex_stars(triangulation, execution), SpacingCache::edges, execution);
  SampleDoubts result;
  find_sparse(triangulation, spacing, doubts.max_spots, result);
  find_ratios(triangulation, spacing, effective, execution, result);
  result.spacing /= scale;
  result.best = (1 / scale) * result.best;
  for (DoubtfulSpot& spot : result.sparse) {
    spot.at = (1 / scale) * spot.at;
    spot.size /= scale;
  }
  return result;
}

}  // namespace cocoon
