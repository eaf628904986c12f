#include "geom/messages/require_number.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "geom/errors.h"

namespace cocoon {

void require_number(const char* stage, const char* option, double value, double low, double high) {
  if (value >= low && value <= high) return;
  std::ostringstream line;
  line << stage << ": the option " << option << " is " << value << "; give a number";
  if (!std::isinf(high)) {
    line << " from " << low << " to " << high;
  } else if (!std::isinf(low)) {
    line << " of at least " << low;
  }
  throw InputError(line.str());
}

void require_amounts(const char* stage, std::initializer_list<OptionValue> options) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [name, value] : options) require_number(stage, name, value, 0, infinity);
}

void require_shares(const char* stage, std::initializer_list<OptionValue> options) {
  for (const auto& [name, value] : options) require_number(stage, name, value, 0, 1);
}

void require_cosines(const char* stage, std::initializer_list<OptionValue> options) {
  for (const auto& [name, value] : options) require_number(stage, name, value, -1, 1);
}

}  // namespace cocoon
