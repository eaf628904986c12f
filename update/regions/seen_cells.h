// The cells through which samples saw what they disprove of the model.
#pragma once

#include <span>

#include "cocone/known_labels.h"
#include "delaunay/triangulation.h"
#include "geom/point.h"

namespace cocoon {

struct SightOptions {
  // In spacings of the scan: how far from the sample cells begin to be labeled, since beside it the
  // surface may be on either side,
  double clearance = 1;
  // and how far places on the line are apart. 0: nothing is said to have been seen.
  double step = 0.25;
};

// A line of sight that met no surface: there is nothing but air, or body, along it.
struct Sight {
  Point from;  // the sample
  Point to;
  bool is_air = false;
  double spacing = 0;  // of its scan
};

// Labels the finite cells around places on the lines (KnownLabels::likely), beside what is known;
// not those that are told both. `sights`: in the coordinates of the triangulation. Why: walls that
// nobody scanned leave the side of what lies between undecided; a boss whose top alone was seen
// floats above the model, or is held by a thread. Errors: InputError for options out of range.
// Complexity: O(cells), and a short walk for each place. Deterministic: independent of the order of
// the lines. Source: ours, docs/departures.md, departure 24.
void add_seen_cells(const Triangulation& triangulation, std::span<const Sight> sights,
                    const SightOptions& options, KnownLabels& known);

}  // namespace cocoon
