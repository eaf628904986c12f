#include "update/checks/unused_changes.h"

#include <algorithm>

#include "geom/messages/require_size.h"
#include "geom/search/box_tree.h"
#include "update/model/sample_heights.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Those that have others near them.
std::vector<Point> without_strays(const std::vector<Point>& samples, std::size_t neighbors,
                                  double reach) {
  const BoxTree tree = tree_of_points(samples);
  const double bound = reach * reach;
  std::vector<Point> found;
  for (const Point& p : samples) {  // each is near itself, too
    if (count_near(tree, samples, p, bound, neighbors) > neighbors) found.push_back(p);
  }
  return found;
}

}  // namespace

UnusedChanges unused_changes(const ModelIndex& model, std::span<const Scan> scans,
                             std::span<const std::vector<Point>> unused,
                             const UnusedChangeOptions& options) {
  require_options("unused_changes", options);
  require_size("unused_changes", "lists of unused samples", unused.size(), scans.size());
  UnusedChanges changes;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (unused[i].size() <= options.neighbors) continue;
    const double distance = options.off_model * scans[i].spacing;
    const std::vector<Point> found =
        without_strays(samples_off_model(model, unused[i], distance), options.neighbors,
                       options.reach * scans[i].spacing);
    if (found.empty()) continue;
    if (changes.samples == 0) changes.at = *std::min_element(found.begin(), found.end());
    changes.samples += found.size();
    changes.of += samples_off_model(model, scans[i].samples, distance).size();
  }
  return changes;
}

}  // namespace cocoon
