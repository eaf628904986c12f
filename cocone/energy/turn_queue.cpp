#include "cocone/energy/turn_queue.h"

#include <utility>

namespace cocoon {

void TurnQueue::push(float clarity, std::uint32_t rank) {
  const std::size_t k = class_of(clarity);
  if (k < open_) {
    waiting_[k].push_back(make_turn(clarity, rank));
  } else {
    late_.push(make_turn(clarity, rank));
  }
}

bool TurnQueue::pop(Turn& turn) {
  while (sorted_.empty() && late_.empty()) {
    if (!open_next_class()) return false;
  }
  if (late_.empty() || (!sorted_.empty() && sorted_.back() > late_.top())) {
    turn = sorted_.back();
    sorted_.pop_back();
  } else {
    turn = late_.top();
    late_.pop();
  }
  return true;
}

bool TurnQueue::open_next_class() {
  if (open_ == 0) return false;
  --open_;
  sorted_ = std::move(waiting_[open_]);
  std::sort(sorted_.begin(), sorted_.end());
  return true;
}

}  // namespace cocoon
