#include "app/report/page_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geom/angles.h"
#include "geom/triangle_normal.h"

namespace cocoon::app {

namespace {

constexpr int azimuths = 12;
constexpr std::array<double, 4> elevations_deg = {28, 0, 60, -28};

Vec3 direction_of(const PageView& view) {
  const double a = view.azimuth_deg * radians_per_degree;
  const double e = view.elevation_deg * radians_per_degree;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

// The default is the first.
std::vector<PageView> views_around() {
  std::vector<PageView> views;
  for (const double elevation : elevations_deg) {
    for (int i = 0; i < azimuths; ++i) {
      const double azimuth = PageView{}.azimuth_deg + i * 360.0 / azimuths;
      views.push_back({azimuth, elevation});
    }
  }
  return views;
}

}  // namespace

PageView view_towards(std::span<const std::array<Point, 3>> triangles,
                      const PageViewOptions& options) {
  std::vector<Vec3> areas;
  areas.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) areas.push_back(0.5 * area_normal(a, b, c));

  const std::vector<PageView> views = views_around();
  std::vector<double> shown;
  for (const PageView& view : views) {
    const Vec3 towards = direction_of(view);
    double sum = 0;
    for (const Vec3& area : areas) sum += std::max(0.0, dot(area, towards));
    shown.push_back(sum);
  }
  const auto most = std::max_element(shown.begin(), shown.end());
  if (shown.front() >= options.enough * *most) return views.front();
  return views[static_cast<std::size_t>(most - shown.begin())];
}

}  // namespace cocoon::app
