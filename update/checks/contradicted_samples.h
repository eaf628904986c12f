// Samples of a cloud where what is inside the updated body is contradicted.
#pragma once

#include <cstddef>
#include <span>

#include "geom/point.h"
#include "update/cloud/scan.h"

namespace cocoon {

struct ContradictedOptions {
  // So many of them are worth a warning, if they are this share of the samples, too. Of 504 updates
  // of parts one of 293 right ones had as many, and nine of 74 wrong ones that nothing else told.
  std::size_t min_count = 10;
  double min_share = 0.01;
  // Told is the place with most of them within so many spacings.
  double reach = 3;
};

struct ContradictedSamples {
  std::size_t count = 0;
  std::size_t of = 0;  // samples of the cloud
  Point at = {};       // the one with most others near it; ties by lexicographic order

  bool is_doubtful(const ContradictedOptions& options) const {
    return count >= options.min_count &&
           static_cast<double>(count) >= options.min_share * static_cast<double>(of);
  }
};

// `contradicted`: those samples of the scan that are among ReconstructResult::contradicted. Why:
// where walls are closer together than the samples are dense, good samples tell both inside and
// outside of one place, and the surface is a guess there. Only the place costs time: O(n log n) for
// n contradicted samples, and what lies within reach of each. Deterministic. Errors: InputError
// for options out of range. Source: ours.
ContradictedSamples contradicted_samples(const Scan& scan, std::span<const Point> contradicted,
                                         const ContradictedOptions& options = {});

}  // namespace cocoon
