// Which samples lie where the cloud is too sparse for its features, or ends: the Boundary stage.
//
// An interior ("flat") sample sees a disk: its Voronoi cell is long along the normal and thin
// across, and its normal agrees with those of its neighbors.
//
//   ratio condition of p:    r_p <= rho h_p
//   normal condition of p:   for all q with p in N_q the lines of n_p and n_q meet at <= alpha
//   cocone neighbors:        N_q = { p : V_p meets C_q }
//
// p is in N_q iff some facet that contains p and q has a dual edge that meets C_q: the polygon
// that the cells share meets the cocone iff one of its edges does.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/cocone_radii.h"
#include "cocone/cocones.h"
#include "cocone/facet_set.h"
#include "cocone/poles.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"

namespace cocoon {

struct BoundaryOptions {
  // Ratio condition. The test is relative to the local feature size, not to the spacing: a gap of
  // radius g is found roughly iff g > rho h. Closed models: 1 / 1.2. Open clouds: 0.13 to 0.3.
  double rho = 1 / 1.2;
  // Normal condition: cosine of alpha, here pi / 6.
  double alpha_cosine = 0.86602540378443865;
  // Closed models: tangent_plane (far fewer false boundary samples on thin and noisy data).
  // Open clouds: cocone (cleaner rims).
  RadiusMode radius_mode = RadiusMode::tangent_plane;
};

// What the conditions say of a sample.
enum class SampleState : std::uint8_t {
  ratio_fails,  // boundary for good
  pending,      // only the normal condition fails: phase 2 may still take it in
  interior,
};

struct BoundarySamples {
  VertexSet boundary;            // 1 = boundary sample, 0 = interior
  std::size_t count = 0;         // boundary samples
  std::size_t ratio_failed = 0;  // samples whose ratio condition fails (degenerate ones included)
  std::size_t recovered = 0;     // interior by phase 2
  std::size_t interior() const { return boundary.size() - count; }
};

// Phase 1: interior are the samples that meet both conditions. Phase 2: any sample that meets the
// ratio condition joins when it is a cocone neighbor of an interior sample whose normal agrees;
// until nothing changes. The result is a least fixed point, so the order of work does not matter.
// Degenerate samples (poles.h) never join. If nothing is interior, no surface can be built from
// these samples: interior() == 0.
// Complexity: O(vertices + facets of `cocones`), and k log k for k facets at samples that fail the
// normal condition; phase 1 parallel over facets.
// Source: Dey & Giesen 2001 (Boundary); Woo & Dey 2005, section 3.2.
BoundarySamples boundary_samples(const Triangulation& triangulation, const Dual& dual,
                                 const Poles& poles, const Cocones& cocones,
                                 const BoundaryOptions& options = {},
                                 const Execution& execution = {});

// Phase 1 alone. A function of the stars of each sample and its neighbors.
// Complexity: O(vertices + facets of `cocones`), parallel over facets.
IdVector<VertexId, SampleState> judge_samples(const Triangulation& triangulation, const Dual& dual,
                                              const Poles& poles, const Cocones& cocones,
                                              const BoundaryOptions& options = {},
                                              const Execution& execution = {});

// 1 = a pending sample that an interior one takes in: the first step of phase 2, which later steps
// only add to. Complexity: O(facets of `cocones`).
VertexSet taken_in_at_once(const Triangulation& triangulation, const Poles& poles,
                           const Cocones& cocones, const IdVector<VertexId, SampleState>& states,
                           const BoundaryOptions& options = {});

}  // namespace cocoon
