#include "update/stray_samples.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cocone/noise/remaining_samples.h"
#include "cocone/samples/sample_spacing.h"
#include "geom/disjoint_sets.h"

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
      : options_(options), samples_(cloud, noise_of(options), delaunay_options, execution) {}

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
    const std::vector<std::uint32_t> part = parts();
    std::vector<std::size_t> size(part.size(), 0);
    for (const VertexId v : triangulation.vertices()) ++size[part[v.index()]];
    const std::size_t largest = *std::max_element(size.begin(), size.end());
    const std::size_t enough = std::min(options_.min_part, largest);
    VertexSet out(triangulation.num_vertices(), 0);
    for (const VertexId v : triangulation.vertices()) {
      if (size[part[v.index()]] >= enough) continue;
      out[v] = 1;
      ++result_.in_small_parts;
      result_.small_parts += part[v.index()] == v.index() ? 1U : 0U;  // its root
    }
    const bool found = std::find(out.begin(), out.end(), 1) != out.end();
    if (found) samples_.leave_out(out);
    return found;
  }

  // The part of each vertex among those that hang together: the smallest vertex of it.
  std::vector<std::uint32_t> parts() {
    const Triangulation& triangulation = samples_.triangulation();
    const IdVector<VertexId, double>& spacing = samples_.spacing();
    DisjointSets sets(triangulation.num_vertices());
    std::vector<VertexId> around;
    for (const VertexId v : triangulation.vertices()) {
      collect_neighbors(triangulation, samples_.stars().star(v), v, around);
      for (const VertexId w : around) {
        if (w < v) continue;
        const double reach = options_.link_ratio * std::min(spacing[v], spacing[w]);
        if (distance(triangulation.point(v), triangulation.point(w)) > reach) continue;
        sets.join(v.value, w.value);
      }
    }
    std::vector<std::uint32_t> part(triangulation.num_vertices());
    for (const VertexId v : triangulation.vertices()) part[v.index()] = sets.root(v.value);
    return part;
  }

  const StrayOptions& options_;
  RemainingSamples samples_;
  StraySamples result_;
};

}  // namespace

StraySamples stray_samples(Points cloud, const StrayOptions& options,
                           const DelaunayOptions& delaunay_options, const Execution& execution) {
  return run_step(execution, "noise", [&](const Execution& nested) {
    return Strays(cloud, options, delaunay_options, nested).run();
  });
}

}  // namespace cocoon
