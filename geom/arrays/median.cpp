#include "geom/arrays/median.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace cocoon {

namespace {

// The element of this rank, if it lies among those of about that rank in a sample, of which there
// are few: one pass without a branch that could be guessed wrong.
std::optional<double> find_by_sample(std::span<const double> values, std::size_t rank) {
  constexpr std::size_t many = std::size_t{1} << 16;
  const std::size_t sampled = values.size() < many ? 1024 : 4096;
  // Four times the deviation that a random sample has.
  const std::size_t margin = values.size() < many ? 64 : 128;
  std::vector<double> sample(sampled);
  const std::size_t stride = values.size() / sampled;
  for (std::size_t k = 0; k < sampled; ++k) sample[k] = values[k * stride];
  std::sort(sample.begin(), sample.end());
  const std::size_t at = rank / stride;
  if (at < margin || at + margin >= sampled) return std::nullopt;
  const double low = sample[at - margin];
  const double high = sample[at + margin];
  std::vector<double> near;
  std::size_t below = 0;
  std::array<double, 1024> found;
  for (std::size_t begin = 0; begin < values.size(); begin += found.size()) {
    std::size_t count = 0;
    for (const double value :
         values.subspan(begin, std::min(found.size(), values.size() - begin))) {
      below += value < low ? 1U : 0U;
      found[count] = value;  // stays if it is one of those
      count += value >= low && value <= high ? 1U : 0U;
    }
    near.insert(near.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
  }
  if (rank < below || rank - below >= near.size()) return std::nullopt;
  const auto position = near.begin() + static_cast<std::ptrdiff_t>(rank - below);
  std::nth_element(near.begin(), position, near.end());
  return *position;
}

}  // namespace

double median(std::vector<double> values) { return quantile_in_place(values, 0.5); }

double quantile_in_place(std::span<double> values, double fraction) {
  if (values.empty()) return 0;
  const std::size_t rank = std::min(
      values.size() - 1, static_cast<std::size_t>(fraction * static_cast<double>(values.size())));
  constexpr std::size_t worth_a_sample = std::size_t{1} << 13;
  if (values.size() >= worth_a_sample) {
    if (const std::optional<double> found = find_by_sample(values, rank)) return *found;
  }
  const auto position = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), position, values.end());
  return *position;
}

}  // namespace cocoon
