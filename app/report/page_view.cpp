#include "app/report/page_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "geom/angles.h"
#include "geom/search/triangle_tree.h"
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

// The triangles of a mesh as they hide each other.
class Hiding {
 public:
  explicit Hiding(const TriangleMesh& mesh) : tree_(triangle_tree(mesh)) {}

  // Whether a triangle lies before p for who looks from `towards`.
  bool hides(const Point& p, const Vec3& towards, TriangleId but) const {
    return tree_.boxes.any_on_ray(p, towards, [&](std::uint32_t slot) {
      return tree_.boxes.items()[slot] != but.value && is_crossed(tree_.corners[slot], p, towards);
    });
  }

 private:
  // By the signs of volumes, in floating point: whether one is seen is a matter of taste.
  static bool is_crossed(const std::array<Point, 3>& t, const Point& p, const Vec3& way) {
    const Vec3 a = t[0] - p;
    const Vec3 b = t[1] - p;
    const Vec3 c = t[2] - p;
    const double ab = dot(cross(a, b), way);
    const double bc = dot(cross(b, c), way);
    const double ca = dot(cross(c, a), way);
    const bool passes_through = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
    return passes_through && dot(cross(a, b), c) * (ab + bc + ca) > 0;
  }

  TriangleTree tree_;
};

struct Front {
  TriangleId triangle;
  Point middle;
  Vec3 area;
};

// Of `triangles`, or of some that stand for them.
std::vector<Front> fronts_of(const TriangleMesh& mesh, std::span<const TriangleId> triangles,
                             std::size_t at_most) {
  std::vector<Front> fronts;
  const std::size_t count = std::min(triangles.size(), at_most);
  for (std::size_t i = 0; i < count; ++i) {
    const TriangleId t = triangles[i * triangles.size() / count];
    const auto& [a, b, c] = finite_corners_of(mesh, t);
    fronts.push_back({t, (1.0 / 3) * (a + b + c), 0.5 * area_normal(a, b, c)});
  }
  return fronts;
}

// What is shown of `fronts` to who looks from `towards`.
double shown(const std::vector<Front>& fronts, const Vec3& towards, const Hiding& hiding) {
  double sum = 0;
  for (const auto& [triangle, middle, area] : fronts) {
    const double of_it = dot(area, towards);
    if (of_it > 0 && !hiding.hides(middle, towards, triangle)) sum += of_it;
  }
  return sum;
}

}  // namespace

PageView view_towards(const TriangleMesh& mesh, std::span<const TriangleId> triangles,
                      const PageViewOptions& options) {
  const std::vector<Front> fronts = fronts_of(mesh, triangles, options.asked);
  const std::vector<PageView> views = views_around();
  const Hiding hiding(mesh);
  std::vector<double> seen;
  for (const PageView& view : views) seen.push_back(shown(fronts, direction_of(view), hiding));
  const auto most = std::max_element(seen.begin(), seen.end());
  if (seen.front() >= options.enough * *most) return views.front();
  return views[static_cast<std::size_t>(most - seen.begin())];
}

}  // namespace cocoon::app
