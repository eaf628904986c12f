#include "cocone/noise/remaining_samples.h"

#include <algorithm>
#include <utility>

#include "geom/off_plane.h"
#include "geom/working_scale.h"

namespace cocoon {

RemainingSamples::RemainingSamples(Points points, const NoiseOptions& noise, FlatSamples flat,
                                   const DelaunayOptions& options, const Execution& execution)
    : noise_(noise),
      flat_(flat),
      options_(options),
      execution_(execution),
      points_(points.begin(), points.end()),
      kept_(points.size(), 1) {
  for (std::size_t i = 0; i < points.size(); ++i) inputs_.push_back(PointId(i));
  triangulate();
}

void RemainingSamples::triangulate() {
  const std::vector<Point> moved =
      flat_ == FlatSamples::moved ? moved_off_plane(points_) : std::vector<Point>();
  const Points points = moved.empty() ? Points(points_) : Points(moved);
  // Each time: what has gone may have been far off, and the rest so small beside it that squares of
  // lengths vanished.
  scale_ = working_scale(points);
  const std::vector<Point> copy = scale_ != 1 ? scaled(points, scale_) : std::vector<Point>();
  triangulation_ =
      delaunay(scale_ != 1 ? Points(copy) : points, options_, execution_).triangulation;
  stars_ = vertex_stars(triangulation_, execution_);
  spacing_ = sample_spacing(triangulation_, stars_, noise_.neighbors, execution_);
}

void RemainingSamples::leave_out(const VertexSet& out) {
  leave_out(out, triangulation_.vertex_of_point());
}

void RemainingSamples::leave_out(const VertexSet& out,
                                 const IdVector<PointId, VertexId>& vertex_of_point) {
  std::vector<Point> points;
  std::vector<PointId> inputs;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (out[vertex_of_point[PointId(i)]] != 0) {
      kept_[inputs_[i]] = 0;
    } else {
      points.push_back(points_[i]);
      inputs.push_back(inputs_[i]);
    }
  }
  points_ = std::move(points);
  inputs_ = std::move(inputs);
}

VertexSet RemainingSamples::outliers() const {
  return outlier_samples(triangulation_, stars_, spacing_, noise_.outlier_ratio, execution_);
}

RemainingSamples::Outliers RemainingSamples::leave_out_outliers(const VertexSet& first,
                                                                const VertexSet& spared) {
  // Without one that goes there are no rounds, for which the triangulation would be used up.
  bool any_goes = false;
  for (const VertexId v : first.ids()) {
    any_goes |= first[v] != 0 && (spared.empty() || spared[v] == 0);
  }
  if (!any_goes) {
    return {.spared = static_cast<std::size_t>(std::count(first.begin(), first.end(), 1))};
  }
  const IdVector<PointId, VertexId> vertex_of_point = triangulation_.vertex_of_point();
  const OutlierRounds outliers = outlier_rounds(std::move(triangulation_), std::move(spacing_),
                                                first, spared, noise_, flat_, execution_);
  leave_out(outliers.out, vertex_of_point);
  triangulate();
  Outliers all{outliers.count, outliers.spared, outliers.rounds};
  if (outliers.is_flat) {
    const Outliers in_plane = leave_out_outliers(this->outliers());
    all.count += in_plane.count;
    all.rounds += in_plane.rounds;
  }
  return all;
}

}  // namespace cocoon
