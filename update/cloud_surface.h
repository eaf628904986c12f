// The open surface of an added cloud, and its rim: Cocone with boundary detection, for a rho that
// shows the rim, without the triangles that bridge slots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"
#include "update/cloud_rim.h"
#include "update/trim_long_edges.h"

namespace cocoon {

struct CloudSurfaceOptions {
  // All but boundary.rho, which the ladder sets.
  ReconstructOptions reconstruct = open_cloud_defaults();
  double start_rho = 0.3;
  // Tried in this order while the surface is closed, and as long as no more than max_stray_share of
  // the samples are boundary samples away from any rim.
  std::vector<double> smaller_rhos = {0.2, 0.13, 0.1};
  // Tried in this order while there is no surface, or while it is noisy: more than max_stray_share
  // of the samples are stray and there are more than max_pin_holes_per_rim pin-holes.
  std::vector<double> larger_rhos = {0.5, 0.83};
  double max_stray_share = 0.03;
  double max_pin_holes_per_rim = 4;
  TrimOptions trim;
  RimOptions rim;
};

enum class CloudStatus {
  ok,
  no_surface,    // no rho gives a surface: too few or too noisy samples
  cloud_closed,  // a surface, but no rim at any rho: nothing to join it to the model by
};

// What one rho gave.
struct RhoTrial {
  double rho = 0;
  std::size_t boundary_samples = 0;
  std::size_t stray_samples = 0;  // boundary samples that are not on the rim
  std::size_t triangles = 0;      // after trimming
  std::size_t trimmed = 0;
  std::size_t loops = 0;
  std::size_t pin_holes = 0;
};

struct CloudSurface {
  CloudStatus status = CloudStatus::ok;
  TriangleMesh mesh;                            // trimmed; only vertices that Cocone used
  IdVector<VertexId, PointId> point_of_vertex;  // first cloud point at each mesh vertex
  IdVector<VertexId, std::uint8_t> boundary_sample;
  CloudRim rim;
  double rho = 0;                // of the result
  std::vector<RhoTrial> trials;  // in the order tried
  std::size_t boundary_samples = 0;
  std::size_t trimmed = 0;     // triangles
  std::size_t duplicates = 0;  // cloud points equal to an earlier one
};

// Reconstructs `cloud` alone. One triangulation and one set of poles and cocones serve all rhos:
// only the labels of samples and what follows from them depend on rho.
// Why a ladder: a rim is found iff the gap beyond it is wider than rho times the local feature
// size; small rhos find rims of gently curved patches, large ones bear noise.
// Errors: InputError as delaunay(). Complexity: O(n log n) expected. Deterministic as
// reconstruct_cocone(). Source: Woo & Dey 2005, section 3.2; ladder and trimming are ours.
CloudSurface cloud_surface(Points cloud, const CloudSurfaceOptions& options = {},
                           const Execution& execution = {});

}  // namespace cocoon
