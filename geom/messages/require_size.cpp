#include "geom/messages/require_size.h"

#include <string>

#include "geom/errors.h"

namespace cocoon {

void require_size(const char* stage, const char* what, std::size_t size, std::size_t wanted) {
  if (size == wanted) return;
  throw InputError(std::string(stage) + ": " + std::to_string(size) + " " + what +
                   " given where there must be " + std::to_string(wanted) +
                   "; give what belongs to the same input");
}

void refuse_index(const char* stage, const char* what, std::size_t index, std::size_t count) {
  throw InputError(std::string(stage) + ": there is no " + what + " " + std::to_string(index) +
                   " among " + std::to_string(count) +
                   " (from 0 on); give what belongs to the same input");
}

}  // namespace cocoon
