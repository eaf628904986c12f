#include "io/models/sample_block.h"

#include <cmath>

namespace cocoon {
namespace {

constexpr Vec3 block_half = {4, 2.5, 1};
constexpr double block_rounding = 0.3;

// The U: half a circle about (u_center_x, 0) and two arms from its ends along x. Sized so that, at
// the paper's 5991 initial points, about 422 of them lie below ridge and fillet.
constexpr double u_center_x = -0.3;
constexpr double u_radius = 1.1;
constexpr double arm_length = 1.45;
constexpr double ridge_half_width = 0.4;
constexpr double ridge_height = 0.5;
constexpr double ridge_rounding = 0.25;
constexpr double fillet_width = 0.2;

double u_distance(double x, double y) {
  const double along = x - u_center_x;
  const double across = std::abs(y) - u_radius;
  if (along < 0) return std::abs(std::sqrt(along * along + y * y) - u_radius);
  if (along <= arm_length) return std::abs(across);
  const double beyond = along - arm_length;
  return std::sqrt(beyond * beyond + across * across);
}

double block(const Point& p) { return rounded_box(p, block_half, block_rounding); }

// From the middle of the block to ridge_height above its top.
double ridge(const Point& p) {
  const double slab_half = (block_half.z + ridge_height) / 2;
  const double height = std::abs(p.z - slab_half) - slab_half;
  return rounded_extrusion(block_ridge_figure(p.x, p.y), height, ridge_rounding);
}

}  // namespace

double block_ridge_figure(double x, double y) { return u_distance(x, y) - ridge_half_width; }

SampleModelDesign block_design() {
  constexpr double room = 0.27;  // flat faces lie between the planes of the grid, not in them
  Box box = {-block_half, block_half + Vec3{0, 0, ridge_height}};
  box.enlarge(room);
  SampleModelDesign design;
  design.before = {block, box};
  design.after = {[](const Point& p) { return filleted_union(block(p), ridge(p), fillet_width); },
                  box};
  design.changes = {[](const Point& p) { return p.z > 0; }};
  design.points = 5991;
  design.cloud_points = {11488};
  design.mesh_cell = 0.06;
  return design;
}

}  // namespace cocoon
