#include "update/checks/unexplained_handles.h"

#include <algorithm>

namespace cocoon {

namespace {

std::size_t loops_on_model(const CloudReport& cloud) {
  const auto found = std::count_if(
      cloud.loops.begin(), cloud.loops.end(),
      [](const LoopReport& loop) { return loop.match == LoopMatch::on_model && !loop.pin_hole; });
  return static_cast<std::size_t>(found);
}

}  // namespace

std::size_t unexplained_handles(std::span<const CloudReport> clouds, std::size_t empty_loops,
                                std::ptrdiff_t before, std::ptrdiff_t after) {
  std::size_t parts = empty_loops;
  std::size_t loops = 0;
  std::size_t patches = 0;  // in their place
  for (const CloudReport& cloud : clouds) {
    const std::size_t of_cloud = loops_on_model(cloud);
    if (of_cloud == 0) continue;
    ++patches;
    loops += of_cloud;
    parts += std::min(cloud.replaced_groups.size(), of_cloud);
  }
  const std::ptrdiff_t handles = (before - after) / 2;
  parts = std::min(parts, loops);
  const auto explained = static_cast<std::ptrdiff_t>(parts - std::min(parts, patches));
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(handles - explained, 0));
}

}  // namespace cocoon
