#include "update/joined_clouds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/points_of.h"
#include "geom/box.h"
#include "geom/search/equal_points.h"
#include "geom/search/nearest_point.h"
#include "geom/search/neighbor_distance.h"
#include "geom/search/thin_points.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// With room for several distances between samples, however they lie on their surface: most clouds
// are nowhere near each other, and need not be searched.
Box roomy_box(Points cloud) {
  constexpr double spacings = 4;
  const std::size_t different = cloud.size() - repeated_points(cloud).size();
  Box box = box_of(cloud);
  box.enlarge(spacings * norm(box.size()) / std::sqrt(static_cast<double>(different)));
  return box;
}

// A cloud that can be searched.
struct Samples {
  std::vector<Point> points;  // without equal ones
  NearestPointTree tree;
  double spacing;  // between a sample and its nearest one, the median of some
};

// The clouds, each made searchable when it is asked for.
class Clouds {
 public:
  explicit Clouds(std::span<const std::vector<Point>> clouds)
      : clouds_(clouds), samples_(clouds.size()) {
    for (const std::vector<Point>& cloud : clouds) {
      const bool finite =
          std::all_of(cloud.begin(), cloud.end(), [](const Point& p) { return is_finite(p); });
      boxes_.push_back(finite && cloud.size() > 1 ? roomy_box(cloud) : Box());
    }
  }

  bool boxes_overlap(std::size_t a, std::size_t b) const {
    return !boxes_[a].is_empty() && !boxes_[b].is_empty() && overlap(boxes_[a], boxes_[b]);
  }

  const Samples& operator[](std::size_t c) {
    if (!samples_[c]) {
      std::vector<Point> points = distinct_points(clouds_[c]);
      NearestPointTree tree(points);
      const double spacing = median_neighbor_distance(points, 1);
      samples_[c] = {std::move(points), std::move(tree), spacing};
    }
    return *samples_[c];
  }

  // The samples of a that lie near b, as a share of all of a.
  double share_near(std::size_t a, std::size_t b, double reach) {
    const NearestPointTree& others = (*this)[b].tree;
    const std::vector<Point>& points = (*this)[a].points;
    std::size_t near = 0;
    for (const Point& p : points) near += others.any_near(p, reach) ? 1U : 0U;
    return static_cast<double>(near) / static_cast<double>(points.size());
  }

 private:
  std::span<const std::vector<Point>> clouds_;
  std::vector<std::optional<Samples>> samples_;
  std::vector<Box> boxes_;  // empty: not to be asked
};

bool overlap_each_other(Clouds& clouds, std::size_t a, std::size_t b, const JoinOptions& options) {
  if (!clouds.boxes_overlap(a, b)) return false;
  const double reach = options.reach * std::max(clouds[a].spacing, clouds[b].spacing);
  if (!(reach > 0)) return false;
  return clouds.share_near(a, b, reach) >= options.min_share ||
         clouds.share_near(b, a, reach) >= options.min_share;
}

// Whether all that a member of joined clouds shows is shown by others that are much finer.
bool is_covered(Clouds& clouds, std::size_t c, std::span<const std::size_t> members,
                const JoinOptions& options) {
  // So the finest one is never covered.
  const double coarser = std::max(options.coarser, 1.0);
  std::vector<std::size_t> finer;
  for (const std::size_t other : members) {
    if (coarser * clouds[other].spacing < clouds[c].spacing) finer.push_back(other);
  }
  const std::vector<Point>& points = clouds[c].points;
  const auto covered = std::count_if(points.begin(), points.end(), [&](const Point& p) {
    return std::any_of(finer.begin(), finer.end(), [&](std::size_t other) {
      return clouds[other].tree.any_near(p, options.reach * clouds[other].spacing);
    });
  });
  return static_cast<double>(covered) >=
         options.min_covered_share * static_cast<double>(points.size());
}

double spacing_of_coarsest(Clouds& clouds, std::span<const std::size_t> members,
                           const JoinOptions& options) {
  double spacing = 0;
  for (const std::size_t c : members) {
    if (clouds[c].spacing <= spacing || is_covered(clouds, c, members, options)) continue;
    spacing = clouds[c].spacing;
  }
  return spacing;
}

}  // namespace

std::vector<JoinedCloud> join_clouds(std::span<const std::vector<Point>> clouds,
                                     const JoinOptions& options) {
  require_options("join_clouds", options);
  if (clouds.size() < 2) return {};
  Clouds samples(clouds);
  DisjointSets sets(clouds.size());
  for (std::uint32_t a = 0; a < clouds.size(); ++a) {
    for (std::uint32_t b = a + 1; b < clouds.size(); ++b) {
      // Of many scans of one place most pairs need not be asked.
      if (sets.root(a) == sets.root(b)) continue;
      if (overlap_each_other(samples, a, b, options)) sets.join(a, b);
    }
  }
  std::vector<std::size_t> first;
  for (std::uint32_t c = 0; c < clouds.size(); ++c) first.push_back(sets.root(c));
  std::vector<JoinedCloud> joined;
  std::vector<std::size_t> place(clouds.size());
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    if (first[c] == c) {
      place[c] = joined.size();
      joined.emplace_back();
    }
    joined[place[first[c]]].members.push_back(c);
  }
  if (joined.size() == clouds.size()) return {};
  for (JoinedCloud& cloud : joined) {
    if (cloud.members.size() == 1) continue;
    const double spacing = spacing_of_coarsest(samples, cloud.members, options);
    const std::vector<Point> all = samples_of(cloud, clouds);
    cloud.sheet = thin_points(all, options.thinning * spacing);
    cloud.different = distinct_points(all).size();
  }
  return joined;
}

std::vector<JoinedCloud> each_by_itself(std::size_t clouds) {
  std::vector<JoinedCloud> alone(clouds);
  for (std::size_t c = 0; c < clouds; ++c) alone[c].members = {c};
  return alone;
}

std::vector<Point> samples_of(const JoinedCloud& cloud,
                              std::span<const std::vector<Point>> clouds) {
  std::vector<Point> points;
  for (const std::size_t c : cloud.members) {
    points.insert(points.end(), clouds[c].begin(), clouds[c].end());
  }
  return points;
}

std::vector<CloudSurface> joined_cloud_surfaces(Points points, const JoinedCloud& cloud,
                                                const CloudSurfaceOptions& options,
                                                const Execution& execution) {
  if (cloud.sheet.empty()) return ranked_cloud_surfaces(points, options, execution);
  const std::vector<Point> samples = points_of(points, cloud.sheet);
  std::vector<CloudSurface> surfaces = ranked_cloud_surfaces(samples, options, execution);
  for (CloudSurface& surface : surfaces) {
    for (PointId& p : surface.point_of_vertex) p = cloud.sheet[p.index()];
    surface.set_aside += cloud.different - cloud.sheet.size();
    surface.duplicates = points.size() - cloud.different;
  }
  return surfaces;
}

}  // namespace cocoon
