#include "io/models/sample_golf_club.h"

namespace cocoon {
namespace {

// The body: an ellipsoid, higher above its equator than below, cut off by the face.
constexpr double half_width = 5.8;
constexpr double half_length = 5.2;
constexpr double crown_height = 2.9;
constexpr double sole_depth = 1.7;
constexpr Vec3 face_normal = {0, -0.96, 0.28};
constexpr double face_distance = 3.3;
constexpr double face_rounding = 0.8;

// The socket of the shaft.
constexpr Point hosel_foot = {-3.7, -1.2, 0.6};
constexpr Point hosel_end = {-5.1, -1.6, 5.2};
constexpr double hosel_foot_radius = 0.85;
constexpr double hosel_end_radius = 0.65;
constexpr double hosel_fillet = 0.9;

// The mark. Sized so that, at the paper's 49380 initial points, about 382 of them lie on its place.
constexpr double mark_x = 0.7;
constexpr double mark_y = 0.9;
constexpr double mark_radius = 0.775;
constexpr double mark_height = 0.9;  // times t (1 - t^2)^3, at most 0.28: 0.25

double head(const Point& p) {
  const Vec3 half = {half_width, half_length, p.z > 0 ? crown_height : sole_depth};
  const double body =
      filleted_intersection(ellipsoid(p, half), dot(p, face_normal) - face_distance, face_rounding);
  const double hosel = round_cone(p, hosel_foot, hosel_foot_radius, hosel_end, hosel_end_radius);
  return filleted_union(body, hosel, hosel_fillet);
}

// How far the crown is raised or, below zero, lowered.
double mark(const Point& p) {
  const double u = (p.x - mark_x) / mark_radius;
  const double v = (p.y - mark_y) / mark_radius;
  const double inside = 1 - u * u - v * v;
  if (p.z <= 0 || inside <= 0) return 0;
  return -mark_height * v * inside * inside * inside;
}

}  // namespace

SampleModelDesign golf_club_design() {
  SampleModelDesign design;
  const Box box = {{-6.57, -4.37, -2.13}, {6.23, 5.63, 6.27}};
  design.before = {head, box};
  design.after = {[](const Point& p) { return head(p) - mark(p); }, box};
  design.changes = {[](const Point& p) { return p.z > 0; }};
  design.points = 49380;
  design.cloud_points = {4572};
  design.mesh_cell = 0.08;
  return design;
}

}  // namespace cocoon
