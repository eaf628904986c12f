#include "bench/changes/random_change.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cocoon::bench {
namespace {

enum class Operation { add, remove };

// What is added or removed, in coordinates of the place: z outward.
struct Tool {
  std::string name;
  Operation operation;
  ImplicitFunction value;
  double fillet = 0;  // 0: sharp
  double reach = 0;   // above the surface
};

double random_fillet(Random& random) { return random.below(2) == 0 ? 0 : random.uniform(0.5, 3); }

// How deep what is added reaches into the part: less than the thinnest parts are thick.
constexpr double embedded = 2.2;

ImplicitFunction ball_at(double height, double radius) {
  return [=](const Point& p) { return norm(p - Point{0, 0, height}) - radius; };
}

// What of it is not deep in the part.
ImplicitFunction embedded_part(ImplicitFunction tool) {
  return [tool = std::move(tool)](const Point& p) { return std::max(tool(p), -embedded - p.z); };
}

// Between two heights, with a round or a rectangular outline.
ImplicitFunction prism(double half_x, double half_y, double low, double high, bool is_round) {
  return [=](const Point& p) {
    const double height = std::max(p.z - high, low - p.z);
    if (is_round) return rounded_extrusion(std::hypot(p.x, p.y) - half_x, height, 0);
    const Vec3 half = {half_x, half_y, (high - low) / 2};
    return rounded_box({p.x, p.y, p.z - (high + low) / 2}, half, 0);
  };
}

Tool bump(Random& random) {
  const double radius = random.uniform(4, 9);
  const double height = random.uniform(1, 0.7 * radius);
  return {"bump", Operation::add, embedded_part(ball_at(height - radius, radius)),
          random.uniform(1, 4), height};
}

Tool boss(Random& random) {
  const double half = random.uniform(2, 6);
  const double height = random.uniform(1.5, 8);
  return {"boss", Operation::add,
          prism(half, random.uniform(2, 6), -embedded, height, random.below(2) == 0),
          random_fillet(random), height};
}

Tool rib(Random& random) {
  const double height = random.uniform(1.5, 5);
  return {"rib", Operation::add,
          prism(random.uniform(1, 2), random.uniform(6, 12), -embedded, height, false),
          random_fillet(random), height};
}

// A ball on a neck of its own intersection with the surface.
Tool knob(Random& random) {
  const double radius = random.uniform(3, 6);
  const double height = random.uniform(0.2, 0.8) * radius;
  return {"knob", Operation::add, embedded_part(ball_at(height, radius)), random_fillet(random),
          height + radius};
}

Tool handle(Random& random) {
  const double radius = random.uniform(5, 8);
  const double thickness = random.uniform(1.2, 2.2);
  return {
      "handle", Operation::add,
      [=](const Point& p) { return std::hypot(std::hypot(p.x, p.z) - radius, p.y) - thickness; },
      random_fillet(random), radius + thickness};
}

Tool dent(Random& random) {
  const double radius = random.uniform(4, 9);
  const double depth = random.uniform(1, 0.7 * radius);
  return {"dent", Operation::remove, ball_at(radius - depth, radius), random_fillet(random)};
}

Tool pocket(Random& random) {
  const double half = random.uniform(2, 6);
  return {"pocket", Operation::remove,
          prism(half, random.uniform(2, 6), -random.uniform(1.5, 6), 20, random.below(2) == 0),
          random_fillet(random)};
}

Tool slot(Random& random) {
  return {"slot", Operation::remove,
          prism(random.uniform(1.5, 3), 40, -random.uniform(1.5, 5), 20, false), 0};
}

Tool hole(Random& random) {
  const double radius = random.uniform(2, 5);
  return {"hole", Operation::remove, [=](const Point& p) { return std::hypot(p.x, p.y) - radius; }};
}

Tool chamfer(Random& random) {
  const Vec3 normal = unit(Vec3{0, 0, 1} + 0.8 * random.on_unit_sphere());
  const double depth = random.uniform(0.5, 3);
  return {"chamfer", Operation::remove,
          [=](const Point& p) { return -dot(p - Point{}, normal) - depth; }};
}

double combined(double part, double tool, const Operation operation, double fillet) {
  if (operation == Operation::add) {
    return fillet == 0 ? std::min(part, tool) : filleted_union(part, tool, fillet);
  }
  return fillet == 0 ? std::max(part, -tool) : filleted_difference(part, tool, fillet);
}

}  // namespace

RandomChange random_change(const ImplicitSolid& part, const LocalFrame& frame, Random& random) {
  constexpr Tool (*makers[])(Random&) = {bump, boss,   rib,  knob, handle,
                                         dent, pocket, slot, hole, chamfer};
  const Tool tool = makers[random.below(std::size(makers))](random);
  Box box = part.box;
  Box beside = {frame.origin, frame.origin};
  beside.enlarge(std::hypot(tool.reach, 13) + 1);  // ribs are 12 to each side
  if (tool.operation == Operation::add) {
    box.include(beside);
  }
  const ImplicitSolid before = {part.value, box};
  const ImplicitSolid after = {[value = part.value, tool, frame](const Point& p) {
                                 return combined(value(p), tool.value(frame.local(p)),
                                                 tool.operation, tool.fillet);
                               },
                               box};
  if (random.below(4) == 0) return {"no " + tool.name, after, before};
  return {tool.name, before, after};
}

}  // namespace cocoon::bench
