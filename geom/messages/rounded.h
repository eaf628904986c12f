// Numbers in messages.
#pragma once

#include <string>

namespace cocoon {

// The value in as many significant digits, without zeros at the end, as printf's %g in the C
// locale: "0.3", "12.35", "1.5e-07". Precondition: 1 to 17 digits. O(1).
std::string rounded(double value, int digits = 4);

}  // namespace cocoon
