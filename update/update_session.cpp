#include "update/update_session.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "cocone/live/known_surface.h"
#include "geom/arrays/sort_ids.h"
#include "geom/errors.h"
#include "update/model/hollows.h"
#include "update/stage_options.h"

namespace cocoon {
namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  throw InputError(std::string("session: ") + what + "; start from the points again");
}

const UpdateOptions& checked(const UpdateOptions& options) {
  require_options("session", options);
  if (!options.overrides.is_empty()) {
    throw InputError(
        "session: regions that go or stay are those of one update; give them with its clouds");
  }
  return options;
}

// Zeros may differ in their signs.
std::array<std::uint64_t, 3> bits_of(const Point& p) {
  return std::bit_cast<std::array<std::uint64_t, 3>>(p);
}

void drop_values_by_vertex(ReconstructResult& result) {
  result.point_of_vertex = {};
  result.normals = {};
  result.boundary_sample = {};
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
  if (!snapshot.surface.has_surface()) return;
  const SurfaceMesh surface = known_surface(triangulation, snapshot.surface, execution);
  require(surface.mesh.triangles == snapshot.model.triangles &&
              surface.point_of_vertex == snapshot.point_of_vertex,
          "the model is not the surface of its points");
}

UpdateSession::UpdateSession(Points points, const UpdateOptions& options,
                             const Execution& execution, const KnownLabelsSource& known)
    : options_(checked(options)), surface_(options.reconstruct) {
  reconstruction_ = surface_.reconstruct(points, execution, known);
  model_ = std::move(reconstruction_.mesh);
  reconstruction_.mesh = {};
  model_is_surface_ = true;
  points_are_vertices_ = model_.points.size() == points.size();
  if (points_are_vertices_) return;
  points_.assign(points.begin(), points.end());
  point_of_vertex_ = reconstruction_.point_of_vertex;
}

UpdateSession::UpdateSession(TriangleMesh model, const UpdateOptions& options)
    : options_(checked(options)), model_(std::move(model)), surface_(options.reconstruct) {
  take_points_of_model();
}

UpdateSession::UpdateSession(SessionSnapshot snapshot, const UpdateOptions& options,
                             SnapshotCheck check, const Execution& execution)
    : options_(checked(options)), surface_(options.reconstruct) {
  if (check == SnapshotCheck::to_be_done) check_snapshot(snapshot, execution);
  model_ = std::move(snapshot.model);
  points_ = std::move(snapshot.points);
  point_of_vertex_ = std::move(snapshot.point_of_vertex);
  model_is_surface_ = snapshot.surface.has_surface();
  if (snapshot.triangulation.num_cells() != 0) {
    surface_.take(points_, {std::move(snapshot.triangulation), std::move(snapshot.surface)});
  }
  forget_points_of_vertices();
  if (!surface_.is_certain() || !points_are_vertices_) return;
  // Updates go on from the triangles of the model.
  index_ = ModelIndex::of_smooth(model_, execution);
  require(index_->is_really_smooth(execution),
          "the model is not a closed surface without contacts");
}

// If they tell nothing: each point is the vertex in its place.
void UpdateSession::forget_points_of_vertices() {
  points_are_vertices_ = points_.size() == model_.points.size();
  for (std::size_t i = 0; points_are_vertices_ && i < points_.size(); ++i) {
    const VertexId v(i);
    points_are_vertices_ =
        point_of_vertex_[v] == PointId(i) && bits_of(points_[i]) == bits_of(model_.points[v]);
  }
  if (!points_are_vertices_) return;
  points_ = {};
  point_of_vertex_ = {};
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
  forget_points_of_vertices();
}

ReconstructResult UpdateSession::reconstruction() const {
  ReconstructResult result = reconstruction_;
  const bool left_out = result.normals.empty() && result.status == SurfaceStatus::ok;
  if (left_out && result.vertices > 0) surface_.complete(result);
  return result;
}

const ModelIndex& UpdateSession::index(const Execution& execution) {
  const bool smooth = is_smooth();
  if (!index_ && !smooth) return index_.emplace(model_, execution);
  if (!index_) return index_.emplace(ModelIndex::of_smooth(model_, execution));
  if (smooth && !index_->is_known_smooth()) index_->prepare_for_edits();
  return *index_;
}

// Where the updated points were: kept model vertices know, points of clouds are new.
std::vector<PointId> UpdateSession::old_positions(const Replacement& replacement) const {
  std::vector<PointId> positions(replacement.points.size());
  for (const VertexId v : replacement.point_of_vertex.ids()) {
    const PointId p = replacement.point_of_vertex[v];
    if (!p.is_none()) positions[p.index()] = point_of_vertex(v);
  }
  return positions;
}

// Where the points of the model are among the updated ones; none: they go.
std::vector<PointId> UpdateSession::positions_after(const Replacement& replacement) const {
  std::vector<PointId> after(points().size());
  const std::vector<PointId> before = old_positions(replacement);
  for (std::size_t p = 0; p < before.size(); ++p) {
    if (!before[p].is_none()) after[before[p].index()] = PointId(p);
  }
  return after;
}

// If the model is the surface, all points are vertices, and no two of those that stay are one: what
// goes, and what comes behind all the others.
std::optional<ListEdit<PointId>> UpdateSession::edit_of_points(
    const Replacement& replacement) const {
  if (!model_is_surface_ || !points_are_vertices_) return {};
  if (!replacement.kept_are_distinct) return {};
  ListEdit<PointId> edit;
  edit.removed.reserve(replacement.vertices.removed.size());
  for (const VertexId v : replacement.vertices.removed) edit.removed.push_back(PointId(v.value));
  const std::size_t kept = replacement.point_of_vertex.size() - edit.removed.size();
  for (std::size_t p = kept; p < replacement.points.size(); ++p) edit.added.push_back(PointId(p));
  return edit;
}

ReconstructResult UpdateSession::reconstruct(const Replacement& replacement, const OldSurface& old,
                                             const Execution& execution, Pending& pending) {
  if (pending.done) take_back(std::exchange(pending, {}));
  ReconstructResult result;
  surface_.keep_cavities(keeps_cavities(options_.reconstruct, *index_));
  if (surface_.num_points() == 0) {
    result = surface_.reconstruct(replacement.points, execution, old.labels);
  } else if (pending.points = edit_of_points(replacement); pending.points) {
    DynamicTightCocone::Edited edited =
        surface_.edit(replacement.points, *pending.points, execution, old);
    pending.surface = std::move(edited.edit);
    result = std::move(edited.result);
  } else {
    result = surface_.replace(replacement.points, old_positions(replacement), execution, old);
  }
  if (!pending.surface) pending.position_after = positions_after(replacement);
  pending.done = true;
  return result;
}

// Of the surface that it led to.
std::size_t UpdateSession::num_triangles(const ReconstructResult& result,
                                         const Pending& pending) const {
  if (!pending.surface) return result.mesh.triangles.size();
  std::vector<TriangleId> before;
  for (const VertexId v : pending.surface->touched) {
    index_->for_each_triangle_at(v, [&](TriangleId t) { before.push_back(t); });
  }
  make_set(before);
  return model_.triangles.size() - before.size() + pending.surface->triangles.size();
}

// The points of the surface are again those of the model. Nobody knows what labels were known for
// that.
void UpdateSession::take_back(const Pending& pending) {
  if (!pending.done) return;
  if (pending.points) {
    surface_.edit(points(), pending.points->reversed());
  } else {
    surface_.replace(points(), pending.position_after);
  }
  surface_.forget_body();
}

SessionUpdate UpdateSession::apply(std::span<const std::vector<Point>> clouds,
                                   const Execution& execution) {
  return apply(clouds, {}, execution);
}

SessionUpdate UpdateSession::apply(std::span<const std::vector<Point>> clouds,
                                   const RegionOverrides& overrides, const Execution& execution) {
  if (model_is_surface_ && points_are_vertices_) surface_.look_if_smooth(execution);
  Pending pending;
  const UpdateParts parts{
      [&](const Execution& nested) -> const ModelIndex& { return index(nested); },
      [&](const Replacement& replacement, const OldSurface& old, const Execution& nested) {
        ReconstructResult result = reconstruct(replacement, old, nested, pending);
        const std::size_t triangles = num_triangles(result, pending);
        UpdatedSurface surface{std::move(result), triangles};
        if (pending.surface) surface.changed = pending.surface->triangles;
        return surface;
      },
      is_smooth()};
  SessionUpdate update;
  try {
    UpdateOptions options = options_;
    options.overrides = overrides;
    update.result = update_model(model_, clouds, parts, options, execution);
  } catch (...) {
    take_back(pending);
    throw;
  }
  if (update.result.status == UpdateStatus::ok) {
    keep(update, std::move(pending));
  } else {
    take_back(pending);
  }
  return update;
}

void UpdateSession::keep(SessionUpdate& update, Pending pending) {
  if (pending.surface) {
    keep_edit(update, std::move(pending));
  } else {
    keep_body(update, std::move(pending.position_after));
  }
  if (history_.size() > most_undo_levels_) history_.pop_front();
}

void UpdateSession::limit_undo(std::size_t levels) {
  most_undo_levels_ = std::min(levels, max_undo_levels);
  while (history_.size() > most_undo_levels_) history_.pop_front();
}

// The result keeps nothing by vertex, the session all of it.
void UpdateSession::push(ReconstructResult after, std::variant<Body, MeshEdit> way) {
  history_.push_back({std::exchange(reconstruction_, std::move(after)), std::move(way)});
}

void UpdateSession::keep_edit(SessionUpdate& update, Pending pending) {
  UpdateResult& result = update.result;
  const ListEdit<PointId>& points = *pending.points;
  ListEdit<VertexId> vertices;
  for (const PointId p : points.removed) vertices.removed.push_back(VertexId(p.value));
  for (const PointId p : points.added) vertices.added.push_back(VertexId(p.value));
  std::vector<Point> updated = std::exchange(result.replacement.points, {});
  MeshEdit edit = mesh_edit(*index_, std::move(vertices), result.vertex_map,
                            Points(updated).last(points.added.size()), pending.surface->touched,
                            pending.surface->triangles);
  update.change = carry_out(edit, std::move(updated), result.vertex_map);
  // What can be asked of the surface is not kept.
  drop_values_by_vertex(reconstruction_);
  push(result.reconstruction, std::move(edit));
}

// From one smooth mesh to the next one, with these points.
MeshChange UpdateSession::carry_out(const MeshEdit& edit, std::vector<Point> points,
                                    IdVector<VertexId, VertexId> vertex_map) {
  MeshChange change;
  change.triangle_map = places_after(edit.triangles, model_.triangles.size());
  model_.points = IdVector<VertexId, Point>(std::move(points));
  edit_triangles(model_.triangles, edit, vertex_map);
  if (index_ && index_->is_known_smooth()) {
    index_->edit({edit.vertices, edit.triangles, change.triangle_map});
  } else {
    index_.reset();
  }
  change.vertex_map = std::move(vertex_map);
  change.removed = edit.removed;
  change.added = edit.added;
  return change;
}

void UpdateSession::keep_body(SessionUpdate& update, std::vector<PointId> positions_after) {
  UpdateResult& result = update.result;
  update.change = mesh_change(model_, result.mesh, result.vertex_map);
  Body before;
  before.distinct_points = index_->has_distinct_points();
  before.next_vertex = result.vertex_map;
  before.position_after = std::move(positions_after);
  before.model = std::exchange(model_, std::exchange(result.mesh, {}));
  before.points = std::exchange(points_, std::exchange(result.replacement.points, {}));
  before.point_of_vertex = std::exchange(point_of_vertex_, result.reconstruction.point_of_vertex);
  before.points_are_vertices = points_are_vertices_;
  before.is_surface = std::exchange(model_is_surface_, true);
  forget_points_of_vertices();
  // Equal points were merged, so those of the new model differ.
  index_ = ModelIndex(model_, IndexBefore{*index_, before.model, update.change, true});
  push(result.reconstruction, std::move(before));
  drop_values_by_vertex(result.reconstruction);
}

MeshChange UpdateSession::undo(const Execution& execution) {
  if (history_.empty()) {
    throw InputError("session: there is no update to take back; ask undo_levels() first");
  }
  Step& last = history_.back();
  MeshChange change;
  if (const MeshEdit* edit = std::get_if<MeshEdit>(&last.way)) {
    change = undo_edit(edit->reversed(), execution);
  } else {
    change = undo_to(std::get<Body>(last.way), execution);
  }
  reconstruction_ = std::move(last.reconstruction);
  history_.pop_back();
  return change;
}

MeshChange UpdateSession::undo_edit(const MeshEdit& edit, const Execution& execution) {
  IdVector<VertexId, Point> before = model_.points;
  edit_list(before, edit.vertices, edit.added_points);
  ListEdit<PointId> points;
  for (const VertexId v : edit.vertices.removed) points.removed.push_back(PointId(v.value));
  for (const VertexId v : edit.vertices.added) points.added.push_back(PointId(v.value));
  const DynamicTightCocone::Edited edited = surface_.edit(before.span(), points, execution);
  IdVector<VertexId, VertexId> vertex_map = places_after(edit.vertices, model_.points.size());
  MeshChange change = carry_out(edit, std::move(before.raw()), std::move(vertex_map));
  const bool is_found =
      edited.edit && index_ &&
      leads_to(edit, *index_, change.vertex_map, edited.edit->touched, edited.edit->triangles);
  if (!is_found) surface_.forget_body();
  return change;
}

MeshChange UpdateSession::undo_to(Body& before, const Execution& execution) {
  const ReconstructResult found = surface_.replace(
      before.points_are_vertices ? before.model.points.span() : Points(before.points),
      before.position_after, execution);
  if (found.mesh.triangles != before.model.triangles) surface_.forget_body();
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
  points_are_vertices_ = before.points_are_vertices;
  model_is_surface_ = before.is_surface;
  point_of_vertex_ = std::move(before.point_of_vertex);
  return change;
}

IdVector<VertexId, PointId> UpdateSession::points_of_vertices() const {
  IdVector<VertexId, PointId> points;
  points.reserve(model_.points.size());
  for (const VertexId v : model_.points.ids()) points.push_back(point_of_vertex(v));
  return points;
}

SessionSnapshot UpdateSession::snapshot() const {
  DynamicTightCocone::Snapshot surface;
  if (surface_.num_points() != 0) surface = surface_.snapshot();
  if (!model_is_surface_) surface.surface.forget_surface();
  return {model_,
          {points().begin(), points().end()},
          points_of_vertices(),
          std::move(surface.triangulation),
          std::move(surface.surface)};
}

SessionSnapshot UpdateSession::release() && {
  history_.clear();
  index_.reset();
  DynamicTightCocone::Snapshot surface;
  if (surface_.num_points() != 0) surface = std::move(surface_).release();
  if (!model_is_surface_) surface.surface.forget_surface();
  IdVector<VertexId, PointId> points_of_vertices = this->points_of_vertices();
  std::vector<Point> points = points_are_vertices_ ? model_.points.raw() : std::move(points_);
  reconstruction_ = {};
  return {std::exchange(model_, {}), std::move(points), std::move(points_of_vertices),
          std::move(surface.triangulation), std::move(surface.surface)};
}

}  // namespace cocoon
