#include "geom/median.h"

#include <algorithm>
#include <cstddef>

namespace cocoon {

double median(std::vector<double> values) { return quantile_in_place(values, 0.5); }

double quantile_in_place(std::span<double> values, double fraction) {
  if (values.empty()) return 0;
  const std::size_t rank = std::min(
      values.size() - 1, static_cast<std::size_t>(fraction * static_cast<double>(values.size())));
  const auto position = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), position, values.end());
  return *position;
}

}  // namespace cocoon
