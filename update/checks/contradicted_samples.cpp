#include "update/checks/contradicted_samples.h"

#include "geom/search/box_tree.h"
#include "update/stage_options.h"

namespace cocoon {

ContradictedSamples contradicted_samples(const Scan& scan, std::span<const Point> contradicted,
                                         const ContradictedOptions& options) {
  require_options("contradicted_samples", options);
  ContradictedSamples found{contradicted.size(), scan.samples.size(), {}};
  if (!found.is_doubtful(options)) return found;
  const BoxTree tree = tree_of_points(contradicted);
  const double bound = options.reach * scan.spacing * (options.reach * scan.spacing);
  std::size_t most = 0;
  for (const Point& p : contradicted) {
    const std::size_t near = count_near(tree, contradicted, p, bound, contradicted.size());
    if (near < most || (near == most && found.at < p)) continue;
    most = near;
    found.at = p;
  }
  return found;
}

}  // namespace cocoon
