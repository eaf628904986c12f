// What an option may be: a number that is none, or of another unit, is a caller's mistake.
#pragma once

namespace cocoon {

// Throws InputError, one line that names stage and option, unless low <= value <= high. NaN never
// is. Complexity: O(1).
void require_number(const char* stage, const char* option, double value, double low, double high);

}  // namespace cocoon
