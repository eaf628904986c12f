#include "geom/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/mesh/used_vertices.h"
#include "geom/random/random.h"
#include "geom/search/closest_facet.h"
#include "geom/search/nearest_point.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

using SquaredDistanceTo = std::function<double(const Point&)>;

SquaredDistanceTo search_in(const TriangleMesh& target, const Execution& execution) {
  if (target.triangles.empty()) {
    const auto tree =
        std::make_shared<const NearestPointTree>(Points(target.points.raw()), execution);
    return [tree](const Point& p) { return tree->nearest(p).squared_distance; };
  }
  const auto tree = std::make_shared<const ClosestFacetTree>(target, execution);
  return [tree](const Point& p) { return tree->squared_distance(p); };
}

// The points of `mesh` that are measured for the maximum alone.
std::vector<Point> corners_of_triangles(const TriangleMesh& mesh) {
  const IdVector<VertexId, std::uint8_t> used = used_vertices(mesh);
  std::vector<Point> corners;
  for (const VertexId v : mesh.points.ids()) {
    if (used[v] != 0) corners.push_back(mesh.points[v]);
  }
  return corners;
}

// One uniform point in each of `count` equal pieces of the area. `which` of both meshes it is.
std::vector<Point> stratified_samples(const TriangleMesh& mesh, const char* which,
                                      std::size_t count, std::uint64_t seed,
                                      const Execution& execution) {
  const TrianglesByArea triangles(mesh);
  if (count > 0 && !(triangles.area() > 0)) {
    throw InputError(std::string("the triangles of the ") + which +
                     " have no area to take samples of; leave them out to compare the points "
                     "alone");
  }
  std::vector<Point> samples(count);
  parallel_chunks(execution, count, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      std::uint64_t state = seed + k;
      Random random(splitmix64(state));
      const double at = (static_cast<double>(k) + random.uniform()) / static_cast<double>(count);
      samples[k] = random_point_in(mesh, triangles.at(at * triangles.area()), random);
    }
  });
  return samples;
}

// Figures of some points; combined in a fixed order.
struct Tally {
  double sum = 0;
  double sum_of_squares = 0;
  std::size_t within = 0;  // the tolerance
  double max_squared = -1;
  Point farthest;

  void add(const Point& p, double squared, double tolerance) {
    const double distance = std::sqrt(squared);
    sum += distance;
    sum_of_squares += squared;
    within += distance <= tolerance ? 1U : 0U;
    keep_farther(p, squared);
  }
  void keep_farther(const Point& p, double squared) {
    if (squared > max_squared || (squared == max_squared && (p <=> farthest) < 0)) {
      max_squared = squared;
      farthest = p;
    }
  }
  void add(const Tally& other) {
    sum += other.sum;
    sum_of_squares += other.sum_of_squares;
    within += other.within;
    keep_farther(other.farthest, other.max_squared);
  }
};

Tally tally(Points points, const SquaredDistanceTo& squared_distance_to, double tolerance,
            const StagePart& part, const Execution& execution) {
  constexpr std::size_t grain = 1024;
  std::vector<Tally> chunks((points.size() + grain - 1) / grain);
  parallel_chunks(execution, part, points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      chunks[begin / grain].add(points[k], squared_distance_to(points[k]), tolerance);
    }
  });
  Tally total;
  for (const Tally& chunk : chunks) total.add(chunk);
  return total;
}

// What of a surface is measured, each point multiplied by `scale`.
struct MeasuredPoints {
  std::vector<Point> samples;  // for all figures
  std::vector<Point> corners;  // for the maximum alone
};

// Samples are taken at the mesh's own size: beside a much larger one its areas would vanish.
MeasuredPoints measured_points(const TriangleMesh& mesh, const char* which, double scale,
                               const SurfaceDistanceOptions& options, const Execution& execution) {
  MeasuredPoints measured;
  if (mesh.triangles.empty()) {
    measured.samples = mesh.points.raw();
  } else {
    measured.corners = corners_of_triangles(mesh);
    const double own_scale = working_scale(measured.corners);
    measured.samples = stratified_samples(own_scale == 1 ? mesh : scaled(mesh, own_scale), which,
                                          options.samples, options.seed, execution);
    if (own_scale != 1) measured.samples = scaled(measured.samples, 1 / own_scale);
  }
  if (scale != 1) {
    measured.samples = scaled(measured.samples, scale);
    measured.corners = scaled(measured.corners, scale);
  }
  return measured;
}

DirectedDistance measure(const TriangleMesh& from, const TriangleMesh& to, const char* which_from,
                         double scale, const SurfaceDistanceOptions& options, const StagePart& part,
                         const Execution& execution) {
  const SquaredDistanceTo squared_distance_to =
      search_in(scale == 1 ? to : scaled(to, scale), execution);
  const auto [samples, corners] = measured_points(from, which_from, scale, options, execution);
  constexpr double none = -1;  // nothing is within it
  const double tolerance = options.tolerance ? *options.tolerance * scale : none;
  const double middle = (part.begin + part.end) / 2;
  const Tally spread =
      tally(samples, squared_distance_to, tolerance, {part.stage, part.begin, middle}, execution);
  Tally farthest =
      tally(corners, squared_distance_to, none, {part.stage, middle, part.end}, execution);
  farthest.keep_farther(spread.farthest, spread.max_squared);

  const double count = std::max<double>(1, static_cast<double>(samples.size()));
  return {.samples = samples.size() + corners.size(),
          .max = std::sqrt(std::max(farthest.max_squared, 0.0)),
          .mean = spread.sum / count,
          .rms = std::sqrt(spread.sum_of_squares / count),
          .farthest = farthest.farthest,
          .within = static_cast<double>(spread.within) / count};
}

// Of triangles the corners alone, if there are any: no other points are measured.
std::vector<Point> corners_or_points(const TriangleMesh& mesh) {
  return mesh.triangles.empty() ? mesh.points.raw() : corners_of_triangles(mesh);
}

template <class Distance>
void unscale(Distance& distance, double scale) {
  distance.max /= scale;
  distance.mean /= scale;
  distance.rms /= scale;
}

SurfaceDistance measure_both(const TriangleMesh& a, const TriangleMesh& b, double scale,
                             const SurfaceDistanceOptions& options, const Execution& execution) {
  SurfaceDistance distance;
  constexpr const char* stage = "surface_distance";
  distance.a_to_b = measure(a, b, "first", scale, options, {stage, 0, 0.5}, execution);
  distance.b_to_a = measure(b, a, "second", scale, options, {stage, 0.5, 1}, execution);
  distance.max = std::max(distance.a_to_b.max, distance.b_to_a.max);
  distance.mean = (distance.a_to_b.mean + distance.b_to_a.mean) / 2;
  distance.rms = std::sqrt(
      (distance.a_to_b.rms * distance.a_to_b.rms + distance.b_to_a.rms * distance.b_to_a.rms) / 2);
  const double precision = distance.a_to_b.within;
  const double recall = distance.b_to_a.within;
  if (precision + recall > 0) distance.f_score = 2 * precision * recall / (precision + recall);
  return distance;
}

void require_finite(const TriangleMesh& mesh) {
  for (const VertexId v : mesh.points.ids()) {
    if (!is_finite(mesh.points[v])) {
      throw InputError("point " + std::to_string(v.value) +
                       " has a coordinate that is not finite; remove it");
    }
  }
}

}  // namespace

SurfaceDistance surface_distance(const TriangleMesh& a, const TriangleMesh& b,
                                 const SurfaceDistanceOptions& options,
                                 const Execution& execution) {
  report_progress(execution, "surface_distance", 0);
  if (options.tolerance && !(*options.tolerance >= 0)) {
    throw InputError("surface_distance: the tolerance is no number from 0 on");
  }
  for (const TriangleMesh* mesh : {&a, &b}) {
    require_valid_triangles(*mesh);
    require_finite(*mesh);
  }
  // Areas take fourth powers of lengths: beyond working sizes they would overflow or vanish.
  const double scale = common_scale(corners_or_points(a), corners_or_points(b));
  SurfaceDistance distance = measure_both(a, b, scale, options, execution);
  if (scale != 1) {
    for (DirectedDistance* directed : {&distance.a_to_b, &distance.b_to_a}) {
      unscale(*directed, scale);
      directed->farthest = directed->farthest / scale;
    }
    unscale(distance, scale);
  }
  report_progress(execution, "surface_distance", 1);
  return distance;
}

}  // namespace cocoon
