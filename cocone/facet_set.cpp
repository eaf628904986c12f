#include "cocone/facet_set.h"

#include <bit>

namespace cocoon {

std::size_t FacetSet::size() const {
  std::size_t count = 0;
  for (const std::uint8_t flags : bits_) count += static_cast<std::size_t>(std::popcount(flags));
  return count / 2;
}

}  // namespace cocoon
