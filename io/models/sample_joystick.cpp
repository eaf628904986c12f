#include "io/models/sample_joystick.h"

#include <cmath>

namespace cocoon {
namespace {

constexpr Vec3 base_half = {3.7, 4.2, 0.8};
constexpr double base_rounding = 0.4;
constexpr double stick_y = 1.4;

double base(const Point& p) {
  return rounded_box(p - Vec3{0, 0, base_half.z}, base_half, base_rounding);
}

double stick(const Point& p) {
  const double boot = round_cone(p, {0, stick_y, 1.8}, 1.6, {0, stick_y + 0.1, 3.6}, 0.62);
  const double grip = round_cone(p, {0, stick_y + 0.1, 3.4}, 0.6, {0, stick_y + 0.9, 7.6}, 0.95);
  const double trigger =
      round_cone(p, {0, stick_y + 1.3, 6.9}, 0.32, {0, stick_y + 1.9, 6.5}, 0.26);
  return filleted_union(filleted_union(boot, grip, 0.6), trigger, 0.3);
}

double joystick(const Point& p) { return filleted_union(base(p), stick(p), 0.5); }

// The console. Sized so that, at the paper's 37122 initial points, about 1803 of them lie under
// console and fillet.
constexpr double console_y = -2.1;
constexpr Vec3 console_half = {1.55, 0.88, 0.75};
constexpr double console_top = 2.1;
constexpr double console_rounding = 0.3;
constexpr double console_fillet = 0.4;
constexpr double button_x = 0.8;
constexpr double button_radius = 0.45;
constexpr double button_height = 0.3;
constexpr double button_fillet = 0.2;

double console(const Point& p) {
  const double body = rounded_box(p - Vec3{0, console_y, console_top - console_half.z},
                                  console_half, console_rounding);
  const double u = std::abs(p.x) - button_x;
  const double v = p.y - console_y;
  const double height = std::abs(p.z - console_top) - button_height;
  const double buttons = rounded_extrusion(std::sqrt(u * u + v * v) - button_radius, height, 0.15);
  return filleted_union(body, buttons, button_fillet);
}

// The new grip. Sized so that, at the paper's 37122 initial points, about 3353 of them lie inside
// it or under its fillet.
constexpr double grip_fillet = 0.4;

double new_grip(const Point& p) {
  const double palm = round_cone(p, {0, stick_y + 0.63, 6.3}, 0.78, {0, stick_y + 0.95, 8.0}, 1.4);
  const double trigger = round_cone(p, {0, stick_y + 1.6, 7.0}, 0.6, {0, stick_y + 2.6, 6.5}, 0.4);
  const double hat = round_cone(p, {0, stick_y + 0.9, 9.0}, 0.4, {0, stick_y + 0.9, 9.6}, 0.45);
  return filleted_union(filleted_union(palm, trigger, 0.4), hat, 0.3);
}

SampleModelDesign design_of(ImplicitFunction after, SurfaceRegion change,
                            std::size_t cloud_points) {
  SampleModelDesign design;
  const Box box = {{-4.07, -4.57, -0.37}, {4.07, 4.97, 10.77}};
  design.before = {joystick, box};
  design.after = {std::move(after), box};
  design.changes = {std::move(change)};
  design.points = 37122;
  design.cloud_points = {cloud_points};
  design.mesh_cell = 0.08;
  return design;
}

}  // namespace

SampleModelDesign joystick_console_design() {
  return design_of(
      [](const Point& p) { return filleted_union(joystick(p), console(p), console_fillet); },
      [](const Point& p) { return p.z > base_half.z && p.y < 0; }, 10574);
}

SampleModelDesign joystick_grip_design() {
  return design_of(
      [](const Point& p) { return filleted_union(joystick(p), new_grip(p), grip_fillet); },
      [](const Point& p) { return p.z > 3; }, 32187);
}

}  // namespace cocoon
