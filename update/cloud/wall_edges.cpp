#include "update/cloud/wall_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geom/search/box_tree.h"
#include "update/cloud/rim_edges.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// At edge i: from both of its ends, so that it does not matter which way the loop runs.
Vec3 normal_at(const RimLoop& loop, std::size_t i) {
  return unit(loop.normals[i] + loop.normals[loop.next(i)]);
}

// All edges of a rim, with the normals of the surface at them.
class Walls {
 public:
  Walls(const CloudRim& rim, const WallEdgeOptions& options)
      : options_(options), spacing_(rim.spacing) {
    for (const RimLoop& loop : rim.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        middles_.push_back(loop.middle(i));
        normals_.push_back(normal_at(loop, i));
      }
    }
    tree_ = tree_of_points(middles_);
  }

  // Whether there is another side of a thin wall over or under this edge.
  bool have_side_opposite(const Point& middle, const Vec3& normal) const {
    const double thickest = options_.thickest * spacing_;
    const double bound = thickest * thickest;
    bool found = false;
    tree_.visit_near(middle, bound, [&](std::uint32_t slot) {
      const std::uint32_t other = tree_.items()[slot];
      found = found || is_opposite(middles_[other] - middle, normal, normals_[other]);
      return found ? 0 : bound;
    });
    return found;
  }

 private:
  bool is_opposite(const Vec3& way, const Vec3& normal, const Vec3& other) const {
    const double distance = norm(way);
    return distance >= options_.thinnest * spacing_ && distance <= options_.thickest * spacing_ &&
           std::abs(dot(normal, other)) >= options_.min_normal_cosine &&
           std::abs(dot(way, normal)) >= options_.min_way_cosine * distance;
  }

  const WallEdgeOptions& options_;
  double spacing_;
  std::vector<Point> middles_;
  std::vector<Vec3> normals_;
  BoxTree tree_;
};

}  // namespace

void mark_wall_edges(const ModelIndex& model, std::span<const std::vector<Point>> clouds,
                     CloudRim& rim, const WallEdgeOptions& options) {
  require_options("mark_wall_edges", options);
  if (rim.seam_edges == 0 || options.reach == 0) return;
  std::vector<RimEdge> edges = ends_of_cloud(rim);
  const std::size_t ends = edges.size();
  const Walls walls(rim, options);
  std::erase_if(edges, [&](const RimEdge& edge) {
    return !walls.have_side_opposite(edge.middle, normal_at(rim.loops[edge.loop], edge.index));
  });
  const double reach = options.reach * rim.spacing;
  const std::vector<Point> samples = samples_near(clouds, edges, reach);
  const std::vector<SampleBeyond> beyond =
      samples_beyond(edges, samples, reach, -options.max_inward * rim.spacing);
  const std::vector<std::uint8_t> goes_on = edges_with_steps(
      model, edges, samples, beyond,
      {options.min_step * rim.spacing, 2 * reach, options.off_model * rim.spacing});
  const auto count = static_cast<std::size_t>(std::count(goes_on.begin(), goes_on.end(), 1));
  if (count == ends) return;  // a rim has to be left
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (goes_on[k] == 0) continue;
    RimLoop& loop = rim.loops[edges[k].loop];
    if (loop.inner.empty()) loop.inner.assign(loop.size(), 0);
    loop.inner[edges[k].index] = 1;
  }
  rim.wall_edges += count;
  rim.seam_edges += count;
}

}  // namespace cocoon
