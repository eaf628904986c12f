#include "geom/require_number.h"

#include <cmath>
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

}  // namespace cocoon
