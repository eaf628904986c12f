// Cells that are one piece of space: the balls around them are nearly the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/energy/ball_cosines.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/id_vector.h"

namespace cocoon {

// What is known of the cluster of a cell.
enum class ClusterSize : std::uint8_t { unknown = 0, small, too_large };

struct CellCluster {
  std::vector<CellId> cells;
  bool too_large = false;  // more than asked for: some cells only, and no slivers
};

// The finite cells on the side of `first` (equal out[c]) that hang together with it by facets
// across which the balls meet at a cosine of at least `deep_cosine` (BallCosines::contact); and
// slivers: cells on that side between samples of the cluster that hang together with the rest of
// the side by the cluster only. A hole of which only the rims are sampled is one cluster, since two
// parallel circles of samples lie on one ball. To hang together is an equivalence, so a cell whose
// cluster is known to be too large ends the search; `known` is told of all but the slivers.
// Precondition: `first` is finite; what is known was found with the same cosine and most_cells.
// `scratch` is zero for every cell, before and after. Complexity: O(k log k) for k cells, at most
// most_cells and those at the facets of the cluster included. Deterministic as a set: a function of
// the point set, the sides and the first cell. Source: ours, docs/stages/clean_up_cells.md.
CellCluster cell_cluster(const Triangulation& triangulation, BallCosines& cosines,
                         const IdVector<CellId, std::uint8_t>& out, CellId first,
                         double deep_cosine, std::size_t most_cells,
                         ZeroedArray<CellId, ClusterSize>& known,
                         ZeroedArray<CellId, std::uint8_t>& scratch);

// Have all of these cells the side of the first one? O(cells).
bool are_on_one_side(const IdVector<CellId, std::uint8_t>& out, std::span<const CellId> cells);

}  // namespace cocoon
