#include "update/cloud/raised_loops.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {
namespace {

// The median of the distances of its points from the model; of those without a facet, infinity.
double median_height(const RimLoop& rim, const LoopOverlap& loop) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    if (rim.is_inner_point(i)) continue;
    heights.push_back(loop.facets[i].is_none() ? std::numeric_limits<double>::infinity()
                                               : distance(loop.feet[i], rim.points[i]));
  }
  return median(std::move(heights));
}

// The longest loop of each part of the surface.
std::map<std::uint32_t, std::size_t> outlines(const CloudRim& rim) {
  std::map<std::uint32_t, std::size_t> longest;
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    const auto [entry, is_new] = longest.try_emplace(rim.loops[l].component, l);
    std::size_t& best = entry->second;
    if (!is_new && rim.loops[l].perimeter > rim.loops[best].perimeter) best = l;
  }
  return longest;
}

}  // namespace

double larger_spacing(const ModelIndex& model, const CloudRim& rim, TriangleId facet) {
  return std::max(rim.spacing, median_edge(model.mesh(), facet));
}

void measure_excess(const ModelIndex& model, const CloudRim& rim, Overlap& overlap) {
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    const LoopOverlap& loop = overlap.loops[l];
    for (std::size_t i = 0; i < rim.loops[l].size(); ++i) {
      const TriangleId facet = loop.facets[i];
      if (facet.is_none() || rim.loops[l].is_inner_point(i)) continue;
      const double excess =
          distance(loop.feet[i], rim.loops[l].points[i]) - overlap.figures.median_distance;
      const double spacing = larger_spacing(model, rim, facet);
      overlap.figures.largest_excess = std::max(overlap.figures.largest_excess, excess / spacing);
    }
  }
}

void count_raised(const ModelIndex& model, const CloudRim& rim, double raised_distance,
                  Overlap& overlap) {
  if (rim.loops.empty()) return;
  const std::size_t first = rim.longest_loop();
  const double usual = median_height(rim.loops[first], overlap.loops[first]);
  std::map<std::uint32_t, double> usual_of_part;
  for (const auto& [part, l] : outlines(rim)) {
    overlap.loops[l].is_outline = true;
    usual_of_part[part] = std::min(usual, median_height(rim.loops[l], overlap.loops[l]));
  }
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (l == first) continue;
    const RimLoop& points = rim.loops[l];
    LoopOverlap& loop = overlap.loops[l];
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points.is_inner_point(i)) continue;
      const TriangleId facet = loop.facets[i];
      if (facet.is_none()) {
        ++loop.raised;
        continue;
      }
      const double height = distance(loop.feet[i], points.points[i]);
      const double reference = loop.is_outline ? usual : usual_of_part[points.component];
      if (height > reference + raised_distance * larger_spacing(model, rim, facet)) ++loop.raised;
    }
  }
}

bool is_raised(const LoopOverlap& loop, const OverlapOptions& options) {
  const double share = loop.is_outline ? options.max_raised_outline : options.max_raised_share;
  const auto points = static_cast<double>(loop.facets.size() - loop.inner_points);
  return static_cast<double>(loop.raised) > share * points + static_cast<double>(loop.covered);
}

}  // namespace cocoon
