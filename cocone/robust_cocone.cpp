#include "cocone/robust_cocone.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "cocone/inputs/stage_inputs.h"
#include "cocone/noise/floating_clumps.h"
#include "cocone/noise/remaining_samples.h"
#include "cocone/noise/rough_surface.h"
#include "delaunay/voronoi_dual.h"
#include "geom/search/equal_points.h"

namespace cocoon {
namespace {

// As given: where points were made smaller to be triangulated, some may have become equal.
std::size_t count_distinct(Points points, const RemainingSamples& samples) {
  return samples.scale() < 1 ? points.size() - repeated_points(points).size()
                             : samples.triangulation().num_vertices();
}

// What is left out, and what it is counted as.
class Filter {
 public:
  Filter(Points points, const NoiseOptions& noise, const ReconstructOptions& options,
         const Execution& execution)
      : noise_(noise),
        options_(effective_options(options)),
        execution_(execution),
        samples_(points, noise, FlatSamples::refused, options_.delaunay, execution) {
    result_.distinct = count_distinct(points, samples_);
  }

  RobustSamples run() {
    // Clumps first: beside a dense one a good sample would stand alone. And again after the
    // outliers, by which some may hang together with the rest.
    // Once more where some have gone beside which squares of the others' lengths may have vanished.
    double scale = 0;
    do {
      scale = samples_.scale();
      leave_out_clumps();
      leave_out_outliers();
    } while (samples_.scale() > 0x1p+100 * scale);
    if (result_.counters.outliers > 0) leave_out_clumps();
    judge_layer();
    result_.kept = samples_.kept();
    return std::move(result_);
  }

 private:
  void leave_out_clumps() {
    if (noise_.clump_share <= 0) return;
    const FloatingClumps found =
        floating_clumps(samples_.triangulation(), samples_.stars(), samples_.spacing(),
                        surface().good(), noise_, execution_);
    NoiseCounters& counters = result_.counters;
    if (found.clumps == 0) return;
    counters.clumps += found.clumps;
    counters.clump_samples += found.samples;
    if (found.largest > counters.largest_clump) {
      counters.largest_clump = found.largest;
      counters.largest_clump_at = samples_.input_of(found.at);
    }
    samples_.leave_out(found.out);
    samples_.triangulate();
    forget_surface();
  }

  void leave_out_outliers() {
    const VertexSet first = samples_.outliers();
    const bool any = std::find(first.begin(), first.end(), 1) != first.end();
    const RemainingSamples::Outliers outliers =
        any && noise_.spare_good ? samples_.leave_out_outliers(first, surface().good())
                                 : samples_.leave_out_outliers(first);
    if (outliers.count > 0) forget_surface();
    NoiseCounters& counters = result_.counters;
    counters.outliers += outliers.count;
    counters.outlier_rounds += outliers.rounds;
    counters.spared_samples = outliers.spared;
  }

  // Of samples that are no longer all there.
  void forget_surface() {
    surface_.reset();
    dual_.reset();
  }

  // Of the samples that remain, built when first asked for.
  const Dual& dual() {
    if (!dual_) dual_ = voronoi_dual(samples_.triangulation(), execution_);
    return *dual_;
  }
  const RoughSurface& surface() {
    if (!surface_) surface_.emplace(samples_.triangulation(), dual(), options_, execution_);
    return *surface_;
  }

  void judge_layer() {
    const Triangulation& triangulation = samples_.triangulation();
    const OuterSkin skin = held_skin();
    NoiseCounters& counters = result_.counters;
    counters.large_cells = skin.large_cells;
    counters.outer_cells = skin.outer_cells;
    VertexSet out(triangulation.num_vertices(), 0);
    for (const VertexId v : triangulation.vertices()) {
      if (skin.touched[v] != 0) {
        ++counters.skin_samples;
      } else if (noise_.keep_good && surface().good()[v] != 0) {
        ++counters.good_samples;
      } else {
        out[v] = 1;
        ++counters.layer_samples;
      }
    }
    samples_.leave_out(out);
  }

  OuterSkin held_skin() {
    const Triangulation& triangulation = samples_.triangulation();
    OuterSkin skin = outer_skin(triangulation, dual(), samples_.spacing(), noise_);
    if (noise_.max_leak >= 1) return skin;
    const IdVector<CellId, std::uint8_t> outside = surface().outside(execution_);
    if (outside.empty()) return skin;
    NoiseCounters& counters = result_.counters;
    for (const CellId c : triangulation.finite_cells()) {
      if (outside[c] != 0 || skin.balls[c] == BallSize::small) continue;
      ++counters.inner_cells;
      counters.leaked_cells += skin.balls[c] == BallSize::outer ? 1U : 0U;
    }
    counters.held = static_cast<double>(counters.leaked_cells) >
                    noise_.max_leak * static_cast<double>(counters.inner_cells);
    if (counters.held) {
      skin = outer_skin(triangulation, dual(), samples_.spacing(), noise_, outside);
    }
    return skin;
  }

  const NoiseOptions& noise_;
  const ReconstructOptions options_;
  const Execution& execution_;
  RemainingSamples samples_;
  std::optional<Dual> dual_;
  std::optional<RoughSurface> surface_;
  RobustSamples result_;
};

}  // namespace

RobustSamples robust_samples(Points points, const NoiseOptions& noise,
                             const ReconstructOptions& options, const Execution& execution) {
  require_options("robust_samples", noise);
  return run_step(execution, "noise", [&](const Execution& nested) {
    return Filter(points, noise, options, nested).run();
  });
}

RobustResult reconstruct_robust(Points points, const NoiseOptions& noise,
                                const ReconstructOptions& options, const Execution& execution) {
  const RobustSamples samples = robust_samples(points, noise, options, execution);
  std::vector<Point> kept;
  std::vector<PointId> inputs;
  for (const PointId p : samples.kept.ids()) {
    if (samples.kept[p] == 0) continue;
    kept.push_back(points[p.index()]);
    inputs.push_back(p);
  }
  RobustResult result{reconstruct_tight(kept, options, execution), samples.counters};
  ReconstructResult& surface = result.surface;
  for (PointId& p : surface.point_of_vertex) p = inputs[p.index()];
  for (PointId& p : surface.contradicted) p = inputs[p.index()];
  surface.points = points.size();
  surface.duplicates = points.size() - samples.distinct;
  surface.unused_points = samples.distinct - surface.mesh.points.size();
  return result;
}

}  // namespace cocoon
