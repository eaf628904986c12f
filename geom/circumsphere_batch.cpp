#include "geom/circumsphere_batch.h"

#include <span>

#include "geom/lanes/vector_dispatch.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geom/circumsphere_batch.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/lanes/circumcenter_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

void certified_centers(std::span<CircumcenterBatch> batches) {
  const Lanes d;
  for (CircumcenterBatch& batch : batches) {
    batch.certified = 0;
    for (std::size_t first = 0; first < circumcenter_batch_size; first += hn::Lanes(d)) {
      Vectors centers;
      const Mask sure =
          circumcenters({load(batch.corners[0], first), load(batch.corners[1], first),
                         load(batch.corners[2], first), load(batch.corners[3], first)},
                        centers);
      store(centers, batch.centers, first);
      batch.certified |= lane_bits(sure) << first;
    }
  }
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(certified_centers);

void circumcenters_in_doubles(std::span<CircumcenterBatch> batches) {
  COCOON_VECTOR_CALL(certified_centers)(batches);
}

}  // namespace cocoon

#endif  // HWY_ONCE
