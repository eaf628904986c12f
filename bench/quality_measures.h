// How good a surface is, beside the one that was sampled.
#pragma once

#include <cstddef>

#include "bench/quality_models.h"
#include "geom/triangle_mesh.h"

namespace cocoon::bench {

struct Quality {
  bool closed = false;    // every edge has an even number of triangles
  bool manifold = false;  // no edge with more than two, no pinched vertex
  std::ptrdiff_t extra_components = 0;
  // Genus = components - half of Euler characteristic and boundary curves, that rounded down.
  std::ptrdiff_t extra_genus = 0;
  double mean = 0;  // distances in units of the model's spacing, both directions
  double rms = 0;
  double max = 0;
  double normal_deg = 0;  // mean angle to the normal of the closest true facet, over the area
  std::size_t triangles = 0;
  std::size_t unused = 0;  // points without a triangle
};

// Measures `mesh`, made from model.points. Empty meshes: all zero, every point unused.
// Complexity: O(n log n).
Quality quality_of(const TriangleMesh& mesh, const QualityModel& model);

}  // namespace cocoon::bench
