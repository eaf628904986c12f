// Labels that pass from cell to cell.
#pragma once

#include <algorithm>
#include <vector>

#include "delaunay/triangulation.h"

namespace cocoon {

// Asks the cells that are `left` until none of them has take_label(cell) true, to and fro in their
// order; those that have are left no longer. Complexity: O(left) for each time that labels change
// their direction.
template <class TakeLabel>
void pass_labels(std::vector<CellId>& left, const TakeLabel& take_label) {
  for (std::size_t before = left.size() + 1; left.size() < before;) {
    before = left.size();
    std::reverse(left.begin(), left.end());
    std::erase_if(left, take_label);
  }
}

}  // namespace cocoon
