#include "bench/changes/random_part.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bench/changes/local_frame.h"

namespace cocoon::bench {
namespace {

// In coordinates of its own, within `reach` of their origin.
struct Shape {
  std::string name;
  ImplicitFunction value;
  double reach;
};

double random_rounding(Random& random) { return random.below(2) == 0 ? 0 : random.uniform(0.5, 3); }

Shape block(Random& random) {
  const Vec3 half = {random.uniform(11, 19), random.uniform(9, 15), random.uniform(7, 12)};
  const double rounding = random_rounding(random);
  return {"block", [=](const Point& p) { return rounded_box(p, half, rounding); }, norm(half)};
}

Shape plate(Random& random) {
  const Vec3 half = {random.uniform(16, 24), random.uniform(14, 20), random.uniform(1.2, 4)};
  const double rounding = random.below(2) == 0 ? 0 : 0.5 * half.z;
  return {"plate", [=](const Point& p) { return rounded_box(p, half, rounding); }, norm(half)};
}

Shape ball(Random& random) {
  const double radius = random.uniform(13, 22);
  return {"ball", [=](const Point& p) { return norm(p - Point{}) - radius; }, radius};
}

Shape cylinder(Random& random) {
  const double radius = random.uniform(8, 16);
  const double half = random.uniform(8, 18);
  const double rounding = random_rounding(random);
  return {"cylinder",
          [=](const Point& p) {
            return rounded_extrusion(std::hypot(p.x, p.y) - radius, std::abs(p.z) - half, rounding);
          },
          std::hypot(radius, half)};
}

Shape ring(Random& random) {
  const double radius = random.uniform(14, 20);
  const double thickness = random.uniform(4, 8);
  return {
      "ring",
      [=](const Point& p) { return std::hypot(std::hypot(p.x, p.y) - radius, p.z) - thickness; },
      radius + thickness};
}

Shape bracket(Random& random) {
  const double length = random.uniform(14, 20);
  const double width = random.uniform(9, 14);
  const double thickness = random.uniform(2.5, 5);
  const double fillet = random.below(2) == 0 ? 0 : random.uniform(2, 5);
  const double rounding = random.below(2) == 0 ? 0 : 1;
  return {"bracket",
          [=](const Point& p) {
            const Vec3 down = {length - thickness, 0, 0};
            const double upright = rounded_box(p + down, {thickness, width, length}, rounding);
            const Vec3 beside = {0, 0, length - thickness};
            const double flat = rounded_box(p + beside, {length, width, thickness}, rounding);
            return fillet == 0 ? std::min(upright, flat) : filleted_union(upright, flat, fillet);
          },
          std::hypot(length, width, length)};
}

Shape tube(Random& random) {
  const double outer = random.uniform(9, 14);
  const double inner = outer - random.uniform(2.5, 5);
  const double half = random.uniform(10, 18);
  return {"tube",
          [=](const Point& p) {
            const double radius = std::hypot(p.x, p.y);
            return rounded_extrusion(std::max(radius - outer, inner - radius), std::abs(p.z) - half,
                                     0);
          },
          std::hypot(outer, half)};
}

Shape branches(Random& random) {
  struct Branch {
    Point end;
    double radius;
  };
  std::vector<Branch> branches(3 + random.below(3));
  for (Branch& b : branches) {
    b.end = Point{} + random.uniform(14, 24) * random.on_unit_sphere();
    b.radius = random.uniform(3, 6);
  }
  const double root = random.uniform(6, 9);
  const double fillet = random.uniform(2, 5);
  return {"branches",
          [=](const Point& p) {
            double value = norm(p - Point{}) - root;
            for (const Branch& b : branches) {
              value = filleted_union(value, round_cone(p, {}, 0.8 * root, b.end, b.radius), fillet);
            }
            return value;
          },
          34};
}

}  // namespace

RandomPart random_part(Random& random) {
  constexpr Shape (*makers[])(Random&) = {block, plate,   ball, cylinder,
                                          ring,  bracket, tube, branches};
  Shape shape = makers[random.below(std::size(makers))](random);
  const LocalFrame frame = random_frame({}, random.on_unit_sphere(), random);
  constexpr double room = 1.3;
  Box box = {Point{}, Point{}};
  box.enlarge(shape.reach + room);
  return {
      shape.name,
      {[frame, value = std::move(shape.value)](const Point& p) { return value(frame.local(p)); },
       box}};
}

}  // namespace cocoon::bench
