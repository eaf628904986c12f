#include "update/checks/unit_factor.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "geom/mesh_measure.h"

namespace cocoon {
namespace {

// Those nearest to 1 first, of two that are as near the larger one.
std::vector<double> unit_factors() {
  constexpr std::array<double, 5> millimeters = {1, 10, 25.4, 304.8, 1000};
  std::vector<double> factors;
  for (const double from : millimeters) {
    for (const double to : millimeters) {
      if (from != to) factors.push_back(from / to);
    }
  }
  const auto rank = [](double factor) {
    return std::pair(std::max(factor, 1 / factor), factor < 1);
  };
  std::sort(factors.begin(), factors.end(), [&](double a, double b) { return rank(a) < rank(b); });
  return factors;
}

}  // namespace

std::optional<double> unit_factor(const ModelIndex& model, const CloudRim& rim,
                                  const Overlap& as_is, const OverlapOptions& options,
                                  const Execution& execution) {
  constexpr double most_apart = 30;
  constexpr double most_matched = 0.2;
  std::size_t points = 0;
  for (const LoopOverlap& loop : as_is.loops) points += loop.facets.size() - loop.inner_points;
  const auto matched = static_cast<double>(points - as_is.unmatched);
  if (matched > most_matched * static_cast<double>(points)) return {};
  const double edge = mesh_measure(model.mesh()).edge_lengths.median;
  for (const double factor : unit_factors()) {
    const double ratio = factor * rim.spacing / edge;
    if (!(ratio < most_apart && ratio > 1 / most_apart)) continue;
    const Overlap overlap = overlapping_facets(model, scaled(rim, factor), options, execution);
    if (overlap.status == OverlapStatus::ok) return factor;
  }
  return {};
}

}  // namespace cocoon
