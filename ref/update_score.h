// How good an update is, where the truth is known.
#pragma once

#include <cstddef>
#include <optional>

#include "geom/execution.h"
#include "geom/surface_distance.h"
#include "geom/triangle_mesh.h"
#include "io/sample_models.h"
#include "update/update_model.h"

namespace cocoon::ref {

struct UpdateScore {
  // Vertices of the model: wrong ones should go, all others stay. A vertex is gone if it is no
  // vertex of the updated mesh.
  std::size_t wrong = 0;
  std::size_t gone = 0;
  std::size_t wrong_and_gone = 0;
  std::size_t moved = 0;  // vertices that stayed, with other bits

  bool closed_manifold = false;  // of the updated mesh
  std::optional<std::size_t> genus;
  std::size_t components = 0;
  std::optional<std::size_t> true_genus;
  std::size_t true_components = 0;

  double spacing = 0;        // of the initial model, sqrt(area / vertices)
  SurfaceDistance distance;  // between updated mesh and truth

  double precision() const;  // of what is gone, the share that was wrong; 1 if nothing is gone
  double recall() const;     // of what was wrong, the share that is gone; 1 if nothing was wrong
  bool right_topology() const {
    return closed_manifold && genus == true_genus && components == true_components;
  }
};

// Compares the update of `model` with the truth: `wrong_points` are the coordinates of all vertices
// that had to go (others are ignored), `truth` is the true surface after the change. A result that
// is not ok has an empty mesh: then all is gone, and there is no distance.
// Throws InputError as surface_distance(), and for a result of another model.
// Complexity: O((n + samples) log n). Deterministic.
UpdateScore score_update(const TriangleMesh& model, const UpdateResult& result, Points wrong_points,
                         const TriangleMesh& truth, const SurfaceDistanceOptions& options = {},
                         const Execution& execution = {});

// The same for a model that is a mesh of sample.initial.
UpdateScore score_update(const TriangleMesh& model, const UpdateResult& result,
                         const SampleModel& sample, const SurfaceDistanceOptions& options = {},
                         const Execution& execution = {});

}  // namespace cocoon::ref
