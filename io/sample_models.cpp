#include "io/sample_models.h"

#include <cmath>

#include "geom/errors.h"
#include "geom/mesh_measure.h"
#include "geom/random.h"
#include "io/polygonize.h"
#include "io/sample_block.h"

namespace cocoon {
namespace {

struct NamedDesign {
  std::string_view name;
  SampleModelDesign (*make)();
};

constexpr NamedDesign designs[] = {{"block", block_design}};

// A place on the old surface counts as changed if the new surface passes it by more than this
// fraction of the model's size: above the rounding of both functions, below all else.
constexpr double changed_by = 1e-9;

void require_valid(const SampleOptions& options) {
  const auto too_few = [](const std::optional<std::size_t>& count) { return count && *count < 4; };
  if (too_few(options.points) || too_few(options.cloud_points)) {
    throw InputError("sample needs at least 4 points in every cloud; ask for more");
  }
  if (!(options.jitter >= 0 && options.jitter <= 1)) {
    throw InputError("jitter must be a fraction of the spacing between 0 and 1");
  }
}

// Area of the triangles with their first corner in the region: to measure a mean spacing by.
double area_in(const TriangleMesh& mesh, const SurfaceRegion& region) {
  TriangleMesh part = {mesh.points, {}};
  for (const Triangle& t : mesh.triangles) {
    if (region(mesh.points[t[0]])) part.triangles.push_back(t);
  }
  return mesh_measure(part).area;
}

void jitter(std::vector<Point>& points, double reach, Random& random) {
  for (Point& p : points) {
    const Vec3 direction = random.on_unit_sphere();
    p = p + (reach * random.uniform()) * direction;
  }
}

}  // namespace

std::vector<std::string> sample_model_names() {
  std::vector<std::string> names;
  for (const NamedDesign& design : designs) names.emplace_back(design.name);
  return names;
}

SampleModel sample_model(std::string_view name, const SampleOptions& options) {
  std::string known;
  for (const NamedDesign& design : designs) {
    if (design.name == name) return sample_design(design.make(), options);
    known += (known.empty() ? "" : ", ") + std::string(design.name);
  }
  throw InputError("there is no sample model \"" + std::string(name) +
                   "\"; choose one of: " + known);
}

SampleModel sample_design(const SampleModelDesign& design, const SampleOptions& options) {
  require_valid(options);
  Random random(options.seed);
  SampleModel model;
  const auto spacing = [](double area, std::size_t count) {
    return std::sqrt(area / static_cast<double>(count));
  };

  // 1. The initial points, and which of them the change makes wrong.
  const SurfaceRegion everywhere = [](const Point&) { return true; };
  const TriangleMesh old_surface = polygonize(design.before, design.mesh_cell);
  model.initial = sample_surface(design.before, old_surface, everywhere,
                                 options.points.value_or(design.points), random);
  const double tolerance = changed_by * norm(design.before.box.size());
  for (const PointId id : id_range<PointId>(model.initial.size())) {
    const double off = std::abs(design.after.value(model.initial[id.index()]));
    if (off > tolerance) model.replaced.push_back(id);
  }
  jitter(model.initial,
         options.jitter * spacing(area_in(old_surface, everywhere), model.initial.size()), random);

  // 2. The true surface and its scans.
  model.truth = polygonize(design.after, design.mesh_cell);
  for (std::size_t k = 0; k < design.scanned.size(); ++k) {
    const std::size_t count = options.cloud_points.value_or(design.cloud_points[k]);
    std::vector<Point> cloud =
        sample_surface(design.after, model.truth, design.scanned[k], count, random);
    jitter(cloud, options.jitter * spacing(area_in(model.truth, design.scanned[k]), count), random);
    model.clouds.push_back(std::move(cloud));
  }
  return model;
}

}  // namespace cocoon
