// How a good vertex labels the two halves of its star, from what their cells have been told.
#pragma once

#include <cstddef>

#include "cocone/marking/cell_label.h"

namespace cocoon {

struct LabelCount {
  std::size_t out = 0;
  std::size_t in = 0;

  void add(CellLabel label) {
    out += label == CellLabel::out;
    in += label == CellLabel::in;
  }
  bool mixed() const { return out != 0 && in != 0; }
  // A tie is OUT; unmarked if there are no labels.
  CellLabel majority() const {
    if (out == 0 && in == 0) return CellLabel::unmarked;
    return out >= in ? CellLabel::out : CellLabel::in;
  }
};

struct HalfLabels {
  CellLabel first;
  CellLabel second;
  bool conflict;
};

// A half without labels is on the other side than the one with; the majority counts where they are
// mixed, which is a conflict, and so are two halves on the same side. Without any label the first
// is OUT. O(1). Source: Dey & Goswami 2003 (Tight Cocone, marking); the majority is ours,
// docs/stages/mark_cells.md.
inline HalfLabels label_halves(const LabelCount& first, const LabelCount& second) {
  const auto opposite = [](CellLabel label) {
    return label == CellLabel::out ? CellLabel::in : CellLabel::out;
  };
  CellLabel of_first = first.majority();
  CellLabel of_second = second.majority();
  if (of_first == CellLabel::unmarked) of_first = opposite(of_second);
  if (of_second == CellLabel::unmarked) of_second = opposite(of_first);
  return {of_first, of_second, first.mixed() || second.mixed() || of_first == of_second};
}

}  // namespace cocoon
