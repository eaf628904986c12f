#include "update/cloud/layers.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/messages/require_size.h"
#include "geom/search/equal_points.h"
#include "geom/search/nearest_point.h"
#include "geom/search/neighbor_distance.h"
#include "geom/search/thin_points.h"

namespace cocoon {

namespace {

// So few are always flat, or nearly.
constexpr std::size_t fewest = 5;

// Offsets in units in which none is long. None if they lie on a line. Sorts them: sums depend on
// the order.
std::optional<double> thickness(std::vector<Vec3>& offsets) {
  std::sort(offsets.begin(), offsets.end());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Vec3& d : offsets) mean += Eigen::Vector3d(d.x, d.y, d.z);
  mean /= static_cast<double>(offsets.size());
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vec3& d : offsets) {
    const Eigen::Vector3d v = Eigen::Vector3d(d.x, d.y, d.z) - mean;
    moments += v * v.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& principal = solver.eigenvalues();  // increasing
  if (!(principal[1] > 0)) return {};
  return std::sqrt(std::max(principal[0], 0.0) / principal[1]);
}

}  // namespace

FewSamples few_of_layers(Points samples, double spread) {
  constexpr std::size_t neighbor = 8;
  FewSamples few;
  if (!(spread > 0)) return few;
  few.distance = spread * median_neighbor_distance(samples, neighbor);
  if (few.distance > 0) few.kept = thin_points(samples, few.distance);
  return few;
}

double layer_thickness(Points samples, std::span<const PointId> at, double reach,
                       const Execution& execution) {
  for (const PointId p : at) {
    require_index("layer_thickness", "sample", p.index(), samples.size());
  }
  if (at.empty() || !(reach > 0)) return 0;
  const std::vector<Point> different = distinct_points(samples);
  const NearestPointTree tree(different, execution);
  std::vector<std::optional<double>> around(at.size());
  parallel_chunks(execution, {"layer_thickness"}, at.size(), 1024,
                  [&](std::size_t begin, std::size_t end) {
                    std::vector<Vec3> offsets;
                    for (std::size_t k = begin; k < end; ++k) {
                      const Point& center = samples[at[k].index()];
                      offsets.clear();
                      tree.any_near(center, reach, [&](PointId q) {
                        offsets.push_back((different[q.index()] - center) / reach);
                        return false;
                      });
                      if (offsets.size() >= fewest) around[k] = thickness(offsets);
                    }
                  });
  std::vector<double> found;
  for (const std::optional<double>& here : around) {
    if (here) found.push_back(*here);
  }
  return median(std::move(found));
}

}  // namespace cocoon
