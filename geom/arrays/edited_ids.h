// Renews what names the elements of a list that was edited.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geom/arrays/list_edit.h"
#include "geom/id_vector.h"

namespace cocoon {

// Most elements stay in a few long runs, in each of which all move as far, and what lies together
// mostly names what lies together: blocks that name elements of one long run alone are renewed
// without a look at the table of places.
template <class IdType>
class EditedIds {
 public:
  // Keeps a reference to `places`: places_after(edit, places.size()).
  EditedIds(const ListEdit<IdType>& edit, const IdVector<IdType, IdType>& places)
      : places_(places) {
    for (const KeptRun& run : kept_runs(edit, places.size())) {
      if (run.count > runs_[0].count) {
        runs_[1] = runs_[0];
        runs_[0] = run;
      } else if (run.count > runs_[1].count) {
        runs_[1] = run;
      }
    }
  }

  // Each id becomes that of its element now. Complexity: O(ids).
  void renew(std::span<IdType> ids) const {
    for (const KeptRun& run : runs_) {
      if (!lie_in(ids.first(std::min<std::size_t>(ids.size(), 1)), run)) continue;
      if (lie_in(ids, run)) return shift(ids, run);
    }
    for (IdType& id : ids) id = places_[id];
  }
  // The same for triples.
  void renew(std::span<std::array<IdType, 3>> triples) const {
    if (!triples.empty()) renew(std::span<IdType>(triples.front().data(), 3 * triples.size()));
  }

 private:
  // Without a branch or a copy of each, so that several are compared at once.
  static bool lie_in(std::span<const IdType> ids, const KeptRun& run) {
    const auto from = static_cast<std::uint32_t>(run.from);
    const auto count = static_cast<std::uint32_t>(run.count);
    std::uint32_t outside = 0;
    for (const IdType& id : ids) outside |= id.value - from >= count ? 1U : 0U;  // below: wraps
    return outside == 0;
  }
  static void shift(std::span<IdType> ids, const KeptRun& run) {
    const auto by = static_cast<std::uint32_t>(run.to) - static_cast<std::uint32_t>(run.from);
    if (by == 0) return;
    for (IdType& id : ids) id.value += by;
  }

  const IdVector<IdType, IdType>& places_;
  std::array<KeptRun, 2> runs_{};  // the longest
};

}  // namespace cocoon
