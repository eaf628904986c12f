#include "io/sample_models.h"

#include <cmath>
#include <iterator>
#include <numeric>

#include "geom/errors.h"
#include "geom/mesh_measure.h"
#include "geom/random/random.h"
#include "geom/search/nearest_point.h"
#include "io/models/polygonize.h"
#include "io/models/sample_airbag.h"
#include "io/models/sample_block.h"
#include "io/models/sample_golf_club.h"
#include "io/models/sample_joystick.h"

namespace cocoon {
namespace {

struct NamedDesign {
  std::string_view name;
  SampleModelDesign (*make)();
};

constexpr NamedDesign designs[] = {{"block", block_design},
                                   {"airbag", airbag_design},
                                   {"golf-club", golf_club_design},
                                   {"joystick-1", joystick_console_design},
                                   {"joystick-2", joystick_grip_design}};

// A place on the old surface counts as changed if the new surface passes it by more than this
// fraction of the model's size: above the rounding of both functions, below all else.
constexpr double changed_by = 1e-9;

// What is farther from the old surface than this many spacings is scanned, whichever initial point
// is closest to it: that may lie across a wall or a well.
constexpr double surely_changed = 0.3;
// A cloud's outline is nearer to the wrong initial points than to the right ones, by this ratio:
// where a right one juts into the change, the cloud's surface closes a dent that is too narrow.
constexpr double outline_ratio = 0.65;
// Triangles that reach into a scanned place have a corner that is surely changed or within this
// many spacings of a wrong initial point.
constexpr double scan_reach = 1.5;

void require_valid(const SampleOptions& options, std::size_t clouds) {
  if ((options.points && *options.points < 4) ||
      (options.cloud_points && *options.cloud_points < 4 * clouds)) {
    throw InputError("sample needs at least 4 points in every cloud; ask for more");
  }
  if (options.points.value_or(0) > most_sample_points ||
      options.cloud_points.value_or(0) > most_sample_points) {
    throw InputError("sample makes at most " + std::to_string(most_sample_points) +
                     " points, and as many in its clouds; ask for less");
  }
  if (!(options.jitter >= 0 && options.jitter <= 1)) {
    throw InputError("jitter must be a fraction of the spacing between 0 and 1");
  }
}

double mean_spacing(const TriangleMesh& mesh, std::size_t points) {
  return std::sqrt(mesh_measure(mesh).area / static_cast<double>(points));
}

// `total` shared like `parts`: rounded down, the first ones get one more.
std::vector<std::size_t> shared_like(const std::vector<std::size_t>& parts, std::size_t total) {
  const std::size_t sum = std::accumulate(parts.begin(), parts.end(), std::size_t{0});
  std::vector<std::size_t> shares;
  shares.reserve(parts.size());
  for (const std::size_t part : parts) shares.push_back(total * part / sum);
  const std::size_t left = total - std::accumulate(shares.begin(), shares.end(), std::size_t{0});
  for (std::size_t k = 0; k < left; ++k) ++shares[k];
  return shares;
}

// Which places of the new surface one cloud covers.
class Scan {
 public:
  // The initial points: those in `change` that are wrong, at least one, and all that are right.
  Scan(const ImplicitFunction& before, const SurfaceRegion& change, Points wrong,
       const NearestPointTree& right, double spacing)
      : before_(before), change_(change), wrong_(wrong), right_(right), spacing_(spacing) {}

  bool covers(const Point& p) const {
    if (!change_(p)) return false;
    if (is_surely_changed(p)) return true;
    return wrong_.nearest(p).squared_distance <
           outline_ratio * outline_ratio * right_.nearest(p).squared_distance;
  }

  // The triangles that may reach into it, with all points of `mesh`.
  TriangleMesh candidates(const TriangleMesh& mesh) const {
    const double reach = scan_reach * spacing_;
    IdVector<VertexId, char> near(mesh.points.size(), 0);
    for (const VertexId v : mesh.points.ids()) {
      const Point& p = mesh.points[v];
      if (!change_(p)) continue;
      near[v] = is_surely_changed(p) || wrong_.nearest(p).squared_distance < reach * reach ? 1 : 0;
    }
    TriangleMesh part = {mesh.points, {}};
    for (const Triangle& t : mesh.triangles) {
      if (near[t[0]] != 0 || near[t[1]] != 0 || near[t[2]] != 0) part.triangles.push_back(t);
    }
    return part;
  }

 private:
  bool is_surely_changed(const Point& p) const {
    return std::abs(before_(p)) > surely_changed * spacing_;
  }

  const ImplicitFunction& before_;
  const SurfaceRegion& change_;
  NearestPointTree wrong_;
  const NearestPointTree& right_;
  double spacing_;
};

void jitter(std::vector<Point>& points, double reach, Random& random) {
  for (Point& p : points) {
    const Vec3 direction = random.on_unit_sphere();
    p = p + (reach * random.uniform()) * direction;
  }
}

std::vector<Point> points_in(const SurfaceRegion& region, Points points) {
  std::vector<Point> found;
  std::copy_if(points.begin(), points.end(), std::back_inserter(found), region);
  return found;
}

std::vector<Point> scan_of(const ImplicitSolid& solid, const TriangleMesh& surface,
                           const Scan& scan, std::size_t count, const SampleOptions& options,
                           Random& random, const Execution& execution) {
  const TriangleMesh part = scan.candidates(surface);
  std::vector<Point> cloud = sample_surface(
      solid, part, [&](const Point& p) { return scan.covers(p); }, count, random, execution);
  jitter(cloud, options.jitter * mean_spacing(part, count), random);
  return cloud;
}

// Throws InputError for a name that is not known.
SampleModelDesign design_of(std::string_view name) {
  std::string known;
  for (const NamedDesign& design : designs) {
    if (design.name == name) return design.make();
    known += (known.empty() ? "" : ", ") + std::string(design.name);
  }
  throw InputError("there is no sample model \"" + std::string(name) +
                   "\"; choose one of: " + known);
}

SampleModel sample_design(const SampleModelDesign& design, const SampleOptions& options,
                          const Execution& execution) {
  require_valid(options, design.changes.size());
  Random random(options.seed);
  SampleModel model;

  // 1. The initial points, and which of them the change makes wrong.
  const SurfaceRegion everywhere = [](const Point&) { return true; };
  const TriangleMesh old_surface = polygonize(design.before, design.mesh_cell);
  model.initial = sample_surface(design.before, old_surface, everywhere,
                                 options.points.value_or(design.points), random, execution);
  const double tolerance = changed_by * norm(design.before.box.size());
  std::vector<Point> wrong;
  std::vector<Point> right;
  for (const PointId id : id_range<PointId>(model.initial.size())) {
    const Point& p = model.initial[id.index()];
    const bool is_wrong = std::abs(design.after.value(p)) > tolerance;
    if (is_wrong) model.replaced.push_back(id);
    (is_wrong ? wrong : right).push_back(p);
  }
  const double spacing = mean_spacing(old_surface, model.initial.size());
  jitter(model.initial, options.jitter * spacing, random);

  // 2. The true surface and its scans.
  model.truth = polygonize(design.after, design.mesh_cell);
  const NearestPointTree right_tree(right);
  const std::vector<std::size_t> counts =
      options.cloud_points ? shared_like(design.cloud_points, *options.cloud_points)
                           : design.cloud_points;
  for (std::size_t k = 0; k < design.changes.size(); ++k) {
    const std::vector<Point> wrong_here = points_in(design.changes[k], wrong);
    if (wrong_here.empty()) {
      throw InputError("no initial point lies where change " + std::to_string(k + 1) +
                       " is; ask for more points");
    }
    const Scan scan(design.before.value, design.changes[k], wrong_here, right_tree, spacing);
    model.clouds.push_back(
        scan_of(design.after, model.truth, scan, counts[k], options, random, execution));
  }
  return model;
}

}  // namespace

std::vector<std::string> sample_model_names() {
  std::vector<std::string> names;
  for (const NamedDesign& design : designs) names.emplace_back(design.name);
  return names;
}

std::size_t sample_cloud_count(std::string_view name) {
  return design_of(name).cloud_points.size();
}

SampleModel sample_model(std::string_view name, const SampleOptions& options,
                         const Execution& execution) {
  return sample_design(design_of(name), options, execution);
}

}  // namespace cocoon
