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

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/boundary_options.h"
#include "cocone/cocones.h"
#include "cocone/facet_set.h"
#include "cocone/poles.h"
#include "delaunay/triangulation.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/mesh/halfedges.h"

namespace cocoon {

// What the conditions say of a sample.
enum class SampleState : std::uint8_t {
  ratio_fails,  // boundary for good
  pending,      // only the normal condition fails: phase 2 may still take it in
  interior,
};

// A sample that phase 2 took in, and after how many steps.
struct TakenIn {
  VertexId sample;
  std::uint32_t steps = 0;
};

struct BoundarySamples {
  VertexSet boundary;                      // 1 = boundary sample, 0 = interior
  IdVector<VertexId, SampleState> states;  // after phase 1
  std::vector<TakenIn> taken_in;           // by phase 2
  std::size_t count = 0;                   // boundary samples
  std::size_t ratio_failed = 0;  // samples whose ratio condition fails (degenerate ones included)
  std::size_t recovered = 0;     // interior by phase 2
  std::size_t interior() const { return boundary.size() - count; }
};

// Phase 1: interior are the samples that meet both conditions. Phase 2: any sample that meets the
// ratio condition joins when it is a cocone neighbor of an interior sample whose normal agrees;
// until nothing changes. The result is a least fixed point, so the order of work does not matter.
// Degenerate samples (poles.h) never join. If nothing is interior, no surface can be built from
// these samples: interior() == 0.
// Errors: InputError for parts of another triangulation, by their sizes, and for options out of
// range (inputs/stage_inputs.h).
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

// Do the lines of n_p and n_q meet at alpha at most?
inline bool normals_agree(const Poles& poles, VertexId p, VertexId q,
                          const BoundaryOptions& options) {
  return std::abs(dot(poles.normals[p], poles.normals[q])) >= options.alpha_cosine;
}

// Calls visit(p, q, i) for p in N_q as facet k of `cocones` tells it, these being its corners i and
// i + 1 (modulo 3) in one order or the other; a pair may come up for several facets.
template <class Visit>
void for_each_cocone_neighbor(const Cocones& cocones, std::size_t k, Visit visit) {
  const Triangle& corners = cocones.corners[k];
  for (unsigned met = cocones.met_corners(k); met != 0; met &= met - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(met));
    visit(corners[next_corner(i)], corners[i], i);
    visit(corners[previous_corner(i)], corners[i], previous_corner(i));
  }
}

}  // namespace cocoon
