#include "geom/mesh/triangle_order.h"

#include <algorithm>

namespace cocoon {
namespace {

// By insertion: of two triangles, which are most groups, without a call.
void sort_few(std::span<Triangle> triangles) {
  for (std::size_t k = 1; k < triangles.size(); ++k) {
    const Triangle t = triangles[k];
    std::size_t to = k;
    for (; to > 0 && precedes(t, triangles[to - 1]); --to) triangles[to] = triangles[to - 1];
    triangles[to] = t;
  }
}

}  // namespace

void sort_groups(std::span<Triangle> triangles, std::span<const std::uint32_t> begins,
                 const Execution& execution) {
  constexpr std::size_t vertices_per_chunk = std::size_t{1} << 14;
  constexpr std::size_t few = 16;
  parallel_chunks(
      execution, begins.size() - 1, vertices_per_chunk, [&](std::size_t first, std::size_t end) {
        for (std::size_t v = first; v < end; ++v) {
          const std::span<Triangle> group = triangles.subspan(begins[v], begins[v + 1] - begins[v]);
          if (group.size() <= few) {
            sort_few(group);
          } else {
            std::sort(group.begin(), group.end(),
                      [](const Triangle& a, const Triangle& b) { return precedes(a, b); });
          }
        }
      });
}

}  // namespace cocoon
