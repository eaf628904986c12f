// The watertight surface of a set of points that changes.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "cocone/reconstruct.h"
#include "cocone/surface_state.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// Triangles of an old mesh, see reconstruct_tight_again(). Asked for only where stages that read
// them run. Empty: there are none.
using KnownTriangleSource = std::function<std::vector<KnownTriangle>()>;

// Keeps the Delaunay triangulation of its points from one change to the next. Every result is the
// one that reconstruct_tight_again gives for points and triangles, bit for bit, whatever the
// history, but for counters.delaunay, which tell how the triangulation was changed.
//
// Points of extreme size (working_scale() is not 1) are triangulated anew each time.
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
  // Calls of replace() that looked at the surface only where the points changed; the others ran all
  // stages over the whole triangulation.
  std::size_t local_changes() const;

  // Takes these points, in this order, instead of those so far.
  ReconstructResult reconstruct(Points points, const Execution& execution = {},
                                const KnownTriangleSource& known = {});
  // As reconstruct(points), but goes on from the points so far: old_position[i] is where points[i]
  // was among them, or none if it is new. Points without a successor go.
  // Precondition: equal coordinates at both positions, no position twice.
  // Complexity: the triangulation changes in O(k log n) expected for k points that come or go.
  ReconstructResult replace(Points points, std::span<const PointId> old_position,
                            const Execution& execution = {}, const KnownTriangleSource& known = {});

  // Takes over the snapshot of one with these points and the same options; or a triangulation whose
  // input points they are (delaunay(points)), without looking for its surface.
  // Precondition: check_surface_state finds no fault.
  void take(Points points, Snapshot snapshot);
  // Vertices and cells in the order of memory. Complexity: O(n).
  Snapshot snapshot() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cocoon
