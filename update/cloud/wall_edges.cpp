#include "update/cloud/wall_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geom/search/box_tree.h"
#include "update/cloud/rim_edges.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// All edges of a rim, with the normals of the surface at their beginnings.
class Walls {
 public:
  Walls(const CloudRim& rim, const WallEdgeOptions& options)
      : options_(options), spacing_(rim.spacing) {
    for (const RimLoop& loop : rim.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        middles_.push_back(0.5 * (loop.points[i] + loop.points[loop.next(i)]));
        normals_.push_back(loop.normals[i]);
      }
    }
    tree_ = tree_of_points(middles_);
  }

  // Whether there is another side of a thin wall over or under this edge.
  bool have_side_opposite(const Point& middle, const Vec3& normal) const {
    const double thickest = options_.thickest * spacing_;
    double bound = thickest * thickest;
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
  const bool has_seams = std::any_of(rim.loops.begin(), rim.loops.end(),
                                     [](const RimLoop& loop) { return loop.is_partial(); });
  if (!has_seams || options.reach == 0) return;
  std::vector<RimEdge> edges = ends_of_cloud(rim);
  const Walls walls(rim, options);
  std::erase_if(edges, [&](const RimEdge& edge) {
    return !walls.have_side_opposite(edge.middle, rim.loops[edge.loop].normals[edge.index]);
  });
  const double reach = options.reach * rim.spacing;
  const std::vector<Point> samples = samples_near(clouds, edges, reach);
  const std::vector<SampleBeyond> beyond =
      samples_beyond(edges, samples, reach, -options.max_inward * rim.spacing);
  const std::vector<std::uint8_t> goes_on = edges_with_steps(
      model, edges, samples, beyond,
      {options.min_step * rim.spacing, 2 * reach, options.off_model * rim.spacing});
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (goes_on[k] == 0) continue;
    RimLoop& loop = rim.loops[edges[k].loop];
    if (loop.inner.empty()) loop.inner.assign(loop.size(), 0);
    loop.inner[edges[k].index] = 1;
    ++rim.wall_edges;
  }
}

}  // namespace cocoon
