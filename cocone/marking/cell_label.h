// On which side of the surface a cell is.
#pragma once

#include <cstdint>

namespace cocoon {

enum class CellLabel : std::uint8_t { unmarked, out, in };

}  // namespace cocoon
