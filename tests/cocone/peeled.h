// The labels of the peel, for tests of what mends them.
#pragma once

#include <vector>

#include "cocone/clean_up/changing_labels.h"
#include "cocone/peel_cells.h"
#include "tests/cocone/marked.h"

namespace cocoon {

struct Peeled {
  explicit Peeled(const std::vector<Point>& points, const CleanUpOptions& given = {})
      : marked(points),
        marks(peel_cells(marked.s.triangulation, marked.surface, marked.marks)),
        options(given),
        labels(marked.s.triangulation, marks, options, nullptr, {}) {
    labels.find_flaws({});
  }

  Marked marked;
  CellMarks marks;
  CleanUpOptions options;
  ChangingLabels labels;
};

}  // namespace cocoon
