// Where the marks of a surface contradict each other, it is looked for once more among fewer
// samples.
//
// The radius of the tangent plane takes more samples for good than that of the cocone
// (RadiusMode), and most surfaces are the better for it. But where a wall is thinner than the
// spacing its two sides take each other's samples for neighbors, are good all the same, and
// disagree about what is inside. With the cocone's radius they are boundary samples, and the
// clean-up decides. So both surfaces are marked, and the one whose marks contradict each other less
// often is closed; the first, if nothing comes of the second.
// Marks that a foreign mesh has told (KnownLabels::is_foreign) may be made again while
// the surface is closed (close_body.h): there both are closed, however many cells are poor, and the
// second is taken if it contradicts itself less often and costs less.
//
// Source: ours, docs/stages/second_look.md.
#pragma once

#include <cstddef>

#include "cocone/checks/surface_roughness.h"
#include "cocone/clean_up_cells.h"

namespace cocoon {

struct SecondLookOptions {
  bool enabled = true;  // false, as without clean-up: what is found first is taken
  // There is one if marks contradict each other (CellMarks::conflicts) more often than this,
  std::size_t max_conflicts = 5;
  // and more often than this share of the samples: noise contradicts itself here and there.
  double max_conflict_share = 0.001;
  // But not if there are more poor cells (CellMarks::poor_cells) than this many per sample: where
  // so much is left to the clean-up anyway, it is noise or what was not scanned, and a stricter
  // condition leaves too little.
  double max_poor_per_sample = 1.25;
};

// Of peeled marks.
struct Contradictions {
  std::size_t conflicts = 0;
  std::size_t poor_cells = 0;
  std::size_t samples = 0;
};

// Whether there is a second look at what has such marks. Complexity: O(1).
bool calls_for_second_look(const SecondLookOptions& options, const Contradictions& found);

// What the clean-up makes parts, handles and samples without a place cost. Complexity: O(1).
double cost_of(const SurfaceRoughness& roughness, const CleanUpOptions& costs);

}  // namespace cocoon
