#include "io/models/sample_airbag.h"

#include <algorithm>
#include <cmath>

namespace cocoon {
namespace {

// The pad: three straight sides and their mirror image, a plane back and a spherical front.
constexpr double top_edge = 4.6;
constexpr double bottom_edge = 4.2;
constexpr double side_edge = 5.3;
constexpr Vec3 side_normal = {0.96, -0.28, 0};
constexpr double corner_width = 2.5;
constexpr double edge_width = 1.2;
constexpr Point dome_center = {0, 0, -8};
constexpr double dome_radius = 11.2;

// The wells. Sized so that, at the paper's 28650 initial points, about 2557 of them lie above wells
// and fillets.
constexpr double well_depth = 0.6;
constexpr double well_rounding = 0.3;  // between wall and floor
constexpr double fillet_width = 0.35;  // between wall and front
constexpr double emblem_y = 0.5;
constexpr double emblem_radius = 1.15;
constexpr double switch_x = 3.5;
constexpr double switch_y = 0.9;
constexpr double switch_half_width = 0.75;
constexpr double switch_half_height = 1.2;
constexpr double switch_rounding = 0.5;
constexpr double between_wells = 2.1;  // |x| halfway between emblem and switches

double dome(const Point& p) { return distance(p, dome_center) - dome_radius; }

double pad(const Point& p) {
  const double side = dot(Vec3{std::abs(p.x), p.y, 0}, side_normal) - side_edge;
  const double ends = std::max(p.y - top_edge, -p.y - bottom_edge);
  const double outline = filleted_intersection(side, ends, corner_width);
  return filleted_intersection(filleted_intersection(outline, -p.z, edge_width), dome(p),
                               edge_width);
}

double well_figure(const Point& p) {
  const double emblem = std::sqrt(p.x * p.x + (p.y - emblem_y) * (p.y - emblem_y)) - emblem_radius;
  const double u = std::abs(std::abs(p.x) - switch_x) - switch_half_width + switch_rounding;
  const double v = std::abs(p.y - switch_y) - switch_half_height + switch_rounding;
  const double switches = norm(Vec3{std::max(u, 0.0), std::max(v, 0.0), 0}) +
                          std::min(std::max(u, v), 0.0) - switch_rounding;
  return std::min(emblem, switches);
}

double wells(const Point& p) {
  return rounded_extrusion(well_figure(p), -(dome(p) + well_depth), well_rounding);
}

}  // namespace

SampleModelDesign airbag_design() {
  SampleModelDesign design;
  const Box box = {{-7.13, -4.83, -0.37}, {7.13, 5.23, 3.57}};
  design.before = {pad, box};
  design.after = {
      [](const Point& p) { return filleted_difference(pad(p), wells(p), fillet_width); }, box};
  const auto on_front = [](const Point& p) { return p.z > 1; };
  design.changes = {
      [on_front](const Point& p) { return on_front(p) && p.x < -between_wells; },
      [on_front](const Point& p) { return on_front(p) && std::abs(p.x) < between_wells; },
      [on_front](const Point& p) { return on_front(p) && p.x > between_wells; }};
  design.points = 28650;
  design.cloud_points = {11973, 10920, 11973};
  design.mesh_cell = 0.08;
  return design;
}

}  // namespace cocoon
