#include "update/shadowed_rim.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/messages/require_size.h"
#include "update/stage_options.h"

namespace cocoon {
namespace {

// Of its matched points from the model.
std::vector<double> distances_of(const RimLoop& loop, const LoopOverlap& found) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (found.facets[i].is_none() || loop.is_inner_point(i)) continue;
    distances.push_back(distance(found.feet[i], loop.points[i]));
  }
  return distances;
}

}  // namespace

bool take_shadowed_rim(const CloudRim& rim, const ShadowOptions& options, Overlap& overlap) {
  require_options("take_shadowed_rim", options);
  require_size("take_shadowed_rim", "loops of the overlap", overlap.loops.size(), rim.loops.size());
  if (rim.loops.empty() || options.max_unmatched_share == 0) return false;
  const std::size_t longest = rim.longest_loop();
  LoopOverlap& found = overlap.loops[longest];
  if (found.match != LoopMatch::off_model) return false;
  const std::size_t points = found.facets.size() - found.inner_points - found.covered;
  const std::size_t unmatched = found.unmatched - found.covered;
  const double most = options.max_unmatched_share * static_cast<double>(points);
  std::vector<double> distances = distances_of(rim.loops[longest], found);
  if (distances.empty() || static_cast<double>(unmatched) > most) return false;
  if (median(std::move(distances)) > options.max_distance * rim.spacing) return false;
  found.match = LoopMatch::on_model;
  overlap.status = OverlapStatus::ok;
  overlap.leaves_model = true;
  overlap.figures.in_shadow = unmatched;
  overlap.figures.in_shadow_of = points;
  return true;
}

}  // namespace cocoon
