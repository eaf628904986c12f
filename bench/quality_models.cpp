#include "bench/quality_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "geom/mesh/triangles_by_area.h"
#include "geom/mesh_measure.h"
#include "geom/random/random.h"
#include "io/models/implicit_solid.h"
#include "io/models/polygonize.h"
#include "io/models/surface_sampling.h"

namespace cocoon::bench {
namespace {

double torus_value(const Point& p, double ring, double tube) {
  return std::hypot(std::hypot(p.x, p.y) - ring, p.z) - tube;
}

TriangleMesh solid(const ImplicitFunction& value, double reach, double cell) {
  return polygonize({value, {{-reach, -reach, -reach}, {reach, reach, reach}}}, cell);
}

TriangleMesh ball(double radius, const Point& center = {}) {
  TriangleMesh mesh =
      solid([=](const Point& p) { return norm(p) - radius; }, 1.1 * radius, 0.05 * radius);
  for (Point& p : mesh.points) p = p + center;
  return mesh;
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b, bool turn_over = false) {
  const std::size_t shift = a.points.size();
  for (const Point& p : b.points) a.points.push_back(p);
  for (const Triangle& t : b.triangles) {
    Triangle moved;
    for (std::size_t i = 0; i < 3; ++i) moved[i] = VertexId(t[i].index() + shift);
    if (turn_over) std::swap(moved[1], moved[2]);
    a.triangles.push_back(moved);
  }
  return a;
}

// Two tori side by side, melted together.
TriangleMesh double_torus() {
  const auto value = [](const Point& p) {
    const double left = torus_value(p + Vec3{0.55, 0, 0}, 0.5, 0.18);
    const double right = torus_value(p - Vec3{0.55, 0, 0}, 0.5, 0.18);
    return filleted_union(left, right, 0.1);
  };
  return solid(value, 1.4, 0.02);
}

// A rounded block with four holes through it: genus 4.
TriangleMesh pierced_block() {
  const auto value = [](const Point& p) {
    const double block = rounded_box(p, {0.9, 0.9, 0.25}, 0.08);
    double hole = 1;
    for (const double x : {-0.45, 0.45}) {
      for (const double y : {-0.45, 0.45}) {
        hole = std::min(hole, std::hypot(p.x - x, p.y - y) - 0.25);
      }
    }
    return -filleted_union(-block, hole, 0.08);
  };
  return solid(value, 1.1, 0.02);
}

// A prism over the polygon, counterclockwise, star-shaped about its first corner.
TriangleMesh prism(const std::vector<std::array<double, 2>>& polygon, double height) {
  TriangleMesh mesh;
  const std::size_t n = polygon.size();
  for (const double z : {0.0, height}) {
    for (const auto& [x, y] : polygon) mesh.points.push_back({x, y, z});
  }
  const auto id = [](std::size_t i) { return VertexId(i); };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({id(0), id(i + 1), id(i)});
    mesh.triangles.push_back({id(n), id(n + i), id(n + i + 1)});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    mesh.triangles.push_back({id(i), id(j), id(n + j)});
    mesh.triangles.push_back({id(i), id(n + j), id(n + i)});
  }
  return mesh;
}

std::vector<Point> random_points_on(const TriangleMesh& mesh, std::size_t count, Random& random) {
  const TrianglesByArea triangles(mesh);
  std::vector<Point> points(count);
  for (Point& p : points) {
    p = random_point_in(mesh, triangles.at(random.uniform() * triangles.area()), random);
  }
  return points;
}

// Points that `keeps` accepts, out of four times as many evenly spread ones.
QualityModel thinned(std::string name, const TriangleMesh& truth, std::size_t count,
                     const std::function<bool(const Point&, Random&)>& keeps) {
  QualityModel model = sampled(std::move(name), truth, 4 * count, 11);
  Random random(12);
  std::erase_if(model.points, [&](const Point& p) { return !keeps(p, random); });
  const double area = mesh_measure(truth).area;
  model.spacing = std::sqrt(area / static_cast<double>(model.points.size()));
  return model;
}

}  // namespace

QualityModel sampled(std::string name, TriangleMesh truth, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const double area = mesh_measure(truth).area;
  const double each = area / static_cast<double>(count);
  const double radius = std::sqrt(each / (2 * std::numbers::sqrt3));
  QualityModel model;
  model.name = std::move(name);
  model.points = eliminate_samples(random_points_on(truth, 5 * count, random), count, radius);
  model.truth = std::move(truth);
  model.spacing = std::sqrt(each);
  return model;
}

QualityModel disturbed(const QualityModel& model, double noise, double outliers,
                       std::uint64_t seed) {
  QualityModel result = model;
  Random random(seed);
  for (Point& p : result.points) {
    const Vec3 step{random.gaussian(), random.gaussian(), random.gaussian()};
    p = p + noise * model.spacing * step;
  }
  const Box box = mesh_measure(model.truth).box;
  const auto extra = static_cast<std::size_t>(outliers * static_cast<double>(model.points.size()));
  const Point center = box.center();
  for (std::size_t i = 0; i < extra; ++i) {
    const Vec3 place = random.in_unit_cube() - Vec3{0.5, 0.5, 0.5};
    const Vec3 size = 1.1 * (box.size());
    result.points.push_back(center + Vec3{place.x * size.x, place.y * size.y, place.z * size.z});
  }
  return result;
}

std::vector<QualityModel> quality_models(std::size_t count) {
  const std::vector<std::array<double, 2>> angle{{1, 1}, {1, 2}, {0, 2}, {0, 0}, {3, 0}, {3, 1}};
  const TriangleMesh thin_plate = solid(
      [](const Point& p) {
        return rounded_box(p, {1, 1, 0.025}, 0.012);
      },
      1.2, 0.012);
  const TriangleMesh torus =
      solid([](const Point& p) { return torus_value(p, 1, 0.35); }, 1.5, 0.03);
  std::vector<QualityModel> models;
  models.push_back(sampled("sphere", ball(1), count, 1));
  models.push_back(sampled("torus", torus, count, 2));
  models.push_back(sampled("double torus", double_torus(), count, 3));
  models.push_back(sampled("pierced block", pierced_block(), count, 4));
  models.push_back(sampled("sharp cube", prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1), count, 5));
  models.push_back(sampled("sharp angle", prism(angle, 1), count, 6));
  models.push_back(sampled("wedge of 20 degrees", prism({{0, 0}, {2, 0}, {2, 0.73}}, 1), count, 7));
  models.push_back(sampled("thin plate", thin_plate, count, 8));
  models.push_back(sampled("two bodies", joined(ball(1), ball(0.5, {1.6, 0, 0})), count, 9));
  models.push_back(sampled("body with a cavity", joined(ball(1), ball(0.5), true), count, 10));
  models.push_back(
      thinned("torus, density 1 to 16", torus, count / 2, [](const Point& p, Random& r) {
        return r.uniform() < std::exp2(-2.0 * (p.x + 1.35) / 1.35);
      }));
  models.push_back(thinned("torus, random points", torus, count,
                           [](const Point&, Random& r) { return r.uniform() < 0.25; }));
  models.push_back(thinned("sphere, not seen from below", ball(1), count / 3,
                           [](const Point& p, Random&) { return p.z > -0.8; }));
  return models;
}

}  // namespace cocoon::bench
