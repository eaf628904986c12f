#include "update/stray_samples.h"

#include <algorithm>
#include <utility>

#include "cocone/noise/remaining_samples.h"
#include "cocone/noise/sample_parts.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

NoiseOptions noise_of(const StrayOptions& options) {
  NoiseOptions noise;
  noise.neighbors = options.neighbors;
  noise.outlier_ratio = options.outlier_ratio;
  return noise;
}

class Strays {
 public:
  Strays(Points cloud, const StrayOptions& options, const DelaunayOptions& delaunay_options,
         const Execution& execution)
      : options_(options),
        samples_(cloud, noise_of(options), FlatSamples::moved, delaunay_options, execution) {}

  StraySamples run() {
    // Small parts first: beside a dense one a good sample would stand alone. And again after the
    // outliers, by which some may hang together with the rest.
    if (leave_out_small_parts()) samples_.triangulate();
    result_.outliers = samples_.leave_out_outliers(samples_.outliers()).count;
    if (result_.outliers > 0) leave_out_small_parts();
    result_.kept = samples_.kept();
    return std::move(result_);
  }

 private:
  // Whether there were any; then the triangulation is still that with them.
  bool leave_out_small_parts() {
    const Triangulation& triangulation = samples_.triangulation();
    IdVector<VertexId, double> reach = samples_.spacing();
    for (const VertexId v : triangulation.vertices()) reach[v] *= options_.link_ratio;
    const SampleParts parts = sample_parts(triangulation, reach);
    const std::size_t enough = std::min(options_.min_part, parts.largest);
    VertexSet out(triangulation.num_vertices(), 0);
    for (const VertexId v : triangulation.vertices()) {
      if (parts.size[parts.part[v]] >= enough) continue;
      out[v] = 1;
      ++result_.in_small_parts;
      result_.small_parts += parts.part[v] == v ? 1U : 0U;
    }
    const bool found = std::find(out.begin(), out.end(), 1) != out.end();
    if (found) samples_.leave_out(out);
    return found;
  }

  const StrayOptions& options_;
  RemainingSamples samples_;
  StraySamples result_;
};

}  // namespace

StraySamples stray_samples(Points cloud, const StrayOptions& options,
                           const DelaunayOptions& delaunay_options, const Execution& execution) {
  require_options("stray_samples", options);
  return run_step(execution, "noise", [&](const Execution& nested) {
    return Strays(cloud, options, delaunay_options, nested).run();
  });
}

}  // namespace cocoon
