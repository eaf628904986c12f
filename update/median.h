// The median of a few numbers.
#pragma once

#include <vector>

namespace cocoon {

// The element of rank floor(n / 2) in increasing order; 0 for an empty list. A value of the list
// and not a mean of two, so that it does not depend on how sums are rounded. Complexity: O(n).
double median(std::vector<double> values);

// The element of rank floor(fraction * n), for a fraction in [0, 1].
double quantile(std::vector<double> values, double fraction);

}  // namespace cocoon
