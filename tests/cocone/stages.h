// The first stages run on a point set, for tests that look between them.
#pragma once

#include <utility>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/candidate_triangles.h"
#include "cocone/cocones.h"
#include "cocone/extract_manifold.h"
#include "cocone/poles.h"
#include "cocone/prune_sharp_edges.h"
#include "delaunay/delaunay.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {

struct Stages {
  explicit Stages(Triangulation of_points)
      : triangulation(std::move(of_points)),
        dual(voronoi_dual(triangulation)),
        stars(vertex_stars(triangulation)),
        poles(compute_poles(triangulation, dual)),
        cocones(intersect_cocones(triangulation, dual, poles)) {}
  explicit Stages(const std::vector<Point>& points) : Stages(delaunay(points).triangulation) {}

  BoundarySamples labels(const BoundaryOptions& options = {}) const {
    return boundary_samples(triangulation, dual, poles, cocones, options);
  }

  // The Cocone surface of samples with these labels.
  LinkedFacets surface(const BoundarySamples& labels_of_samples) const {
    PrunedCandidates pruned = prune_sharp_edges(
        triangulation, candidate_triangles(triangulation, cocones, labels_of_samples.boundary));
    return extract_manifold(triangulation, std::move(pruned.left), pruned.umbrella).triangles;
  }

  Triangulation triangulation;
  Dual dual;
  VertexStars stars;
  Poles poles;
  Cocones cocones;
};

}  // namespace cocoon
