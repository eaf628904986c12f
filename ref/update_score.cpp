#include "ref/update_score.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"

namespace cocoon::ref {

namespace {

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double UpdateScore::precision() const { return share(wrong_and_gone, gone); }
double UpdateScore::recall() const { return share(wrong_and_gone, wrong); }

UpdateScore score_update(const TriangleMesh& model, const UpdateResult& result, Points wrong_points,
                         const TriangleMesh& truth, const SurfaceDistanceOptions& options,
                         const Execution& execution) {
  const bool is_done = result.status == UpdateStatus::ok;
  if (is_done && result.vertex_map.size() != model.points.size()) {
    throw InputError("score_update: the result is not an update of this model; pass the same one");
  }
  UpdateScore score;

  // 1. What is gone.
  std::vector<Point> wrong(wrong_points.begin(), wrong_points.end());
  std::sort(wrong.begin(), wrong.end());
  for (const VertexId v : model.points.ids()) {
    const bool is_wrong = std::binary_search(wrong.begin(), wrong.end(), model.points[v]);
    const VertexId mapped = is_done ? result.vertex_map[v] : VertexId{};
    score.wrong += is_wrong ? 1 : 0;
    score.gone += mapped.is_none() ? 1 : 0;
    score.wrong_and_gone += is_wrong && mapped.is_none() ? 1 : 0;
    score.moved += !mapped.is_none() && result.mesh.points[mapped] != model.points[v] ? 1 : 0;
  }

  // 2. What kind of surface is there.
  const MeshReport updated = mesh_check(result.mesh);
  const MeshReport wanted = mesh_check(truth);
  score.closed_manifold = updated.is_closed_manifold();
  score.genus = updated.genus;
  score.components = updated.components;
  score.true_genus = wanted.genus;
  score.true_components = wanted.components;

  // 3. How far it is from where it should be.
  score.spacing = std::sqrt(mesh_measure(model).area / static_cast<double>(model.points.size()));
  if (is_done) score.distance = surface_distance(result.mesh, truth, options, execution);
  return score;
}

UpdateScore score_update(const TriangleMesh& model, const UpdateResult& result,
                         const SampleModel& sample, const SurfaceDistanceOptions& options,
                         const Execution& execution) {
  std::vector<Point> wrong;
  for (const PointId p : sample.replaced) wrong.push_back(sample.initial[p.index()]);
  return score_update(model, result, wrong, sample.truth, options, execution);
}

}  // namespace cocoon::ref
