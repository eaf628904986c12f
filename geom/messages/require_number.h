// What an option may be: a number that is none, or of another unit, is a caller's mistake.
#pragma once

#include <initializer_list>

namespace cocoon {

// Throws InputError, one line that names stage and option, unless low <= value <= high. NaN never
// is. Complexity: O(1).
void require_number(const char* stage, const char* option, double value, double low, double high);

struct OptionValue {
  const char* name;
  double value;
};

// The usual kinds: costs, ratios and distances from 0 on, infinity too; parts of a whole from 0 to
// 1; cosines from -1 to 1.
void require_amounts(const char* stage, std::initializer_list<OptionValue> options);
void require_shares(const char* stage, std::initializer_list<OptionValue> options);
void require_cosines(const char* stage, std::initializer_list<OptionValue> options);

}  // namespace cocoon
