// How a list became another one: what went and what came, while all others kept their order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "geom/id_vector.h"

namespace cocoon {

template <class IdType>
struct ListEdit {
  std::vector<IdType> removed;  // places in the list before, ascending
  std::vector<IdType> added;    // places in the list after, ascending

  // The way back.
  ListEdit reversed() const { return {added, removed}; }
  std::size_t size_after(std::size_t before) const {
    return before - removed.size() + added.size();
  }
};

// Elements that stay one after the other.
struct KeptRun {
  std::size_t from;  // the place of the first one before
  std::size_t to;    // and after
  std::size_t count;
};

// All of them, in order, as long as they can be. Complexity: O(removed + added).
template <class IdType>
std::vector<KeptRun> kept_runs(const ListEdit<IdType>& edit, std::size_t size_before) {
  std::vector<KeptRun> runs;
  auto removed = edit.removed.begin();
  auto added = edit.added.begin();
  for (KeptRun run{0, 0, 0};; run.from += run.count, run.to += run.count) {
    for (; removed != edit.removed.end() && removed->index() == run.from; ++removed) ++run.from;
    for (; added != edit.added.end() && added->index() == run.to; ++added) ++run.to;
    if (run.from == size_before) return runs;
    run.count = (removed == edit.removed.end() ? size_before : removed->index()) - run.from;
    if (added != edit.added.end()) run.count = std::min(run.count, added->index() - run.to);
    runs.push_back(run);
  }
}

// Where each element is now; none: gone. Complexity: O(n).
template <class IdType>
IdVector<IdType, IdType> places_after(const ListEdit<IdType>& edit, std::size_t size_before) {
  IdVector<IdType, IdType> places(size_before);
  for (const KeptRun& run : kept_runs(edit, size_before)) {
    for (std::size_t k = 0; k < run.count; ++k) {
      places[IdType(run.from + k)] = IdType(run.to + k);
    }
  }
  return places;
}

// Makes the list what it is after the edit; `added`: the elements that came, in order. Those that
// stay are renewed on their way, a block at a time, by renew(std::span<T>). In place: a run that
// moves to the left can only cover runs that did so before it, one that moves to the right only
// those after it. Complexity: O(n), and no new memory but where the list grows beyond what it had.
template <class IdType, class T, class Renew>
void edit_list_by_blocks(IdVector<IdType, T>& list, const ListEdit<IdType>& edit,
                         std::type_identity_t<std::span<const T>> added, const Renew& renew) {
  static_assert(std::is_trivially_copyable_v<T>);
  constexpr std::size_t block = 128;
  const std::vector<KeptRun> runs = kept_runs(edit, list.size());
  const std::size_t size = edit.size_after(list.size());
  if (size > list.size()) list.resize(size);
  T* const data = list.span().data();
  const auto move = [&](const KeptRun& run, std::size_t begin, std::size_t count) {
    const T* const from = data + run.from + begin;
    T* const to = data + run.to + begin;
    if (from != to) std::memmove(to, from, count * sizeof(T));
    renew(std::span<T>(to, count));
  };
  for (const KeptRun& run : runs) {
    if (run.to > run.from) continue;
    for (std::size_t k = 0; k < run.count; k += block) move(run, k, std::min(block, run.count - k));
  }
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    if (run->to <= run->from) continue;
    for (std::size_t left = run->count; left > 0;) {
      const std::size_t count = std::min(block, left);
      left -= count;
      move(*run, left, count);
    }
  }
  list.resize(size);
  for (std::size_t k = 0; k < added.size(); ++k) list[edit.added[k]] = added[k];
}

// The same for elements that stay as they are.
template <class IdType, class T>
void edit_list(IdVector<IdType, T>& list, const ListEdit<IdType>& edit,
               std::type_identity_t<std::span<const T>> added) {
  edit_list_by_blocks(list, edit, added, [](std::span<T>) {});
}

}  // namespace cocoon
