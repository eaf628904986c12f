// A model that is updated again and again: what one update computed is there for the next.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "cocone/dynamic_tight_cocone.h"
#include "cocone/surface_state.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"
#include "update/mesh_change.h"
#include "update/model_index.h"
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
  UpdateResult result;  // without its mesh, which is the session's model()
  MeshChange change;    // empty unless result.status is ok
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
// counts, apart from those of the Delaunay kernel.
class UpdateSession {
 public:
  // The reconstruction of these points is the model; reconstruction() tells how it went. If it
  // fails, the model is empty and cannot be updated. Errors: InputError as reconstruct_tight.
  explicit UpdateSession(Points points, const UpdateOptions& options = {},
                         const Execution& execution = {});
  // A closed mesh as it is. Its points are triangulated by the first update.
  explicit UpdateSession(TriangleMesh model, const UpdateOptions& options = {});
  // Goes on from a snapshot of a session with the same options.reconstruct. Errors: as
  // check_snapshot.
  explicit UpdateSession(SessionSnapshot snapshot, const UpdateOptions& options = {},
                         SnapshotCheck check = SnapshotCheck::to_be_done);
  // Stays where it is: the index refers to the model.
  UpdateSession(UpdateSession&&) = delete;
  UpdateSession& operator=(UpdateSession&&) = delete;

  const TriangleMesh& model() const { return model_; }
  const UpdateOptions& options() const { return options_; }
  // Of the current model, without its mesh; of a mesh that was given, empty.
  const ReconstructResult& reconstruction() const { return reconstruction_; }

  // Updates the model by clouds registered to it (update_model.h). Unless the status is ok, and if
  // it throws, the model stays as it is. Errors: as update_model.
  SessionUpdate apply(std::span<const std::vector<Point>> clouds, const Execution& execution = {});

  std::size_t undo_levels() const { return history_.size(); }
  // Takes the last update back: the model is the one from before, in all its bits. Returns what
  // that changed. Precondition: undo_levels() > 0. Throws Cancelled; then nothing was undone.
  MeshChange undo(const Execution& execution = {});

  // Updates and undos whose surface was looked at only where points changed
  // (cocone/certified_surface.h); the others ran the stages over the whole triangulation.
  std::size_t local_changes() const { return surface_.local_changes(); }

  // Complexity: O(n).
  SessionSnapshot snapshot() const;

  // Updates that can be taken back; each holds a copy of the model.
  static constexpr std::size_t max_undo_levels = 16;

 private:
  // A model with its points.
  struct Body {
    TriangleMesh model;
    std::vector<Point> points;
    IdVector<VertexId, PointId> point_of_vertex;
    ReconstructResult reconstruction;
    IdVector<VertexId, VertexId> next_vertex;  // of the model, in the one after it
    std::vector<PointId> position_after;       // of each point, among those after
    bool distinct_points = false;              // see ModelIndex
  };

  void take_points_of_model();
  ReconstructResult reconstruct(const Replacement& replacement, const KnownTriangleSource& known,
                                const Execution& execution);
  std::vector<PointId> old_positions(const Replacement& replacement) const;
  std::vector<PointId> positions_after(const Replacement& replacement) const;
  void keep(SessionUpdate& update, std::vector<PointId> positions_after);

  UpdateOptions options_;
  TriangleMesh model_;
  std::vector<Point> points_;
  IdVector<VertexId, PointId> point_of_vertex_;
  ReconstructResult reconstruction_;
  DynamicTightCocone surface_;
  std::optional<ModelIndex> index_;
  std::deque<Body> history_;  // the latest last
};

}  // namespace cocoon
