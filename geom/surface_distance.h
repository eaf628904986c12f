// How far two surfaces are apart, measured by samples: Hausdorff, mean and root mean square.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct SurfaceDistanceOptions {
  std::size_t samples = 100000;  // on each mesh, besides its vertices
  std::uint64_t seed = 1;
  // How far samples may be off to count as within; in units of the coordinates.
  std::optional<double> tolerance = {};
};

// From one surface to the other.
struct DirectedDistance {
  std::size_t samples = 0;  // points that were measured
  double max = 0;   // over samples and vertices: the one-sided Hausdorff distance from below
  double mean = 0;  // over samples spread evenly by area; for a cloud over its points
  double rms = 0;   // likewise
  Point farthest;   // the point at distance max (of several the lexicographically smallest)
  // The share of the samples of `mean` that are at most the tolerance away; 0 if there is none.
  double within = 0;

  friend bool operator==(const DirectedDistance&, const DirectedDistance&) = default;
};

struct SurfaceDistance {
  DirectedDistance a_to_b;
  DirectedDistance b_to_a;
  double max = 0;   // the larger of both
  double mean = 0;  // the mean of both
  double rms = 0;   // root of the mean of both squares
  // Harmonic mean of both shares within the tolerance, precision and recall if b is the truth.
  double f_score = 0;

  friend bool operator==(const SurfaceDistance&, const SurfaceDistance&) = default;
};

// Measures both directions between a and b. A mesh without triangles is a cloud: all its points are
// measured and measured to. Of a mesh with triangles the corners of triangles are measured for the
// maximum, and `samples` points for all figures: the area is cut into that many equal pieces in
// the order of triangles, with one random point in each (stratified).
// Coordinates may have any size, and differ in it: figures are relative to that of the larger mesh.
// Throws InputError for a tolerance that is not a number from 0 on, for a side without points, with
// a coordinate that is not finite, with a triangle that names a vertex that is not there, or whose
// triangles have no area while samples are wanted.
// Reports progress as "surface_distance". Complexity: O((samples + v) log t). Deterministic: one
// random number generator for each sample, sums in a fixed order: the same for every number of
// threads. Source: Cignoni, Rocchini & Scopigno, Metro: measuring error on simplified surfaces (CGF
// 1998); F-score: Knapitsch, Park, Zhou & Koltun, Tanks and temples (ACM TOG 36, 2017).
SurfaceDistance surface_distance(const TriangleMesh& a, const TriangleMesh& b,
                                 const SurfaceDistanceOptions& options = {},
                                 const Execution& execution = {});

}  // namespace cocoon
