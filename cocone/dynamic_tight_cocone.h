// The watertight surface of a set of points that changes.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cocone/live/surface_state.h"
#include "cocone/reconstruct.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/list_edit.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Keeps the Delaunay triangulation of its points from one change to the next. Every result is the
// one that reconstruct_tight_with_labels gives for points and known labels, bit for bit, whatever
// the history, but for counters.delaunay, which tell how the triangulation was changed. (A zero in
// a normal may have the other sign if of two equal points one went, and their zeros had two signs.)
//
// Points of extreme size (working_scale() is not 1) are triangulated anew each time. edit() does
// not look whether sizes have become incomparable (working_scale.h); all others refuse such points.
// If an operation throws (InputError as delaunay(), Cancelled), the points are those from before.
class DynamicTightCocone {
 public:
  // All of it as plain data; both are empty if nothing is known.
  struct Snapshot {
    Triangulation triangulation;
    SurfaceState surface;
  };

  explicit DynamicTightCocone(const ReconstructOptions& options = {});
  ~DynamicTightCocone();
  DynamicTightCocone(DynamicTightCocone&&) noexcept;
  DynamicTightCocone& operator=(DynamicTightCocone&&) noexcept;

  const ReconstructOptions& options() const;
  std::size_t num_points() const;
  // Calls of replace() and edit() that looked at the surface only where the points changed; the
  // others ran all stages over the whole triangulation.
  std::size_t local_changes() const;

  // Whether closed surfaces inside the body bound hollows, from the next call on: the only option
  // that may change, since all that is kept is the same with and without it.
  void keep_cavities(bool keep);

  // Takes these points, in this order, instead of those so far.
  ReconstructResult reconstruct(Points points, const Execution& execution = {},
                                const KnownLabelsSource& known = {});
  // As reconstruct(points), but goes on from the points so far: old_position[i] is where points[i]
  // was among them, or none if it is new. Points without a successor go.
  // Errors: InputError unless there is a position for each point, with equal coordinates there.
  // Complexity: the triangulation changes in O(k log n) expected for k points that come or go.
  ReconstructResult replace(Points points, std::span<const PointId> old_position,
                            const Execution& execution = {}, const OldSurface& old = {});

  // What edit() did to a mesh whose vertices are all points, each its own.
  struct SurfaceEdit {
    // The vertices of the mesh before at which triangles may have changed, with those that went;
    // ascending.
    std::vector<VertexId> touched;
    // All triangles of the mesh after at those of them that stayed and at new ones, in canonical
    // order. The other triangles are as before.
    std::vector<Triangle> triangles;
  };
  struct Edited {
    // If there is an edit: without mesh and all that it has of each vertex, see complete().
    ReconstructResult result;
    std::optional<SurfaceEdit> edit;
  };
  // As replace(), for a change that keeps the order of the points that stay. If is_smooth() before
  // and the mesh is smooth after, the result has an edit instead of a mesh. It has a mesh all the
  // same for the first body after a certain surface, after a change of about half of the points,
  // and where a point that went comes back as the vertex it was. Precondition: points that stay are
  // equal before and after. Errors: InputError for a change of lists of other lengths. Complexity:
  // where the surface stays certain, as the change of the triangulation, and a pass over the
  // numbers of the points.
  Edited edit(Points points, const ListEdit<PointId>& change, const Execution& execution = {},
              const OldSurface& old = {});
  // To be called if the caller's mesh is not what the last call found, as where labels were known
  // for it that the call was not told: is_smooth() is false then, unless the surface is certain,
  // which leaves no choice. Of an old surface that is handed over only `labels` is asked the next
  // time.
  void forget_body();
  // Adds what an edit left out, but for the mesh. Precondition: the result is that of the points so
  // far, each a vertex of the mesh. Complexity: O(n).
  void complete(ReconstructResult& result) const;
  // Whether the points so far are known to be the vertices of a smooth mesh, vertex i point i:
  // closed and connected, with one umbrella at each. What edit() goes by.
  bool is_smooth() const;
  // Looks whether it is where that is not known: after replace() has found a surface that is not
  // certain. edit() does so first. Complexity: O(n), parallel; O(1) where it is known.
  void look_if_smooth(const Execution& execution = {});
  // is_smooth() of a certain surface.
  bool is_certain() const;

  // Takes over the snapshot of one with these points and the same options; or a triangulation whose
  // input points they are (delaunay(points)), without looking for its surface.
  // Precondition: check_surface_state finds no fault.
  void take(Points points, Snapshot snapshot);
  // Vertices and cells in the order of memory. Complexity: O(n).
  Snapshot snapshot() const;
  // The same of the arrays that are there; it is empty then.
  Snapshot release() &&;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cocoon
