#include "cocone/live/judge_points.h"

#include "cocone/boundary_samples.h"
#include "cocone/cocones.h"
#include "cocone/poles.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {

void judge_points(const Triangulation& triangulation, const ReconstructOptions& options,
                  ReconstructResult& result) {
  const ReconstructOptions effective = effective_options(options);
  const Dual dual = voronoi_dual(triangulation);
  const Poles poles = compute_poles(triangulation, dual);
  const Cocones cocones = intersect_cocones(triangulation, dual, poles, effective.cocone);
  const VertexSet boundary =
      boundary_samples(triangulation, dual, poles, cocones, effective.boundary).boundary;
  for (const VertexId v : triangulation.vertex_of_point()) {
    result.normals.push_back(poles.normals[v]);
    result.boundary_sample.push_back(boundary[v]);
  }
}

}  // namespace cocoon
