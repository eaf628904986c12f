#include "bench/changes/simulated_scan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geom/mesh/triangles_by_area.h"
#include "geom/mesh_measure.h"
#include "ref/scan_errors.h"

namespace cocoon::bench {
namespace {

// What passes the other surface by more than this has changed.
constexpr double changed_by = 0.05;
// A scanner sees nothing at a flatter angle.
const double steepest = std::cos(80 * std::numbers::pi / 180);
constexpr double step = 1e-4;  // of differences

double pitch_along(const ScanSetting& setting, Random& random) {
  return setting.kind == ScanKind::lines ? setting.spacing / random.uniform(2, 5) : setting.spacing;
}

// The first place of the solid on the ray from `start` along the unit vector `way`, up to `length`.
std::optional<Point> first_hit(const ImplicitFunction& solid, const Point& start, const Vec3& way,
                               double length) {
  constexpr double on_surface = 1e-7;
  constexpr int most_steps = 400;
  double along = 0;
  for (int k = 0; k < most_steps && along < length; ++k) {
    const Point p = start + along * way;
    const double value = solid(p);
    if (value < on_surface) return p;
    along += value;
  }
  return {};
}

// A depth image: parallel rays against z of `view`, through a grid.
std::vector<Point> depth_image(const ImplicitFunction& solid, const ScannedRegion& region,
                               const LocalFrame& view, double pitch_x, double pitch_y,
                               Random& random) {
  std::vector<Point> found;
  const double reach = region.radius();
  const double height = 100;  // above all of the part
  const Point corner = view.local(region.center()) + Vec3{-reach, -reach, 0} +
                       Vec3{pitch_x * random.uniform(), pitch_y * random.uniform(), height};
  for (double x = 0; x < 2 * reach; x += pitch_x) {
    for (double y = 0; y < 2 * reach; y += pitch_y) {
      const Point start = view.world(corner + Vec3{x, y, 0});
      const std::optional<Point> hit = first_hit(solid, start, -1 * view.z, 2 * height);
      if (!hit || !region.holds(*hit)) continue;
      const Vec3 slope = gradient(solid, *hit, step);
      if (dot(slope, view.z) > steepest * norm(slope)) found.push_back(*hit);
    }
  }
  return found;
}

std::vector<std::vector<Point>> views(const ImplicitSolid& solid, const ScannedRegion& region,
                                      const Vec3& up, const ScanSetting& setting, Random& random) {
  const std::size_t count = setting.kind == ScanKind::one_view ? 1 : 3;
  const LocalFrame frame = random_frame({}, up, random);
  std::vector<std::vector<Point>> clouds;
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    const double slant = random.uniform(0.3, 0.9);
    const Vec3 toward = unit(up + slant * (std::cos(turn) * frame.x + std::sin(turn) * frame.y));
    clouds.push_back(depth_image(solid.value, region, random_frame({}, toward, random),
                                 setting.spacing, pitch_along(setting, random), random));
  }
  return clouds;
}

std::vector<Point> from_all_around(const ImplicitSolid& solid, const TriangleMesh& truth,
                                   const ScannedRegion& region, const ScanSetting& setting,
                                   Random& random) {
  const TriangleMesh part = region.part_of(truth);
  const TrianglesByArea triangles(part);
  const auto tries =
      static_cast<std::size_t>(triangles.area() / (setting.spacing * setting.spacing));
  std::vector<Point> found;
  for (std::size_t k = 0; k < tries; ++k) {
    const Point start =
        random_point_in(part, triangles.at(random.uniform(0, triangles.area())), random);
    const Point p = project_to_surface(solid.value, start, step);
    if (region.holds(p)) found.push_back(p);
  }
  if (setting.kind == ScanKind::random || found.empty()) return found;
  return sample_surface(
      solid, part, [&](const Point& p) { return region.holds(p); }, found.size(), random,
      Execution{});
}

}  // namespace

const char* name_of(ScanKind kind) {
  switch (kind) {
    case ScanKind::even:
      return "even";
    case ScanKind::random:
      return "random";
    case ScanKind::one_view:
      return "one view";
    case ScanKind::three_views:
      return "three views";
    case ScanKind::single_views:
      return "three views, a file each";
    case ScanKind::lines:
      break;
  }
  return "lines of three views";
}

ScanSetting random_setting(ScanKind kind, Random& random) {
  ScanSetting setting;
  setting.kind = kind;
  setting.spacing = random.uniform(0.5, 1.2);
  setting.margin = random.uniform(2, 5);
  setting.ragged = random.below(2) == 0 ? 0 : 0.4;
  setting.noise = random.below(2) == 0 ? 0 : 0.1;
  setting.registration = random.below(3) == 0 ? 0.3 : 0;
  return setting;
}

ScannedRegion::ScannedRegion(std::vector<Point> changed, const ScanSetting& setting, Random& random)
    : changed_(std::move(changed)),
      tree_(changed_),
      margin_(setting.margin),
      ragged_(setting.ragged),
      center_(box_of(changed_).center()) {
  for (const Point& p : changed_) radius_ = std::max(radius_, distance(center_, p));
  radius_ += (1 + ragged_) * margin_;
  for (Vec3& wave : waves_) wave = random.uniform(0.6, 1.2) * random.on_unit_sphere();
}

std::optional<ScannedRegion> ScannedRegion::around_change(const ImplicitFunction& before,
                                                          const TriangleMesh& truth,
                                                          const ScanSetting& setting,
                                                          Random& random) {
  std::vector<Point> changed;
  for (const Point& p : truth.points) {
    if (std::abs(before(p)) > changed_by) changed.push_back(p);
  }
  if (changed.empty()) return {};
  return ScannedRegion(std::move(changed), setting, random);
}

bool ScannedRegion::holds(const Point& p) const {
  double wave = 0;
  for (const Vec3& along : waves_) wave += std::sin(dot(p - Point{}, along)) / 3;
  return tree_.any_near(p, margin_ * (1 + ragged_ * wave));
}

TriangleMesh ScannedRegion::part_of(const TriangleMesh& truth) const {
  constexpr double longest_edge_of_truth = 1;
  TriangleMesh part = {truth.points, {}};
  const double reach = (1 + ragged_) * margin_ + longest_edge_of_truth;
  for (const Triangle& t : truth.triangles) {
    if (tree_.any_near(truth.points[t[0]], reach)) part.triangles.push_back(t);
  }
  return part;
}

std::vector<std::vector<Point>> simulated_scan(const ImplicitSolid& solid,
                                               const TriangleMesh& truth,
                                               const ScannedRegion& region, const Vec3& up,
                                               const ScanSetting& setting, Random& random) {
  const bool is_from_all_around =
      setting.kind == ScanKind::even || setting.kind == ScanKind::random;
  std::vector<std::vector<Point>> clouds;
  if (is_from_all_around) {
    clouds.push_back(from_all_around(solid, truth, region, setting, random));
  } else {
    clouds = views(solid, region, up, setting, random);
  }
  for (std::vector<Point>& cloud : clouds) {
    if (cloud.empty()) continue;
    ref::add_scan_errors(cloud, {.noise = setting.noise * setting.spacing,
                                 .registration = setting.registration * setting.spacing,
                                 .seed = random.bits()});
  }
  const bool is_one_file = setting.kind != ScanKind::single_views;
  for (std::size_t k = 1; is_one_file && k < clouds.size(); ++k) {
    clouds[0].insert(clouds[0].end(), clouds[k].begin(), clouds[k].end());
  }
  if (is_one_file) clouds.resize(1);
  return clouds;
}

}  // namespace cocoon::bench
