#include "cocone/robust_cocone.h"

#include <utility>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/candidate_triangles.h"
#include "cocone/clean_up_cells.h"
#include "cocone/cocones.h"
#include "cocone/extract_manifold.h"
#include "cocone/mark_cells.h"
#include "cocone/peel_cells.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/remaining_samples.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {
namespace {

// Of all samples, the layer included; closed only if asked for.
struct RoughSurface {
  VertexSet good;                          // one disk of the Cocone surface around them
  IdVector<CellId, std::uint8_t> outside;  // 1 = outside the closed surface; empty if there is none
};

RoughSurface rough_surface(const Triangulation& triangulation, const Dual& dual, bool closed,
                           const ReconstructOptions& options, const Execution& execution) {
  ConeSides sides;
  const Poles poles = compute_poles(triangulation, dual, options.cocone.cosine, sides, execution);
  const Cocones cocones = intersect_cocones(triangulation, std::move(sides), execution);
  const BoundarySamples labels =
      boundary_samples(triangulation, dual, poles, cocones, options.boundary, execution);
  if (labels.interior() == 0) return {VertexSet(triangulation.num_vertices(), 0), {}};
  PrunedCandidates pruned = prune_sharp_edges(
      triangulation, list_candidate_triangles(triangulation, cocones, labels.boundary, execution),
      options.prune, execution);
  const ManifoldSurface surface =
      extract_manifold(triangulation, std::move(pruned.left), pruned.umbrella, execution);
  CellMarks marks = mark_cells(triangulation, surface.triangles, labels.boundary,
                               options.good_vertices, execution);
  if (!closed) return {std::move(marks.good), {}};
  marks =
      peel_cells(triangulation, surface.triangles.set, std::move(marks), options.peel, execution);
  clean_up_cells(triangulation, poles, marks, options.clean_up, execution);
  return {std::move(marks.good), std::move(marks.reached)};
}

// What is left out, and what it is counted as.
class Filter {
 public:
  Filter(Points points, const NoiseOptions& noise, const ReconstructOptions& options,
         const Execution& execution)
      : noise_(noise),
        options_(effective_options(options)),
        execution_(execution),
        samples_(points, noise, options_.delaunay, execution) {}

  RobustSamples run() {
    result_.distinct = samples_.triangulation().num_vertices();
    const RemainingSamples::Outliers outliers = samples_.leave_out_outliers();
    result_.counters.outliers = outliers.count;
    result_.counters.outlier_rounds = outliers.rounds;
    judge_layer();
    result_.kept = samples_.kept();
    return std::move(result_);
  }

 private:
  void judge_layer() {
    const Triangulation& triangulation = samples_.triangulation();
    const Dual dual = voronoi_dual(triangulation, execution_);
    RoughSurface rough;
    const bool may_hold = noise_.max_leak < 1;
    if (noise_.keep_good || may_hold) {
      rough = rough_surface(triangulation, dual, may_hold, options_, execution_);
    }
    const OuterSkin skin = held_skin(dual, rough.outside);
    NoiseCounters& counters = result_.counters;
    counters.large_cells = skin.large_cells;
    counters.outer_cells = skin.outer_cells;
    VertexSet out(triangulation.num_vertices(), 0);
    for (const VertexId v : triangulation.vertices()) {
      if (skin.touched[v] != 0) {
        ++counters.skin_samples;
      } else if (noise_.keep_good && rough.good[v] != 0) {
        ++counters.good_samples;
      } else {
        out[v] = 1;
        ++counters.layer_samples;
      }
    }
    samples_.leave_out(out);
  }

  OuterSkin held_skin(const Dual& dual, const IdVector<CellId, std::uint8_t>& outside) {
    const Triangulation& triangulation = samples_.triangulation();
    OuterSkin skin = outer_skin(triangulation, dual, samples_.spacing(), noise_);
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
      skin = outer_skin(triangulation, dual, samples_.spacing(), noise_, outside);
    }
    return skin;
  }

  const NoiseOptions& noise_;
  const ReconstructOptions options_;
  const Execution& execution_;
  RemainingSamples samples_;
  RobustSamples result_;
};

}  // namespace

RobustSamples robust_samples(Points points, const NoiseOptions& noise,
                             const ReconstructOptions& options, const Execution& execution) {
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
  surface.points = points.size();
  surface.duplicates = points.size() - samples.distinct;
  surface.unused_points = samples.distinct - surface.mesh.points.size();
  return result;
}

}  // namespace cocoon
