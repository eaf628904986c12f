#include "update/model/require_ascending.h"

#include <algorithm>
#include <functional>
#include <string>

#include "geom/errors.h"
#include "geom/messages/require_size.h"

namespace cocoon {

void require_ascending(const char* stage, const char* what, std::span<const VertexId> vertices,
                       std::size_t count) {
  if (std::adjacent_find(vertices.begin(), vertices.end(), std::greater_equal<>()) !=
      vertices.end()) {
    throw InputError(std::string(stage) + ": " + what + " must be ascending, each of them once");
  }
  if (!vertices.empty()) require_index(stage, "vertex", vertices.back().index(), count);
}

}  // namespace cocoon
