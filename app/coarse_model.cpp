#include "app/coarse_model.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/search/neighbor_distance.h"
#include "update/report/cloud_report.h"
#include "update/report/lost_triangles.h"

namespace cocoon::app {

namespace {

// In two digits, as it is told: --densify with this number gives the same.
double spacing_of(const std::vector<std::vector<Point>>& clouds, std::size_t neighbor) {
  double spacing = 0;
  for (const std::vector<Point>& cloud : clouds) {
    spacing = std::max(spacing, median_neighbor_distance(cloud, neighbor));
  }
  return std::strtod(fmt::format("{:.2g}", spacing).c_str(), nullptr);
}

struct LargeTriangles {
  double area = 0;   // of all triangles
  double share = 0;  // of it in large ones
};

LargeTriangles large_triangles(const TriangleMesh& mesh, double limit) {
  LargeTriangles result;
  double large = 0;
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto [a, b, c] = corners_of(mesh, t);
    const double area = area_of(mesh, t);
    result.area += area;
    if (std::max({distance(a, b), distance(b, c), distance(c, a)}) > limit) large += area;
  }
  if (result.area > 0) result.share = large / result.area;
  return result;
}

bool has_properties(const UpdateInput& input) {
  return !input.properties.empty() && !input.properties.front().columns.empty();
}

// Where each vertex of the model went when it was made dense and updated; none: it has gone.
IdVector<VertexId, PointId> points_after(const UpdateInput& model, const UpdateInput& dense,
                                         const UpdateResult& result) {
  IdVector<VertexId, PointId> point_of_vertex(model.model.points.size());
  for (const VertexId of_file : dense.vertex_of_file.ids()) {
    const VertexId at = model.vertex_of_file.empty() ? of_file : model.vertex_of_file[of_file];
    const VertexId in_dense = dense.vertex_of_file[of_file];
    if (at.is_none() || in_dense.is_none()) continue;
    point_of_vertex[at] = result.replacement.point_of_vertex[in_dense];
  }
  return point_of_vertex;
}

// The triangles of the model that stay in both updates.
std::vector<TriangleId> staying_triangles(const TriangleMesh& model,
                                          const IdVector<VertexId, PointId>& first,
                                          const IdVector<VertexId, PointId>& second) {
  std::vector<TriangleId> staying;
  for (const TriangleId t : model.triangles.ids()) {
    const Triangle& corners = model.triangles[t];
    const bool stays = std::none_of(corners.begin(), corners.end(), [&](VertexId v) {
      return first[v].is_none() || second[v].is_none();
    });
    if (stays) staying.push_back(t);
  }
  return staying;
}

// Whether the dense one keeps more of the surface of the mesh.
bool keeps_more(const UpdateInput& input, const UpdateOutcome& outcome, const UpdateInput& dense,
                const UpdateOutcome& outcome_of_dense, const CoarseModelOptions& coarse) {
  const UpdateResult& result = outcome.update.result;
  const UpdateResult& of_dense = outcome_of_dense.update.result;
  if (of_dense.status != UpdateStatus::ok) return false;
  if (result.status != UpdateStatus::ok) return !outcome_of_dense.lost.warns;
  const std::vector<TriangleId> staying = staying_triangles(
      input.model, result.replacement.point_of_vertex, points_after(input, dense, of_dense));
  const std::vector<Scan> scans = scans_of(input.clouds, result.clouds);
  const auto lost_area = [&](const TriangleMesh& updated) {
    return astray_triangles(input.model, staying, updated, scans).area;
  };
  return lost_area(of_dense.mesh) <= coarse.max_lost * lost_area(result.mesh);
}

std::string warning_of(const UpdateInput& input, const UpdateOutcome& outcome, double spacing) {
  const UpdateResult& result = outcome.update.result;
  const std::string what =
      result.status == UpdateStatus::ok
          ? fmt::format("{:.0f} % of its surface would be lost", 100 * *outcome.lost.share)
          : fmt::format("it cannot be updated so ({})", name_of(result.status));
  return fmt::format(
      "{} has few vertices and large triangles, and {}: it was made dense first (as by --densify "
      "{}; --keep-coarse takes its vertices alone)",
      input.model_name, what, spacing);
}

void add_coarse_model(JsonReport& report, const UpdateOutcome& outcome, double spacing,
                      bool is_taken) {
  report.set("update/coarse_model/status", std::string(name_of(outcome.update.result.status)));
  if (outcome.lost.share) {
    report.set("update/coarse_model/astray_area_share", *outcome.lost.share);
  }
  report.set("update/coarse_model/spacing", spacing);
  report.set("update/coarse_model/made_dense", is_taken);
}

// The same made dense and updated, if that keeps more of the surface.
struct DenseUpdate {
  UpdateInput input;
  UpdateOutcome outcome;
};

std::optional<DenseUpdate> made_dense(Job& job, const UpdateInput& input,
                                      const UpdateOutcome& outcome, const UpdateOptions& options,
                                      double spacing, const CoarseModelOptions& coarse) {
  JsonReport before = job.report().copy();
  try {
    DenseUpdate dense{with_dense_model(job, input, spacing, options.reconstruct), {}};
    dense.outcome = updated(job, dense.input, options);
    if (keeps_more(input, outcome, dense.input, dense.outcome, coarse)) return dense;
  } catch (const InputError&) {
    // Its samples have no surface, or none that can be updated: the first outcome stands.
  }
  job.report() = std::move(before);
  return {};
}

}  // namespace

UpdateOutcome updated_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                                   const CoarseModelOptions& coarse) {
  if (!input.is_mesh_of_file || has_properties(input)) return updated(job, input, options);
  const double spacing = spacing_of(input.clouds, coarse.neighbor);
  const LargeTriangles large = large_triangles(input.model, coarse.large * spacing);
  const bool may_be_coarse = spacing > 0 && large.share >= coarse.min_large_share &&
                             large.area <= coarse.most_samples * spacing * spacing;
  if (!may_be_coarse) return updated(job, input, options);
  UpdateOptions unsaid = options;
  unsaid.overrides = {};
  UpdateOutcome outcome = updated(job, input, unsaid);
  const bool is_coarse = outcome.update.result.status == UpdateStatus::ok
                             ? outcome.lost.is_coarse
                             : large.share >= coarse.min_large_share_if_refused;
  if (is_coarse) {
    std::optional<DenseUpdate> dense = made_dense(job, input, outcome, unsaid, spacing, coarse);
    add_coarse_model(job.report(), outcome, spacing, dense.has_value());
    if (!dense) outcome.lost.tried = spacing;
    if (dense) {
      job.warn(warning_of(input, outcome, spacing));
      input = std::move(dense->input);
      outcome = std::move(dense->outcome);
    }
  }
  return options.overrides.is_empty() ? std::move(outcome) : updated(job, input, options);
}

}  // namespace cocoon::app
