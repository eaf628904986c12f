#include "app/arguments/thresholds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <type_traits>

#include "app/arguments/surface_options.h"
#include "app/command_line.h"
#include "geom/angles.h"

namespace cocoon::app {

namespace {

using enum ThresholdKind;
using enum ThresholdUse;
using Options = StageOptions;
using Field = Threshold::Field;

constexpr std::array<Threshold, 6> of_marking{{
    {"keep-angle", "Pruning: two triangles at an edge, flatter than this dihedral angle, stay", 0,
     180, angle, cocone, [](Options& o) -> Field { return &o.surface.prune.keep_cosine; }},
    {"fold-angle", "Marking: a dihedral angle of at most this makes both ends of an edge poor", 0,
     180, angle, tight, [](Options& o) -> Field { return &o.surface.good_vertices.fold_cosine; }},
    {"crease-angle", "Marking: one below this makes those ends poor that are boundary samples", 0,
     180, angle, tight, [](Options& o) -> Field { return &o.surface.good_vertices.crease_cosine; }},
    {"second-look-conflicts", "Second look: there is one if marks contradict each other more often",
     0, 4e9, whole, second_look,
     [](Options& o) -> Field { return &o.surface.second_look.max_conflicts; }},
    {"second-look-share", "Second look: and more often than this share of the samples", 0, 1,
     number, second_look,
     [](Options& o) -> Field { return &o.surface.second_look.max_conflict_share; }},
    {"second-look-poor", "Second look: not with more poor cells than this for each sample", 0, 1e9,
     number, second_look,
     [](Options& o) -> Field { return &o.surface.second_look.max_poor_per_sample; }},
}};

constexpr std::array<Threshold, 25> of_clean_up{{
    {"most-clump-cells", "Clean-up: more undecided cells together are left as they are", 0, 4e9,
     whole, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.most_clump_cells; }},
    {"most-clump-share", "Clean-up: and only if they are more than this share of all cells", 0, 1,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.most_clump_share; }},
    {"flat-ratio", "Clean-up: cells flatter than this share of their size are looked through", 0, 1,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.flat_ratio; }},
    {"thin-support", "Clean-up: doubt spreads to cells with so many good vertices at most", 0, 3,
     whole, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.thin_support; }},
    {"stretch-cost", "Clean-up: cost of a facet much longer than its samples lie apart", 0, 1000,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.stretch_cost; }},
    {"stretch-ratio", "Clean-up: facets longer than so many spacings cost more (--stretch-cost)", 0,
     1e6, number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.stretch_ratio; }},
    {"mark-weight", "Clean-up: cost of a decided cell that leaves its label", 0, 1000, number,
     clean_up, [](Options& o) -> Field { return &o.surface.clean_up.mark_weight; }},
    {"defect-cost", "Clean-up: cost of a non-manifold edge or a pinched vertex", 0, 1000, number,
     clean_up, [](Options& o) -> Field { return &o.surface.clean_up.defect_cost; }},
    {"unused-cost", "Clean-up: cost of a sample that is not on the surface", 0, 1000, number,
     clean_up, [](Options& o) -> Field { return &o.surface.clean_up.unused_cost; }},
    {"near-surface",
     "Clean-up: unused samples so many spacings off the surface are brought there by near cells "
     "alone; 0: by any",
     0, 1000, number, clean_up,
     [](Options& o) -> Field { return &o.surface.clean_up.near_surface; }},
    {"outlier-ratio", "Clean-up: unused samples so many times as far from others are not missed", 1,
     1e6, number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.outlier_ratio; }},
    {"handle-cost", "Clean-up: cost of a handle of the surface", 0, 1000, number, clean_up,
     [](Options& o) -> Field { return &o.surface.clean_up.handle_cost; }},
    {"idle-cost", "Clean-up: cost of an idle sample (--idle-ratio); 0: holes stay filled", 0, 1000,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.idle_cost; }},
    {"idle-flat-angle",
     "Clean-up: a sample is idle only if its facets lie in one plane, up to this angle", 0, 90,
     angle, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.idle.flat_cosine; }},
    {"idle-ratio", "Clean-up: and only if the circles of its facets have radii of so many spacings",
     0, 1000, number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.idle.ratio; }},
    {"deep-angle",
     "Clean-up: cells whose balls meet at most at this angle change sides as one cluster", 0, 180,
     angle, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.deep_cosine; }},
    {"deeper-angle", "Clean-up: the same for closer clusters, tried where those do not help", 0,
     180, angle, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.deeper_cosine; }},
    {"most-cluster-cells", "Clean-up: clusters and parts of more cells stay as they are", 0, 4e9,
     whole, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.most_cluster_cells; }},
    {"max-rise", "Clean-up: what the first of several moves may cost; 0: single moves only", 0, 1e6,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.max_rise; }},
    {"most-move-cells", "Clean-up: at samples with more cells no moves are looked for", 0, 4e9,
     whole, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.most_move_cells; }},
    {"max-openings", "Clean-up: so many first moves are tried at a sample", 1, 1e6, whole, clean_up,
     [](Options& o) -> Field { return &o.surface.clean_up.max_openings; }},
    {"max-closing-rise", "Clean-up: what closing a handle may cost in all other terms", 0, 1e6,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.max_closing_rise; }},
    {"most-handle-facets",
     "Clean-up: handles that more facets have to tell are not closed; 0: none is", 0, 4e9, whole,
     clean_up, [](Options& o) -> Field { return &o.surface.clean_up.most_handle_facets; }},
    {"most-closing-cells", "Clean-up: handles with more cells at their three samples are left", 0,
     4e9, whole, clean_up,
     [](Options& o) -> Field { return &o.surface.clean_up.most_closing_cells; }},
    {"component-cost",
     "Clean-up: cost of a part of the body; parts that cost less to lose are dropped", 0, 1e6,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.component_cost; }},
}};

constexpr std::array<Threshold, 5> of_evidence{{
    {"mark-credit", "Clean-up: weight of what few good vertices say of a doubtful cell", 0, 1,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.mark_credit; }},
    {"evidence-weight", "Clean-up: cost of a label against the evidence of the poles", 0, 1000,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.evidence_weight; }},
    {"near-pole-ratio",
     "Clean-up: a pole this many spacings off says nothing; at most --full-pole-ratio", 0, 1e6,
     number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.near_pole_ratio; }},
    {"full-pole-ratio", "Clean-up: a pole so many spacings off says all it can", 0, 1e6, number,
     clean_up, [](Options& o) -> Field { return &o.surface.clean_up.full_pole_ratio; }},
    {"pole-good-share", "Clean-up: so does one where this share of the samples around is good", 0,
     1, number, clean_up, [](Options& o) -> Field { return &o.surface.clean_up.pole_good_share; }},
}};

constexpr std::array<Threshold, 14> of_clouds_and_findings{{
    {"noise-neighbors", "Noise filter: edges that make the spacing of a sample", 1, 1000, whole,
     outliers, [](Options& o) -> Field { return &o.noise.neighbors; }},
    {"noise-outlier-ratio", "Noise filter: spacing of outliers, in spacings of their neighbors", 1,
     1e6, number, outliers, [](Options& o) -> Field { return &o.noise.outlier_ratio; }},
    {"noise-clump-link", "Noise filter: samples of a clump are so many spacings apart at most", 0,
     1e6, number, noise, [](Options& o) -> Field { return &o.noise.clump_link_ratio; }},
    {"noise-clump-share", "Noise filter: clumps are a smaller share of the samples; 0: they stay",
     0, 1, number, noise, [](Options& o) -> Field { return &o.noise.clump_share; }},
    {"noise-clump-depth", "Noise filter: samples of a clump so many links from good ones stay", 0,
     1000, whole, noise, [](Options& o) -> Field { return &o.noise.clump_depth; }},
    {"noise-large-ratio", "Noise filter: balls count as large if their radii are more spacings", 0,
     1e6, number, noise, [](Options& o) -> Field { return &o.noise.large_ratio; }},
    {"noise-deep-angle", "Noise filter: large balls on one side meet at this angle at most", 0, 180,
     angle, noise, [](Options& o) -> Field { return &o.noise.deep_cosine; }},
    {"noise-max-leak", "Noise filter: share of inner balls that infinity may reach; 1: all", 0, 1,
     number, noise, [](Options& o) -> Field { return &o.noise.max_leak; }},
    {"min-part-share", "Loops: parts with a smaller share of the triangles are debris", 0, 1,
     number, loops, [](Options& o) -> Field { return &o.loops.min_component_share; }},
    {"min-loop-edges", "Loops: those with fewer edges are pin-holes", 0, 4e9, whole, loops,
     [](Options& o) -> Field { return &o.loops.min_loop_edges; }},
    {"min-loop-perimeter", "Loops: shorter ones are pin-holes, in median edges of the surface", 0,
     1e6, number, loops, [](Options& o) -> Field { return &o.loops.min_perimeter_in_edges; }},
    {"gap-ratio", "Findings: edges so many times as long as others at a sample are a gap", 1, 1e6,
     number, findings, [](Options& o) -> Field { return &o.doubts.gap_ratio; }},
    {"dust-share", "Findings: dust has fewer triangles, as a share of the largest part", 0, 1,
     number, findings, [](Options& o) -> Field { return &o.doubts.fragment_share; }},
    {"max-spots", "Findings: places told of each kind", 1, 1000, whole, findings,
     [](Options& o) -> Field { return &o.doubts.max_spots; }},
}};

constexpr auto table = [] {
  std::array<Threshold, of_marking.size() + of_clean_up.size() + of_evidence.size() +
                            of_clouds_and_findings.size()>
      all;
  auto end = std::copy(of_marking.begin(), of_marking.end(), all.begin());
  end = std::copy(of_clean_up.begin(), of_clean_up.end(), end);
  end = std::copy(of_evidence.begin(), of_evidence.end(), end);
  std::copy(of_clouds_and_findings.begin(), of_clouds_and_findings.end(), end);
  return all;
}();

double value_of(Field field) {
  return std::visit([](const auto* value) { return static_cast<double>(*value); }, field);
}

void set_value(Field field, double value) {
  std::visit([&](auto* here) { *here = static_cast<std::remove_pointer_t<decltype(here)>>(value); },
             field);
}

}  // namespace

std::span<const Threshold> thresholds() { return table; }

std::vector<std::string> given_thresholds(ThresholdUse use,
                                          const std::map<std::string, double>& given) {
  std::vector<std::string> names;
  for (const Threshold& t : table) {
    if (t.use == use && given.contains(t.name)) names.push_back(std::string("--") + t.name);
  }
  return names;
}

void append_given(ThresholdUse use, const std::map<std::string, double>& given,
                  std::vector<std::string>& options) {
  const std::vector<std::string> of_use = given_thresholds(use, given);
  options.insert(options.end(), of_use.begin(), of_use.end());
}

void set_thresholds(StageOptions& options, const std::map<std::string, double>& given) {
  for (const Threshold& t : table) {
    const auto found = given.find(t.name);
    if (found == given.end()) continue;
    const double value = found->second;
    set_value(t.field(options), t.kind == angle ? std::cos(value * radians_per_degree) : value);
  }
}

void require_order(const StageOptions& options) {
  const CleanUpOptions& clean_up = options.surface.clean_up;
  if (clean_up.near_pole_ratio > clean_up.full_pole_ratio) {
    throw UsageError(fmt::format(
        "--near-pole-ratio ({}) is above --full-pole-ratio ({}); lower it, or raise the other",
        clean_up.near_pole_ratio, clean_up.full_pole_ratio));
  }
}

double told_value(const Threshold& threshold, StageOptions options) {
  const double value = value_of(threshold.field(options));
  return threshold.kind == angle ? told_in_degrees(std::acos(value)) : value;
}

void add_thresholds(JsonReport& report, ThresholdUse use, StageOptions options) {
  for (const Threshold& t : table) {
    if (t.use != use) continue;
    std::string key = std::string("parameters/") + t.name + (t.kind == angle ? "_deg" : "");
    std::replace(key.begin(), key.end(), '-', '_');
    const double value = told_value(t, options);
    if (t.kind == whole) {
      report.set(key, static_cast<std::size_t>(value));
    } else {
      report.set(key, value);
    }
  }
}

}  // namespace cocoon::app
