// How far samples are from the model.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "update/model/model_index.h"
#include "update/model/near_facets.h"

namespace cocoon {

// The squared distance of each place from the model; infinity where it is more than `bound`. If
// the places are out of register by `shift`, as far as is known, the lesser of two distances: as
// they lie, and moved back by it.
// Complexity: what NearFacets takes, and O(log f) for each place. Source: ours.
std::vector<double> squared_heights(const ModelIndex& model, Points places, double bound,
                                    const Vec3& shift = {});

// Which samples are farther from the model than this, ascending; and these samples. Complexity: as
// squared_heights().
std::vector<PointId> ids_off_model(const ModelIndex& model, Points samples, double distance,
                                   const Vec3& shift = {});
std::vector<Point> samples_off_model(const ModelIndex& model, Points samples, double distance,
                                     const Vec3& shift = {});

// Measures samples when they are first asked for. Refers to them and to the model, which must
// outlive it.
class SampleHeights {
 public:
  // Is asked only for samples at most `reach` from one of the places; does not tell distances above
  // `bound`. Complexity: O(samples + places), and what NearFacets takes for those near.
  SampleHeights(const ModelIndex& model, Points samples, Points places, double reach, double bound,
                const Vec3& shift = {});

  // As squared_heights(). Complexity: O(log f) for the first time, O(1) from then on.
  double squared(PointId sample);

 private:
  Points samples_;
  Vec3 shift_;
  NearFacets near_;
  std::unordered_map<std::size_t, double> known_;
};

}  // namespace cocoon
