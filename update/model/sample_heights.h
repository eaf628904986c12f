// Samples, and how far they are from the model.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/box_tree.h"
#include "geom/point.h"
#include "update/model/model_index.h"

namespace cocoon {

// The squared distance of each place from the model; infinity where it is more than `bound`.
// Complexity: what NearFacets takes, and O(log f) for each place. Source: ours.
std::vector<double> squared_heights(const ModelIndex& model, Points places, double bound);

// Which samples are farther from the model than this, ascending; and these samples. Complexity: as
// squared_heights().
std::vector<PointId> which_are_off(const ModelIndex& model, Points samples, double distance);
std::vector<Point> samples_off(const ModelIndex& model, Points samples, double distance);

// Samples with their heights, found by place.
class SampleHeights {
 public:
  // One height for each sample. Complexity: O(n log n).
  SampleHeights(std::vector<Point> samples, std::vector<double> squared_heights);

  // Whether holds(sample, its squared height) for some sample at most `reach` from p.
  template <class Holds>
  bool any_near(const Point& p, double reach, const Holds& holds) const {
    bool found = false;
    if (samples_.empty()) return false;
    tree_.visit_near(p, reach * reach, [&](std::uint32_t slot) {
      const std::uint32_t k = tree_.items()[slot];
      found = found || (squared_distance(p, samples_[k]) <= reach * reach &&
                        holds(samples_[k], squared_heights_[k]));
      return found ? -1.0 : reach * reach;
    });
    return found;
  }

 private:
  std::vector<Point> samples_;
  std::vector<double> squared_heights_;
  BoxTree tree_;
};

}  // namespace cocoon
