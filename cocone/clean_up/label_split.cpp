#include "cocone/clean_up/label_split.h"

#include <numeric>
#include <utility>

namespace cocoon {
namespace {

constexpr std::uint32_t taken_away = 0xFFFFFFFFU;  // the cells that change labels are of no front

}  // namespace

bool LabelSplit::splits(std::span<const CellId> cells) {
  for (const CellId c : cells) front_of_[c] = taken_away;
  touched_.assign(cells.begin(), cells.end());
  count_ = 0;
  for (const CellId c : cells) {
    for (int i = 0; i < 4; ++i) {
      const CellId behind = triangulation_.neighbor(c, i);
      if (out_[behind] == out_[c] && front_of_[behind] == 0) begin(behind);
    }
  }
  const bool apart = are_apart();
  for (const CellId c : touched_) front_of_[c] = 0;
  return apart;
}

void LabelSplit::begin(CellId c) {
  if (count_ == fronts_.size()) fronts_.emplace_back();
  Front& front = fronts_[count_++];
  front.cells.assign(1, c);
  front.next = 0;
  front.joined = 0;
  front_of_[c] = count_;
  touched_.push_back(c);
}

// Of many fronts nearly all have met soon: then only the others are looked at.
bool LabelSplit::are_apart() {
  apart_ = count_;
  growing_.resize(count_);
  std::iota(growing_.begin(), growing_.end(), 0U);
  const auto is_joined = [&](std::uint32_t k) { return fronts_[k].joined != 0; };
  while (apart_ > 1) {
    for (std::size_t i = 0; i < growing_.size() && apart_ > 1; ++i) {
      const std::uint32_t k = growing_[i];
      if (is_joined(k)) continue;
      if (fronts_[k].next == fronts_[k].cells.size()) return true;
      step(k);
    }
    if (2 * apart_ < growing_.size()) std::erase_if(growing_, is_joined);
  }
  return false;
}

void LabelSplit::step(std::uint32_t k) {
  const CellId c = fronts_[k].cells[fronts_[k].next++];
  for (int i = 0; i < 4; ++i) {
    const CellId behind = triangulation_.neighbor(c, i);
    if (out_[behind] != out_[c] || front_of_[behind] == taken_away) continue;
    if (front_of_[behind] == 0) {
      front_of_[behind] = k + 1;
      touched_.push_back(behind);
      fronts_[k].cells.push_back(behind);
    } else if (const std::uint32_t met = root(front_of_[behind] - 1); met != k) {
      join(k, met);
      k = root(k);
    }
  }
}

// The one with more to search goes on with what the other has left.
void LabelSplit::join(std::uint32_t a, std::uint32_t b) {
  const auto left = [&](std::uint32_t k) { return fronts_[k].cells.size() - fronts_[k].next; };
  if (left(a) < left(b)) std::swap(a, b);
  Front& from = fronts_[b];
  Front& to = fronts_[a];
  to.cells.insert(to.cells.end(), from.cells.begin() + static_cast<std::ptrdiff_t>(from.next),
                  from.cells.end());
  from.joined = a + 1;
  --apart_;
}

std::uint32_t LabelSplit::root(std::uint32_t k) const {
  while (fronts_[k].joined != 0) k = fronts_[k].joined - 1;
  return k;
}

}  // namespace cocoon
