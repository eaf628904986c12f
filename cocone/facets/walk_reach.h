// What a walk over candidates keeps and drops (extract_manifold.h), without its rounds.
//
// Let K be all halves that follow from the first one: over edges with two candidates, and by turns
// about others to the candidate met first. Let D be the candidates that these turns meet later. The
// rounds of the walk, which keep what they have kept and dropped, are there for what contradicts
// itself: a candidate in K from both sides, or in K and in D. If there is none, then each round
// keeps halves in K and drops candidates in D, and no turn meets one first that has been dropped:
// by induction the walk ends with all of K and D, whatever the order. K is found by what hangs
// together over edges with two candidates (geom/mesh/edge_components.h), on all threads and in the
// order of memory; turns lead from one of these parts to the next. Source: ours.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cocone/facets/half_facets.h"
#include "cocone/facets/linked_facets.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// What a walk has made of a candidate.
namespace walk_state {
constexpr std::uint8_t open = 0;
constexpr std::uint8_t kept[2] = {1, 2};  // half 2 t, half 2 t + 1
constexpr std::uint8_t dropped = 4;
constexpr std::uint8_t proposed[2] = {8, 16};  // during a round
}  // namespace walk_state

// The states of all candidates after a walk from this half, the first walk of all; nothing if only
// its rounds can tell. Complexity: O(candidates), parallel but for O(edges with more than two).
std::optional<std::vector<std::uint8_t>> walk_reach(const Triangulation& triangulation,
                                                    const LinkedFacets& candidates,
                                                    const VertexSet& umbrella, Half start,
                                                    const Execution& execution = {});

}  // namespace cocoon
