// A model that is updated again and again: what one update computed is there for the next.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "cocone/dynamic_tight_cocone.h"
#include "cocone/live/surface_state.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/list_edit.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"
#include "update/model/mesh_change.h"
#include "update/model/mesh_edit.h"
#include "update/model/model_index.h"
#include "update/update_model.h"

namespace cocoon {

// What a session is made of, as plain data: to be kept elsewhere and taken up again.
struct SessionSnapshot {
  TriangleMesh model;
  std::vector<Point> points;                    // the current points, in the order of the user
  IdVector<VertexId, PointId> point_of_vertex;  // of each model vertex; none: no triangle has it
  Triangulation triangulation;                  // of `points`, or empty
  SurfaceState surface;                         // of that, or empty
};

// Throws InputError, one line, if the parts do not fit together or a coordinate is not finite;
// whether the triangulation is a Delaunay triangulation is for its reader to know. Complexity:
// O(n).
void check_snapshot(const SessionSnapshot& snapshot, const Execution& execution = {});

// Whether whoever hands a snapshot over has done that.
enum class SnapshotCheck { to_be_done, done };

// What one update did.
struct SessionUpdate {
  // If its status is ok, without what the session has then: no mesh, which is its model(), no
  // replacement.points, which are its points(), and of `reconstruction` nothing by vertex, which
  // its reconstruction() has.
  UpdateResult result;
  MeshChange change;  // empty unless result.status is ok
};

// Owns a model, the triangulation of its points, and what the update asks of it.
//
//   UpdateSession session(points);                 // or a mesh
//   const SessionUpdate update = session.apply(clouds);
//   if (update.result.status == UpdateStatus::ok) show(session.model(), update.change);
//   session.undo();
//
// After any sequence of updates and undos model() is, bit for bit, what update_model gives when it
// is called with the model from before and the same clouds; so are status, message, warnings and
// counts, apart from those of the Delaunay kernel. Options: InputError, too, for `overrides`, which
// name regions of one update: they are given with its clouds.
class UpdateSession {
 public:
  // The reconstruction of these points (reconstruct_tight_with_labels, if labels are known) is the
  // model; reconstruction() tells how it went. If it fails, the model is empty and cannot be
  // updated. Errors: InputError as reconstruct_tight.
  explicit UpdateSession(Points points, const UpdateOptions& options = {},
                         const Execution& execution = {}, const KnownLabelsSource& known = {});
  // A closed mesh as it is. Its points are triangulated by the first update.
  explicit UpdateSession(TriangleMesh model, const UpdateOptions& options = {});
  // Goes on from a snapshot of a session with the same options.reconstruct. Errors: as
  // check_snapshot.
  explicit UpdateSession(SessionSnapshot snapshot, const UpdateOptions& options = {},
                         SnapshotCheck check = SnapshotCheck::to_be_done,
                         const Execution& execution = {});
  // Stays where it is: the index refers to the model.
  UpdateSession(UpdateSession&&) = delete;
  UpdateSession& operator=(UpdateSession&&) = delete;

  const TriangleMesh& model() const { return model_; }
  // The current points, in the order of the user.
  Points points() const { return points_are_vertices_ ? Points(model_.points.raw()) : points_; }
  const UpdateOptions& options() const { return options_; }
  // Of the current model, without its mesh; empty of a mesh or a snapshot that was given.
  // Complexity: O(n).
  ReconstructResult reconstruction() const;

  // Updates the model by clouds registered to it (update_model.h). Unless the status is ok, and if
  // it throws, the model stays as it is. Errors: as update_model.
  SessionUpdate apply(std::span<const std::vector<Point>> clouds, const Execution& execution = {});
  // With regions that go or stay whatever their angles, in this update alone.
  SessionUpdate apply(std::span<const std::vector<Point>> clouds, const RegionOverrides& overrides,
                      const Execution& execution = {});

  std::size_t undo_levels() const { return history_.size(); }
  // Keeps no more than so many from now on (max_undo_levels): 0 for those who never go back.
  void limit_undo(std::size_t levels);
  // Takes the last update back: the model is the one from before, in all its bits. Returns what
  // that changed. Errors: InputError if undo_levels() is 0; Cancelled, and then nothing was undone.
  MeshChange undo(const Execution& execution = {});

  // Updates and undos whose surface was looked at only where points changed
  // (cocone/kept/certified_surface.h); the others ran the stages over the whole triangulation.
  std::size_t local_changes() const { return surface_.local_changes(); }

  // Complexity: O(n).
  SessionSnapshot snapshot() const;
  // The same of the arrays that are there; the session has no model then.
  SessionSnapshot release() &&;

  // Updates that can be taken back; each holds what went and came, or a copy of the model if its
  // surface was neither certain nor smooth.
  static constexpr std::size_t max_undo_levels = 16;

 private:
  // A model with its points.
  struct Body {
    TriangleMesh model;
    std::vector<Point> points;
    bool points_are_vertices = false;
    bool is_surface = false;  // see model_is_surface_
    IdVector<VertexId, PointId> point_of_vertex;
    IdVector<VertexId, VertexId> next_vertex;  // of the model, in the one after it
    std::vector<PointId> position_after;       // of each point, among those after
    bool distinct_points = false;              // see ModelIndex
  };
  // What it takes to go back to the model before an update.
  struct Step {
    ReconstructResult reconstruction;
    std::variant<Body, MeshEdit> way;  // the model, or the edit that made the next one of it
  };
  // What the update under way has done to surface_.
  struct Pending {
    bool done = false;
    std::optional<ListEdit<PointId>> points;                 // as edit() was told
    std::optional<DynamicTightCocone::SurfaceEdit> surface;  // and what it found
    std::vector<PointId> position_after;                     // if edit() was not asked
  };

  // Whether the model is known to be a smooth mesh, and its points those of the surface.
  bool is_smooth() const {
    return model_is_surface_ && points_are_vertices_ && surface_.is_smooth();
  }
  const ModelIndex& index(const Execution& execution);
  void take_points_of_model();
  PointId point_of_vertex(VertexId v) const {
    return points_are_vertices_ ? PointId(v.value) : point_of_vertex_[v];
  }
  IdVector<VertexId, PointId> points_of_vertices() const;
  ReconstructResult reconstruct(const Replacement& replacement, const OldSurface& old,
                                const Execution& execution, Pending& pending);
  std::size_t num_triangles(const ReconstructResult& result, const Pending& pending) const;
  std::optional<ListEdit<PointId>> edit_of_points(const Replacement& replacement) const;
  std::vector<PointId> old_positions(const Replacement& replacement) const;
  std::vector<PointId> positions_after(const Replacement& replacement) const;
  void take_back(const Pending& pending);
  void keep(SessionUpdate& update, Pending pending);
  void keep_edit(SessionUpdate& update, Pending pending);
  void keep_body(SessionUpdate& update, std::vector<PointId> positions_after);
  void push(ReconstructResult after, std::variant<Body, MeshEdit> way);
  void forget_points_of_vertices();
  MeshChange carry_out(const MeshEdit& edit, std::vector<Point> points,
                       IdVector<VertexId, VertexId> vertex_map);
  MeshChange undo_edit(const MeshEdit& edit, const Execution& execution);
  MeshChange undo_to(Body& before, const Execution& execution);

  UpdateOptions options_;
  TriangleMesh model_;
  bool model_is_surface_ = false;     // it is the mesh of surface_, and not one that was given
  bool points_are_vertices_ = false;  // point i is vertex i of the model, and there are no others
  std::vector<Point> points_;         // if not
  IdVector<VertexId, PointId> point_of_vertex_;  // if not
  ReconstructResult reconstruction_;  // nothing by vertex if that can be asked of surface_
  DynamicTightCocone surface_;
  std::optional<ModelIndex> index_;
  std::size_t most_undo_levels_ = max_undo_levels;
  std::deque<Step> history_;  // the latest last
};

}  // namespace cocoon
