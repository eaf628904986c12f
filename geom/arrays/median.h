// The median of a few numbers.
#pragma once

#include <span>
#include <vector>

namespace cocoon {

// The element of rank floor(n / 2) in increasing order; 0 for an empty list. A value of the list
// and not a mean of two, so that it does not depend on how sums are rounded. Complexity: O(n).
double median(std::vector<double> values);

// The element of rank floor(fraction * n), or the last one, for a fraction in [0, 1]; may change
// the order of the values. Complexity: O(n) expected.
double quantile_in_place(std::span<double> values, double fraction);

}  // namespace cocoon
