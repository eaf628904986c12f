// The open surface of an added cloud, and its rim: Cocone with boundary detection, for a rho that
// shows the rim, without the triangles that bridge slots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/literal_boundary.h"
#include "cocone/reconstruct.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"
#include "update/cloud/rim_seams.h"
#include "update/cloud/spacing_range.h"
#include "update/cloud/trim_long_edges.h"
#include "update/cloud_rim.h"
#include "update/scan_rows.h"

namespace cocoon {

// What one trial asks of the samples.
struct RimSearch {
  double rho = 0.3;
  double alpha_cosine = 0.86602540378443865;  // 30 degrees
  RadiusMode radius_mode = RadiusMode::cocone;
};

// Scans from several sides in one cloud, a little out of register, or noise: layers over each other
// are no surface at any rho.
struct LayerOptions {
  // If no trial finds a rim, or the best one has a larger share of seams, the rim is looked for
  // again among few of the samples. 1: only if none finds one.
  double max_seam_share = 0.3;
  // Those that are farther apart than this share of the distance to the eighth neighbor, the
  // median. 0: never.
  double spread = 1.1;
  // Whether it is looked for among few of them in any case; in an update their rims are taken then.
  bool first = false;
  // If an update is refused for its rims, the clouds that lie in layers (CrowdedOptions::
  // min_thickness) are looked at so, with `spread` this many times as large, until it is not
  // refused. From 0.1 to 10.
  std::vector<double> when_refused = {1, 1.5, 2};
};

struct CloudSurfaceOptions {
  // All but the fields of `boundary` that a RimSearch sets. In Mode::paper all trials measure the
  // radius of the cocone.
  ReconstructOptions reconstruct = open_cloud_defaults();
  RimSearch start;
  // Tried in this order while no rim is found: finer eyes for gently curved patches.
  std::vector<RimSearch> finer = {{.rho = 0.2}, {.rho = 0.13}, {.rho = 0.1}};
  // Tried in this order while there is no surface, or more than max_seam_share of the rim edges are
  // seams inside the cloud: patience with sharp edges, thin walls and noise. Too much of it closes
  // holes and dents of the rim with long edges.
  std::vector<RimSearch> coarser = {
      {.rho = 0.5},
      {.rho = 0.83, .alpha_cosine = 0.5, .radius_mode = RadiusMode::tangent_plane},
      {.rho = 1.5, .alpha_cosine = 0.5, .radius_mode = RadiusMode::tangent_plane}};
  double max_seam_share = 0.05;
  // If no trial is good enough: how many seams, as a share of the rim edges, weigh as much as rim
  // edges twice as long as those of the surface.
  double stretch_weight = 0.2;
  RowOptions rows;
  DensityOptions density;
  LayerOptions layers;
  TrimOptions trim;
  RimOptions rim;
  RimSeamOptions seams;
};

enum class CloudStatus {
  ok,
  no_surface,    // no trial gives a surface: too few or too noisy samples
  cloud_closed,  // a surface, but no trial finds a rim, though there may be pin-holes
};

// What one trial gave.
struct RimTrial {
  RimSearch search;
  std::size_t boundary_samples = 0;
  std::size_t triangles = 0;  // after trimming
  std::size_t trimmed = 0;
  std::size_t loops = 0;  // that are rims
  std::size_t seam_loops = 0;
  std::size_t seamed_loops = 0;
  std::size_t pin_holes = 0;
  double seam_share = 0;  // of the rim edges of all loops, lone edges among them
  double stretch = 1;     // median edge of the rim, over that of the surface
};

struct CloudSurface {
  CloudStatus status = CloudStatus::ok;
  TriangleMesh mesh;                            // trimmed; only vertices that Cocone used
  IdVector<VertexId, PointId> point_of_vertex;  // first cloud point at each mesh vertex
  IdVector<VertexId, std::uint8_t> boundary_sample;
  CloudRim rim;
  LiteralBoundary literal;       // of the mesh
  RimSearch search;              // of the trial that was taken
  std::vector<RimTrial> trials;  // in the order tried
  std::size_t boundary_samples = 0;
  std::size_t trimmed = 0;     // triangles
  std::size_t duplicates = 0;  // cloud points equal to an earlier one
  // Different samples in rows, dense places or layers that are not looked at.
  std::size_t set_aside = 0;
  // Found among the samples that LayerOptions leave.
  bool is_layered = false;
  SpacingRange spacing;  // of all, by the surface of the first trial

  // A rim, or pin-holes: these are rims where the model goes on through them (pin_holes.h), as
  // where all around a thin limb was scanned.
  bool has_loops() const {
    return status == CloudStatus::ok ||
           (status == CloudStatus::cloud_closed && !rim.pin_hole_loops.empty());
  }
};

// Reconstructs `cloud` alone, in trials. One triangulation and one set of poles and cocones serve
// all trials on the same samples: only the labels of samples and what follows from them differ.
//  1. A trial is good if it finds a rim and at most max_seam_share of the rim edges are seams. The
//     first good one ends the search.
//  2. `start` comes first. If its surface has neither rim nor more than max_seam_share seams, the
//     finer trials follow, of which only good ones count; else the coarser ones.
//  3. If none is good, the one whose rim is the least doubtful is taken: with the smallest sum of
//     its share of seams and stretch_weight (stretch - 1).
// The samples looked at are all, but for four cases:
//  - They are exactly flat: their surface is that of points just off their plane (off_plane.h), but
//    has the points as they are.
//  - They lie in rows by the first surface: all trials look at those that thin_out_rows() keeps,
//    unless these lie on one line. Rows tear the surface, and spacings would be those along a row.
//  - They are much denser in some places than in others: the search is done a second time with few
//    of them (DensityOptions), and its rim, with its trials, taken if it is better.
//  - After all that there is no rim, or one with too many seams: further trials look at the samples
//    that LayerOptions leave, and the best of all trials is taken.
// Why: a rim is found iff the gap beyond it is wider than rho times the local feature size. Small
// rhos find rims of gently curved patches; large ones bear noise and sharp edges.
// Vertices are numbered along a space-filling curve, so that the surface, rim and all that follows
// from these are functions of the set of samples, not of their order in the cloud.
// Errors: as delaunay(), but a flat cloud is none; InputError for options out of range. Complexity:
// O(n log n) expected. Deterministic for any thread count. Source: Woo & Dey 2005, section 3.2;
// ladder and trimming are ours.
CloudSurface cloud_surface(Points cloud, const CloudSurfaceOptions& options = {},
                           const Execution& execution = {});

// The same with what the other trials gave behind it, from the least to the most doubtful rim: for
// those who know where the rim should be. At least one.
std::vector<CloudSurface> ranked_cloud_surfaces(Points cloud,
                                                const CloudSurfaceOptions& options = {},
                                                const Execution& execution = {});

}  // namespace cocoon
