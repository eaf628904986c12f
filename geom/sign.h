// The result of a predicate.
#pragma once

namespace cocoon {

enum class Sign : int { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign sign_of(double value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

}  // namespace cocoon
