// Rims with pieces missing, for the tests of the cut.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tests/update/hand_made_models.h"
#include "update/cut_regions.h"
#include "update/overlapping_facets.h"

namespace cocoon::testing {

inline const Point middle = {15.1, 15.2, 0};
constexpr double radius = 6;

// A circle of 60 edges, of which those from `first` up to `last` have cloud beyond them.
inline CloudRim torn_rim(std::size_t first, std::size_t last) {
  CloudRim rim = rim_of({circle(60, middle, radius)});
  rim.median_edge = rim.spacing;
  RimLoop& loop = rim.loops[0];
  loop.inner.assign(loop.size(), 0);
  for (std::size_t i = first; i < last; ++i) loop.inner[i] = 1;
  rim.rim_edges = loop.size();
  rim.seam_edges = last - first;
  return rim;
}

// The same loops, with the cloud on the other side.
inline CloudRim inside_out(CloudRim rim) {
  for (RimLoop& loop : rim.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      loop.apexes[i] = loop.middle(i) + (loop.middle(i) - loop.apexes[i]);
    }
  }
  return rim;
}

// A mesh, and a rim that lies on it.
struct RimOnAMesh {
  RimOnAMesh(TriangleMesh a_mesh, CloudRim a_rim)
      : mesh(std::move(a_mesh)),
        model(mesh),
        rim(std::move(a_rim)),
        border(trace_border(model, rim, overlapping_facets(model, rim))) {}
  RegionCut cut(const CutOptions& options = {}) const {
    return cut_under_cloud(model, certain(options), std::span(&rim, 1), scans, options);
  }
  TriangleSet certain(const CutOptions& options = {}) const {
    TriangleSet facets(mesh.triangles.size(), 0);
    certain_border(model, rim, border.loops, options, facets);
    return facets;
  }
  double radius_of(TriangleId t) const { return distance(model.centroid(t), middle); }

  TriangleMesh mesh;
  ModelIndex model;
  CloudRim rim;
  Border border;
  std::vector<Scan> scans;
};

}  // namespace cocoon::testing
