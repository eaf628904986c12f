#include "update/checks/rim_shift.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "geom/messages/require_size.h"
#include "update/model/sample_heights.h"
#include "update/stage_options.h"

namespace cocoon {
namespace {

// A rim point over the plane of its facet.
struct Height {
  Eigen::Vector3d normal;  // unit
  double height = 0;
};

std::vector<Height> heights_of(const ModelIndex& model, const CloudRim& rim,
                               const Overlap& overlap) {
  std::vector<Height> heights;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (overlap.loops[l].match != LoopMatch::on_model) continue;
    const RimLoop& loop = rim.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const TriangleId facet = overlap.loops[l].facets[i];
      if (loop.is_inner_point(i) || facet.is_none()) continue;
      const Vec3 n = model.normal(facet);
      const double height = dot(loop.points[i] - model.centroid(facet), n);
      heights.push_back({Eigen::Vector3d(n.x, n.y, n.z), height});
    }
  }
  return heights;
}

std::size_t num_on_model(const ModelIndex& model, Points samples, double distance) {
  return samples.size() - ids_off_model(model, samples, distance).size();
}

}  // namespace

Vec3 rim_shift(const ModelIndex& model, const CloudRim& rim, const Overlap& overlap,
               const ShiftOptions& options) {
  require_options("rim_shift", options);
  require_size("rim_shift", "loops of the overlap", overlap.loops.size(), rim.loops.size());
  const std::vector<Height> heights = heights_of(model, rim, overlap);
  if (heights.size() < options.min_points) return {};
  const auto all = static_cast<double>(heights.size());
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t round = 0; round < options.rounds; ++round) {
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    Eigen::Vector3d moments = Eigen::Vector3d::Zero();
    double used = 0;
    for (const Height& h : heights) {
      const double residual = std::abs(h.height - h.normal.dot(shift));
      if (round > 0 && residual > options.max_residual * rim.spacing) continue;
      normals += h.normal * h.normal.transpose();
      moments += h.height * h.normal;
      ++used;
    }
    if (used < options.min_share * all) return {};
    normals += options.prior * used * Eigen::Matrix3d::Identity();
    shift = normals.ldlt().solve(moments);
  }
  return {shift.x(), shift.y(), shift.z()};
}

Vec3 cloud_shift(const ModelIndex& model, Points samples, const CloudRim& rim,
                 const Overlap& overlap, const ShiftOptions& options) {
  const Vec3 shift = rim_shift(model, rim, overlap, options);
  if (!options.is_too_long(norm(shift), rim.spacing)) return shift;
  std::vector<Point> moved_back(samples.begin(), samples.end());
  for (Point& p : moved_back) p = p - shift;
  const double fit = options.fit_distance * rim.spacing;
  const bool is_of_change =
      num_on_model(model, samples, fit) > num_on_model(model, moved_back, fit);
  return is_of_change ? Vec3{} : shift;
}

}  // namespace cocoon
