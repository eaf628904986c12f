#include "update/checks/unexplained_handles.h"

#include <algorithm>

namespace cocoon {

std::size_t unexplained_handles(std::span<const SewnPatch> patches, std::size_t empty_loops,
                                std::ptrdiff_t before, std::ptrdiff_t after) {
  std::size_t parts = empty_loops;
  std::size_t loops = 0;
  std::size_t sewn_in = 0;  // in their place
  for (const SewnPatch& patch : patches) {
    if (patch.rims == 0) continue;
    ++sewn_in;
    loops += patch.rims;
    parts += std::min(patch.parts, patch.rims);
  }
  const std::ptrdiff_t handles = (before - after) / 2;
  parts = std::min(parts, loops);
  const auto explained = static_cast<std::ptrdiff_t>(parts - std::min(parts, sewn_in));
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(handles - explained, 0));
}

}  // namespace cocoon
