#include "update/update_session.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "geom/errors.h"

namespace cocoon {
namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  throw InputError(std::string("session: ") + what + "; start from the points again");
}

}  // namespace

void check_snapshot(const SessionSnapshot& snapshot, const Execution& execution) {
  const std::size_t vertices = snapshot.model.points.size();
  require(std::all_of(snapshot.points.begin(), snapshot.points.end(),
                      [](const Point& p) { return is_finite(p); }),
          "a point is not finite");
  require(snapshot.point_of_vertex.size() == vertices, "model and points do not fit together");
  for (const VertexId v : snapshot.model.points.ids()) {
    const PointId p = snapshot.point_of_vertex[v];
    require(p.is_none() || (p.index() < snapshot.points.size() &&
                            snapshot.points[p.index()] == snapshot.model.points[v]),
            "a vertex of the model is none of its points");
  }
  for (const Triangle& t : snapshot.model.triangles) {
    for (const VertexId v : t) {
      require(v.index() < vertices && !snapshot.point_of_vertex[v].is_none(),
              "a triangle of the model names a vertex that is not there");
    }
  }
  const Triangulation& triangulation = snapshot.triangulation;
  require(triangulation.num_cells() != 0 || snapshot.surface.empty(),
          "a surface without a triangulation");
  if (triangulation.num_cells() == 0) return;
  require(triangulation.vertex_of_point().size() == snapshot.points.size(),
          "triangulation and points do not fit together");
  for (const PointId p : triangulation.vertex_of_point().ids()) {
    require(triangulation.point(triangulation.vertex_of_point()[p]) == snapshot.points[p.index()],
            "a vertex of the triangulation is none of the points");
  }
  try {
    check_surface_state(triangulation, snapshot.surface, execution);
  } catch (const InputError& error) {
    require(false, error.what());
  }
}

UpdateSession::UpdateSession(Points points, const UpdateOptions& options,
                             const Execution& execution)
    : options_(options), points_(points.begin(), points.end()), surface_(options.reconstruct) {
  reconstruction_ = surface_.reconstruct(points_, execution);
  model_ = std::move(reconstruction_.mesh);
  reconstruction_.mesh = {};
  point_of_vertex_ = reconstruction_.point_of_vertex;
}

UpdateSession::UpdateSession(TriangleMesh model, const UpdateOptions& options)
    : options_(options), model_(std::move(model)), surface_(options.reconstruct) {
  take_points_of_model();
}

UpdateSession::UpdateSession(SessionSnapshot snapshot, const UpdateOptions& options,
                             SnapshotCheck check)
    : options_(options), surface_(options.reconstruct) {
  if (check == SnapshotCheck::to_be_done) check_snapshot(snapshot);
  model_ = std::move(snapshot.model);
  points_ = std::move(snapshot.points);
  point_of_vertex_ = std::move(snapshot.point_of_vertex);
  if (snapshot.triangulation.num_cells() != 0) {
    surface_.take(points_, {std::move(snapshot.triangulation), std::move(snapshot.surface)});
  }
}

// The points of a mesh are the vertices that its triangles use.
void UpdateSession::take_points_of_model() {
  point_of_vertex_ = IdVector<VertexId, PointId>(model_.points.size());
  for (const Triangle& t : model_.triangles) {
    for (const VertexId v : t) {
      // ModelIndex refuses such a mesh, and says why.
      if (v.index() < point_of_vertex_.size()) point_of_vertex_[v] = PointId(0);
    }
  }
  for (const VertexId v : model_.points.ids()) {
    if (point_of_vertex_[v].is_none()) continue;
    point_of_vertex_[v] = PointId(points_.size());
    points_.push_back(model_.points[v]);
  }
}

// Where the updated points were: kept model vertices know, points of clouds are new.
std::vector<PointId> UpdateSession::old_positions(const Replacement& replacement) const {
  std::vector<PointId> positions(replacement.points.size());
  for (const VertexId v : replacement.point_of_vertex.ids()) {
    const PointId p = replacement.point_of_vertex[v];
    if (!p.is_none()) positions[p.index()] = point_of_vertex_[v];
  }
  return positions;
}

ReconstructResult UpdateSession::reconstruct(const Replacement& replacement,
                                             const KnownTriangleSource& known,
                                             const Execution& execution) {
  if (surface_.num_points() == 0) {
    return surface_.reconstruct(replacement.points, execution, known);
  }
  return surface_.replace(replacement.points, old_positions(replacement), execution, known);
}

// Where the points of the model are among the updated ones; none: they go.
std::vector<PointId> UpdateSession::positions_after(const Replacement& replacement) const {
  std::vector<PointId> after(points_.size());
  const std::vector<PointId> before = old_positions(replacement);
  for (std::size_t p = 0; p < before.size(); ++p) {
    if (!before[p].is_none()) after[before[p].index()] = PointId(p);
  }
  return after;
}

SessionUpdate UpdateSession::apply(std::span<const std::vector<Point>> clouds,
                                   const Execution& execution) {
  std::vector<PointId> after;  // not empty: the surface is that of the updated points
  const UpdateParts parts{[&]() -> const ModelIndex& {
                            if (!index_) index_.emplace(model_);
                            return *index_;
                          },
                          [&](const Replacement& replacement, const KnownTriangleSource& known,
                              const Execution& nested) {
                            ReconstructResult result = reconstruct(replacement, known, nested);
                            after = positions_after(replacement);
                            return result;
                          }};
  SessionUpdate update;
  try {
    update.result = update_model(model_, clouds, parts, options_, execution);
  } catch (...) {
    if (!after.empty()) surface_.replace(points_, after);
    throw;
  }
  if (update.result.status == UpdateStatus::ok) {
    keep(update, std::move(after));
  } else if (!after.empty()) {
    surface_.replace(points_, after);
  }
  return update;
}

void UpdateSession::keep(SessionUpdate& update, std::vector<PointId> positions_after) {
  UpdateResult& result = update.result;
  update.change = mesh_change(model_, result.mesh, result.vertex_map);
  Body before;
  before.distinct_points = index_->has_distinct_points();
  before.next_vertex = result.vertex_map;
  before.position_after = std::move(positions_after);
  before.model = std::exchange(model_, std::exchange(result.mesh, {}));
  before.points = std::exchange(points_, result.replacement.points);
  before.point_of_vertex = std::exchange(point_of_vertex_, result.reconstruction.point_of_vertex);
  before.reconstruction = std::exchange(reconstruction_, result.reconstruction);
  // Equal points were merged, so those of the new model differ.
  index_ = ModelIndex(model_, IndexBefore{*index_, before.model, update.change, true});
  history_.push_back(std::move(before));
  if (history_.size() > max_undo_levels) history_.pop_front();
}

MeshChange UpdateSession::undo(const Execution& execution) {
  assert(!history_.empty());
  Body& before = history_.back();
  surface_.replace(before.points, before.position_after, execution);
  IdVector<VertexId, VertexId> vertex_map(model_.points.size());
  for (const VertexId v : before.next_vertex.ids()) {
    if (!before.next_vertex[v].is_none()) vertex_map[before.next_vertex[v]] = v;
  }
  MeshChange change = mesh_change(model_, before.model, std::move(vertex_map));
  std::swap(model_, before.model);
  if (index_) {
    index_ = ModelIndex(model_, IndexBefore{*index_, before.model, change, before.distinct_points});
  }
  points_ = std::move(before.points);
  point_of_vertex_ = std::move(before.point_of_vertex);
  reconstruction_ = std::move(before.reconstruction);
  history_.pop_back();
  return change;
}

SessionSnapshot UpdateSession::snapshot() const {
  DynamicTightCocone::Snapshot surface;
  if (surface_.num_points() != 0) surface = surface_.snapshot();
  return {model_, points_, point_of_vertex_, std::move(surface.triangulation),
          std::move(surface.surface)};
}

}  // namespace cocoon
