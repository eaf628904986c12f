#include "cocone/clean_up/small_parts.h"

#include <algorithm>

#include "cocone/facets/cell_order.h"
#include "geom/arrays/zeroed_array.h"

namespace cocoon {
namespace {

enum class Seen : std::uint8_t { no = 0, small, large };

}  // namespace

std::vector<std::vector<CellId>> small_parts(const Triangulation& triangulation,
                                             const IdVector<CellId, std::uint8_t>& out,
                                             std::span<const CellId> at, std::size_t most_cells) {
  ZeroedArray<CellId, Seen> seen(triangulation.num_cells());
  std::vector<std::vector<CellId>> parts;
  bool any_large = false;
  std::size_t found = 0;
  std::vector<CellId> part;
  for (const CellId first : at) {
    if (out[first] != 0 || seen[first] != Seen::no) continue;
    part.assign(1, first);
    seen[first] = Seen::small;
    bool is_large = false;
    for (std::size_t next = 0; next < part.size() && !is_large; ++next) {
      for (int i = 0; i < 4; ++i) {
        const CellId behind = triangulation.neighbor(part[next], i);
        if (out[behind] != 0 || seen[behind] == Seen::small) continue;
        is_large = is_large || seen[behind] == Seen::large;
        if (seen[behind] == Seen::large) continue;
        seen[behind] = Seen::small;
        part.push_back(behind);
      }
      is_large = is_large || part.size() > most_cells;
    }
    any_large = any_large || is_large;
    if (is_large) {
      for (const CellId c : part) seen[c] = Seen::large;
    } else {
      found += part.size();
      parts.push_back(part);
    }
  }
  std::sort(parts.begin(), parts.end(),
            [&](const auto& a, const auto& b) { return precedes(triangulation, a, b); });
  if (any_large || parts.empty()) return parts;
  std::size_t body = 0;
  for (const CellId c : triangulation.finite_cells()) body += out[c] == 0 ? 1U : 0U;
  if (parts.back().size() >= body - found) parts.pop_back();
  return parts;
}

}  // namespace cocoon
