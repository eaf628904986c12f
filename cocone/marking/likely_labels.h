// Labels of cells that are likely, and not known: whether a surface heeds them already.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/known_labels.h"
#include "cocone/marking/cell_label.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// Those that are not unmarked. Complexity: O(cells).
std::size_t count_labels(const IdVector<CellId, CellLabel>& labels);

// Cells with the other label; `out`: 1 for cells outside. Errors: InputError unless there are as
// many of both. Complexity: O(cells).
std::size_t count_contradicted(const IdVector<CellId, CellLabel>& labels,
                               const IdVector<CellId, std::uint8_t>& out);

// The known labels, and the likely ones where nothing is known. Complexity: O(cells).
IdVector<CellId, CellLabel> with_likely(KnownLabels known);

}  // namespace cocoon
