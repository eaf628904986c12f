// A cut of the model, moved to where samples do not speak against what it passes.
#pragma once

#include <span>

#include "update/cloud/scan.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"
#include "update/regions/facet_cut.h"
#include "update/regions/unconfirmed_facets.h"

namespace cocoon {

struct MovedCutOptions {
  // So many spacings of the scan the cut may move, the largest of several. 0: it stays.
  double reach = 5;
  // So many times as much as another edge costs one at an unconfirmed facet.
  double unconfirmed_cost = 3;
  UnconfirmedOptions unconfirmed = {};
};

// The labels of a facet_cut() of these pulls (1: the source side) as they are if facets near the
// cut are labeled anew, at these costs, while all others keep their labels. Why: where the new
// surface leaves the old one along a sharp edge, samples beyond it may be no part of the cloud's
// surface, so the rim runs on the edge or is missing there. The shortest cut leaves pieces of the
// old surface then. Where samples lie on the model, old and new surface are the same on both sides
// of the cut, so it does not matter where it runs; among samples that lie beside it, it does. That
// the others keep their labels matters: with such costs for all of the cut a rim that tells little
// would be outvoted. (Near the cut any facet that pulls may be: it may be there that a rim is
// wrong.)
// Errors: InputError for options out of range, and for labels of another model, by their size.
// Complexity: O(facets of the model) for flags, and what unconfirmed_facets() and facet_cut() take
// for the facets near the cut. Deterministic. Source: ours, docs/departures.md, departure 35.
TriangleSet moved_cut(const ModelIndex& model, const TriangleSet& border,
                      std::span<const FacetPull> pulls, double steps_per_unit, TriangleSet source,
                      std::span<const Scan> scans, const MovedCutOptions& options = {});

}  // namespace cocoon
