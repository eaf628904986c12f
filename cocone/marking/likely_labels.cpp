#include "cocone/marking/likely_labels.h"

#include <algorithm>
#include <utility>

#include "geom/messages/require_size.h"

namespace cocoon {

std::size_t count_labels(const IdVector<CellId, CellLabel>& labels) {
  return labels.size() -
         static_cast<std::size_t>(std::count(labels.begin(), labels.end(), CellLabel::unmarked));
}

std::size_t count_contradicted(const IdVector<CellId, CellLabel>& labels,
                               const IdVector<CellId, std::uint8_t>& out) {
  require_size("count_contradicted", "labels of cells", labels.size(), out.size());
  std::size_t count = 0;
  for (const CellId c : labels.ids()) {
    if (labels[c] == CellLabel::unmarked) continue;
    count += (labels[c] == CellLabel::out) != (out[c] != 0) ? 1U : 0U;
  }
  return count;
}

IdVector<CellId, CellLabel> with_likely(KnownLabels known) {
  if (known.labels.empty()) return std::move(known.likely);
  for (const CellId c : known.likely.ids()) {
    if (known.labels[c] == CellLabel::unmarked) known.labels[c] = known.likely[c];
  }
  return std::move(known.labels);
}

}  // namespace cocoon
