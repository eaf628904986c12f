#include "app/report/reconstruct_report.h"

#include <cmath>
#include <fmt/format.h>

#include "app/report/surface_report.h"
#include "app/report/verification.h"
#include "cocone/checks/sample_doubts.h"
#include "geom/errors.h"
#include "geom/messages/counted.h"
#include "geom/messages/place_name.h"

namespace cocoon::app {

namespace {

void add_clean_up_counters(JsonReport& report, const CleanUpCounters& c) {
  const auto set = [&report](const char* name, std::size_t value) {
    report.set(std::string("counters/clean_up/") + name, value);
  };
  set("undecided_cells", c.undecided_cells);
  set("thin_cells", c.thin_cells);
  set("left_cells", c.left_cells);
  set("flat_cells", c.flat_cells);
  set("relabeled_cells", c.relabeled_cells);
  set("filled_cells", c.filled_cells);
  set("moves", c.moves);
  set("moved_cells", c.moved_cells);
  set("large_stars", c.large_stars);
  set("clusters", c.clusters);
  set("cluster_cells", c.cluster_cells);
  set("large_clusters", c.large_clusters);
  set("dropped_components", c.dropped_components);
  set("compound_moves", c.compound_moves);
  set("compound_cells", c.compound_cells);
  set("closed_handles", c.closed_handles);
  set("closing_cells", c.closing_cells);
  set("large_handles", c.large_handles);
  set("changed_cells", c.changed_cells);
  set("defects_before", c.defects_before);
  set("defects_after", c.defects_after);
  set("unused_before", c.unused_before);
  set("unused_after", c.unused_after);
  set("outliers", c.outliers);
  set("idle_before", c.idle_before);
  set("idle_after", c.idle_after);
}

void add_counters(JsonReport& report, const ReconstructCounters& c, int threads) {
  const auto set = [&report](const char* name, std::size_t value) {
    report.set(std::string("counters/") + name, value);
  };
  // How these go depends on how the threads meet, if there are several; a report does not.
  if (threads == 1) {
    set("wide_inspheres", c.delaunay.wide_inspheres);
    set("exact_inspheres", c.delaunay.exact_inspheres);
    set("perturbed_inspheres", c.delaunay.perturbed_inspheres);
  }
  set("hull_vertices", c.hull_vertices);
  set("degenerate_poles", c.degenerate_poles);
  set("exact_centers", c.exact_centers);
  set("dual_facet_fallbacks", c.dual_facet_fallbacks);
  set("boundary_samples", c.boundary_samples);
  set("ratio_failed", c.ratio_failed);
  set("recovered_samples", c.recovered_samples);
  set("candidates", c.candidates);
  set("pruned", c.pruned);
  set("umbrellas", c.umbrellas);
  set("surface_triangles", c.surface_triangles);
  set("surface_walks", c.surface_walks);
  set("back_contacts", c.back_contacts);
  set("non_orientable_components", c.non_orientable_components);
  set("good_vertices", c.good_vertices);
  set("demoted_vertices", c.demoted_vertices);
  set("unvisited_vertices", c.unvisited_vertices);
  set("marking_rounds", c.marking_rounds);
  set("marking_conflicts", c.marking_conflicts);
  set("first_conflicts", c.first_conflicts);
  set("second_look", c.second_look);
  set("known_cells", c.known_cells);
  set("refuted_vertices", c.refuted_vertices);
  set("poor_cells", c.poor_cells);
  set("deferred_seeds", c.deferred_seeds);
  set("cavities", c.cavities.cavities);
  set("cavity_cells", c.cavities.cells);
  add_clean_up_counters(report, c.clean_up);
}

const char* name_of_rho(const SurfaceRemedies& remedies) { return remedies.rho ? "--rho" : "rho"; }

// "the smallest ratio of radius to height is 2.1, near (1, 2, 3), and --rho is 0.833"
std::string ratios_said(const SampleDoubts& doubts, double rho, const SurfaceRemedies& remedies) {
  if (!std::isfinite(doubts.least_ratio)) {
    return "they do not lie between two sides, as samples of a surface do";
  }
  if (doubts.least_ratio <= rho) {
    return fmt::format(
        "normals of neighbors differ by more than --alpha wherever {} {:.3g} is met, as near {} "
        "(try "
        "a larger --alpha)",
        name_of_rho(remedies), rho, place_name(doubts.best));
  }
  return fmt::format("the smallest ratio of radius to height is {:.3g}, near {}, and {} is {:.3g}",
                     doubts.least_ratio, place_name(doubts.best), name_of_rho(remedies), rho);
}

// How far apart they are and where, and what to do.
std::string samples_said(const SampleDoubts& doubts, double rho, const SurfaceRemedies& remedies) {
  constexpr double of_volumes = 2;  // random points of a cube: 1.3, of a sphere: 10 and more
  const bool no_layer = doubts.height > of_volumes;
  const bool rho_may_help = remedies.rho && doubts.least_ratio > rho && doubts.least_ratio < 1;
  return fmt::format(
      "their spacing is {:.3g} (median) and reaches {:.3g}, near {}; {}", doubts.spacing,
      doubts.sparse[0].size, place_name(doubts.sparse[0].at),
      no_layer ? (rho_may_help ? "scan more densely there, or try a larger --rho"
                               : "scan more densely there")
               : fmt::format("the medial axis is only {:.2g} spacings away: they "
                             "fill a volume, or are noisy{}, or too few for their "
                             "shape (scan more densely)",
                             doubts.height, remedies.noise_filter ? " (try --noise robust)" : ""));
}

}  // namespace

void add_reconstruction(Job& job, const ReconstructResult& result, const MeshReport& certificate) {
  JsonReport& report = job.report();
  report.set("input/points", result.points);
  report.set("input/duplicates", result.duplicates);
  report.set("delaunay/points", result.vertices);
  report.set("delaunay/tetrahedra", result.tetrahedra);
  add_surface(report, result.mesh, certificate);
  report.set("surface/unused_points", result.unused_points);
  add_counters(report, result.counters, thread_count(job.execution()));
}

void add_noise(JsonReport& report, const NoiseCounters& noise) {
  report.set("noise/clumps", noise.clumps);
  report.set("noise/clump_samples", noise.clump_samples);
  report.set("noise/largest_clump", noise.largest_clump);
  report.set("noise/outliers", noise.outliers);
  report.set("noise/outlier_rounds", noise.outlier_rounds);
  report.set("noise/spared_samples", noise.spared_samples);
  report.set("noise/large_cells", noise.large_cells);
  report.set("noise/outer_cells", noise.outer_cells);
  report.set("noise/inner_cells", noise.inner_cells);
  report.set("noise/leaked_cells", noise.leaked_cells);
  report.set("noise/held", noise.held);
  report.set("noise/skin_samples", noise.skin_samples);
  report.set("noise/good_samples", noise.good_samples);
  report.set("noise/layer_samples", noise.layer_samples);
}

SurfaceRemedies remedies_of_model() {
  return {.rho = false,
          .other =
              ", or make the model by cocoon reconstruct, which has --rho and --noise robust "
              "for it"};
}

void require_surface(Job& job, const std::string& file, const ReconstructResult& result,
                     Points points, const ReconstructOptions& options,
                     const SurfaceRemedies& remedies) {
  report_verification(job.report(), file, result.verification);
  if (result.status != SurfaceStatus::no_surface && result.status != SurfaceStatus::empty) return;
  const SampleDoubts doubts = sample_doubts(points, options, {}, job.execution());
  const double rho = options.boundary.rho;
  if (result.status == SurfaceStatus::no_surface) {
    throw InputError(
        fmt::format("{}: no surface: none of the {} samples lies well inside one: {}; {}{}", file,
                    result.vertices, ratios_said(doubts, rho, remedies),
                    samples_said(doubts, rho, remedies), remedies.other));
  }
  throw InputError(
      fmt::format("{}: no surface: nothing is left of {}; {} of {} samples count as boundary by "
                  "{} {:.3g}; {}{}",
                  file, counted(result.counters.candidates, "candidate triangle"),
                  result.counters.boundary_samples, result.vertices, name_of_rho(remedies), rho,
                  samples_said(doubts, rho, remedies), remedies.other));
}

}  // namespace cocoon::app
