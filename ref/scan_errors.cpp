#include "ref/scan_errors.h"

#include <algorithm>
#include <cmath>

#include "geom/box.h"
#include "geom/errors.h"
#include "geom/random/random.h"

namespace cocoon::ref {
namespace {

// A shift and a small turn about `center`, linearized: the moves are at most a few spacings.
struct SmallMotion {
  Point center;
  Vec3 shift;
  Vec3 turn;
  Vec3 at(const Point& p) const { return shift + cross(turn, p - center); }
};

SmallMotion random_motion(const std::vector<Point>& cloud, double reach, Random& random) {
  const Box box = box_of(cloud);
  const double radius = 0.5 * norm(box.size());
  SmallMotion motion;
  motion.center = box.center();
  motion.shift = random.uniform() * random.on_unit_sphere();
  if (radius > 0) motion.turn = (random.uniform() / radius) * random.on_unit_sphere();
  double farthest = 0;
  for (const Point& p : cloud) farthest = std::max(farthest, norm(motion.at(p)));
  if (farthest == 0) return {};
  motion.shift = (reach / farthest) * motion.shift;
  motion.turn = (reach / farthest) * motion.turn;
  return motion;
}

}  // namespace

void add_scan_errors(std::vector<Point>& cloud, const ScanErrors& errors) {
  const auto is_length = [](double x) { return x >= 0 && std::isfinite(x); };
  if (!is_length(errors.noise) || !is_length(errors.registration)) {
    throw InputError("scan errors must be lengths, not negative");
  }
  Random random(errors.seed);
  if (errors.registration > 0) {
    const SmallMotion motion = random_motion(cloud, errors.registration, random);
    for (Point& p : cloud) p = p + motion.at(p);
  }
  if (errors.noise > 0) {
    for (Point& p : cloud) {
      const Vec3 direction = random.on_unit_sphere();
      p = p + (errors.noise * random.uniform()) * direction;
    }
  }
}

}  // namespace cocoon::ref
