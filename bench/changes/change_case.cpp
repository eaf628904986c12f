#include "bench/changes/change_case.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bench/changes/random_change.h"
#include "bench/changes/random_part.h"
#include "cocone/reconstruct.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "geom/search/nearest_point.h"
#include "geom/surface_distance.h"
#include "io/models/polygonize.h"

namespace cocoon::bench {
namespace {

constexpr double mesh_cell = 0.5;
constexpr double jitter = 0.02;
constexpr std::size_t fewest_samples = 20;
constexpr double largest_median_gap = 1.5;
constexpr double step = 1e-4;        // of differences
constexpr double same_place = 1e-9;  // above the rounding of two functions

// A place of the surface and the direction outward.
LocalFrame random_place(const ImplicitSolid& solid, const TriangleMesh& mesh, Random& random) {
  const TrianglesByArea triangles(mesh);
  const TriangleId t = triangles.at(random.uniform(0, triangles.area()));
  const Point p = project_to_surface(solid.value, random_point_in(mesh, t, random), step);
  return random_frame(p, unit(gradient(solid.value, p, step)), random);
}

// How far each changed place is from all samples, ascending.
std::vector<double> gaps(const std::vector<Point>& changed,
                         const std::vector<std::vector<Point>>& clouds) {
  std::vector<Point> samples;
  for (const std::vector<Point>& cloud : clouds) {
    samples.insert(samples.end(), cloud.begin(), cloud.end());
  }
  const NearestPointTree tree(samples);
  std::vector<double> distances;
  distances.reserve(changed.size());
  for (const Point& p : changed) distances.push_back(std::sqrt(tree.nearest(p).squared_distance));
  std::sort(distances.begin(), distances.end());
  return distances;
}

// The samples of the part before the change, told apart, and its model.
void sample_model_of(const RandomChange& change, const TriangleMesh& surface, Random& random,
                     ChangeCase& result) {
  const auto count = static_cast<std::size_t>(mesh_measure(surface).area);
  std::vector<Point> samples = sample_surface(
      change.before, surface, [](const Point&) { return true; }, count, random);
  for (Point& p : samples) {
    const bool is_wrong = std::abs(change.after.value(p)) > same_place;
    p = p + (jitter * random.uniform()) * random.on_unit_sphere();
    (is_wrong ? result.wrong : result.right).push_back(p);
  }
  std::sort(samples.begin(), samples.end());
  result.model = reconstruct_tight(samples).mesh;
}

bool has_one_part(const TriangleMesh& mesh) {
  const MeshReport report = mesh_check(mesh);
  return report.components == 1 && report.genus;
}

std::optional<ChangeCase> attempt(ScanKind kind, Random& random) {
  ChangeCase result;
  const RandomPart part = random_part(random);
  const TriangleMesh bare = polygonize(part.solid, mesh_cell);
  const LocalFrame place = random_place(part.solid, bare, random);
  const RandomChange change = random_change(part.solid, place, random);
  result.part = part.name;
  result.change = change.name;
  result.truth = polygonize(change.after, mesh_cell);
  const TriangleMesh surface = polygonize(change.before, mesh_cell);
  if (!has_one_part(surface) || !has_one_part(result.truth)) return {};

  sample_model_of(change, surface, random, result);
  const std::size_t most_wrong = result.right.size() / 2;
  if (result.wrong.empty() || result.wrong.size() > most_wrong) return {};
  if (!is_right(result.model, surface, 2)) return {};

  result.setting = random_setting(kind, random);
  const auto region =
      ScannedRegion::around_change(change.before.value, result.truth, result.setting, random);
  if (!region) return {};
  result.clouds =
      simulated_scan(change.after, result.truth, *region, place.z, result.setting, random);
  const bool is_scanned =
      std::all_of(result.clouds.begin(), result.clouds.end(),
                  [](const std::vector<Point>& cloud) { return cloud.size() >= fewest_samples; });
  if (!is_scanned) return {};
  const std::vector<double> distances = gaps(region->changed(), result.clouds);
  if (distances[distances.size() / 2] > largest_median_gap) return {};
  result.gap = distances.back();
  return result;
}

}  // namespace

bool is_right(const TriangleMesh& mesh, const TriangleMesh& truth, double reach) {
  if (mesh.triangles.empty()) return false;
  const MeshReport found = mesh_check(mesh);
  const MeshReport wanted = mesh_check(truth);
  if (!found.genus || found.genus != wanted.genus || found.components != wanted.components) {
    return false;
  }
  return surface_distance(mesh, truth, {.samples = 20000}).max <= reach;
}

ChangeCase change_case(std::uint64_t seed, ScanKind kind) {
  Random random(16 * seed + static_cast<std::uint64_t>(kind));
  for (;;) {
    std::optional<ChangeCase> found = attempt(kind, random);
    if (found) return std::move(*found);
  }
}

}  // namespace cocoon::bench
