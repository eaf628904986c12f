// The local update by the paper, with CGAL for triangulations and nearest facets: the rival of
// `./dev bench paper`. Shares no code with the stages.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon::ref {

struct CgalUpdate {
  // Processor time of the columns of the paper's Table 1: boundary detection, overlapping facets,
  // segmentation and selection, final reconstruction. Triangulations are freed within, results not.
  std::array<double, 4> seconds = {};
  double cloud_delaunay_seconds = 0;  // within boundary detection
  double model_delaunay_seconds = 0;  // within the reconstruction
  std::size_t rim_points = 0;
  std::vector<TriangleId> overlapping_facets;  // ascending, as are
  std::vector<VertexId> replaced;              // vertices of the model
  std::size_t regions = 0;
  TriangleMesh mesh;  // the updated surface; points on no triangle are among its points
};

// One thread, plain arrays by facet and vertex, no indexes but CGAL's triangulation and AABB tree:
// Cocone surface of each cloud, its longest loop, the closest facet of each rim point, gaps closed
// by searches over neighboring facets, regions grown over edges, the region at the smaller angle
// replaced, Tight Cocone of what is left and the clouds. Does less than update_model(): one trial
// for each rim, no seams, no trimming, no clean-up, no reports. Precondition: points of the model
// and of each cloud are all different; the model is an oriented manifold.
// Source: Woo & Dey 2005, section 3.
CgalUpdate cgal_update(const TriangleMesh& model, const std::vector<std::vector<Point>>& clouds);

}  // namespace cocoon::ref
