#include "update/stage_options.h"

#include <limits>
#include <numbers>

#include "cocone/inputs/stage_inputs.h"
#include "geom/messages/require_number.h"
#include "update/checks/dense_trial.h"
#include "update/checks/lost_surface.h"
#include "update/checks/lost_triangles.h"
#include "update/checks/made_up_surface.h"
#include "update/model/orient_outward.h"
#include "update/stray_samples.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

void require_search(const char* stage, const RimSearch& search) {
  require_amounts(stage, {{"rho of a rim search", search.rho}});
  require_cosines(stage, {{"alpha_cosine of a rim search", search.alpha_cosine}});
}

}  // namespace

void require_options(const char* stage, const AngleOptions& options) {
  require_shares(stage, {{"angles.min_relative_height", options.min_relative_height}});
}

void require_options(const char* stage, const AstrayOptions& options) {
  require_amounts(stage, {{"astray.tolerance", options.tolerance},
                          {"astray.most_spacings", options.most_spacings},
                          {"astray.reach", options.reach},
                          {"astray.coarse_ratio", options.coarse_ratio}});
  require_number(stage, "astray.most_parts", static_cast<double>(options.most_parts), 1, 100);
  require_shares(stage, {{"astray.min_extent_share", options.min_extent_share}});
}

void require_options(const char* stage, const ChoiceOptions& options) {
  require_shares(stage, {{"choice.min_edge_share", options.min_edge_share}});
  require_number(stage, "choice.ambiguous_margin", options.ambiguous_margin, 0, std::numbers::pi);
  require_number(stage, "choice.narrow_margin", options.narrow_margin, 0, std::numbers::pi);
  require_number(stage, "choice.turned_away", options.turned_away, 0, std::numbers::pi);
  require_number(stage, "choice.sure_margin", options.sure_margin, 0, std::numbers::pi);
}

void require_options(const char* stage, const ClosedOpeningOptions& options) {
  require_amounts(stage, {{"openings.reach", options.reach}});
}

void require_options(const char* stage, const CloudSurfaceOptions& options) {
  require_amounts(stage, {{"cloud.stretch_weight", options.stretch_weight},
                          {"cloud.rows.min_ratio", options.rows.min_ratio},
                          {"cloud.rows.spread", options.rows.spread},
                          {"cloud.density.min_ratio", options.density.min_ratio},
                          {"cloud.density.spread", options.density.spread},
                          {"cloud.density.max_stretch", options.density.max_stretch},
                          {"cloud.layers.spread", options.layers.spread}});
  for (const double times : options.layers.when_refused) {
    require_number(stage, "cloud.layers.when_refused", times, 0.1, 10);
  }
  require_shares(stage, {{"cloud.max_seam_share", options.max_seam_share},
                         {"cloud.rows.min_share", options.rows.min_share},
                         {"cloud.rows.quantile", options.rows.quantile},
                         {"cloud.layers.max_seam_share", options.layers.max_seam_share}});
  require_options(stage, options.trim);
  require_options(stage, options.rim);
  require_options(stage, options.seams);
  require_search(stage, options.start);
  for (const RimSearch& search : options.finer) require_search(stage, search);
  for (const RimSearch& search : options.coarser) require_search(stage, search);
}

void require_options(const char* stage, const ContradictedOptions& options) {
  require_amounts(stage, {{"contradicted.reach", options.reach}});
  require_shares(stage, {{"contradicted.min_share", options.min_share}});
}

void require_options(const char* stage, const CutOptions& options) {
  require_amounts(stage, {{"cut.max_detour", options.max_detour},
                          {"cut.seed_reach", options.seed_reach},
                          {"cut.max_doubt", options.max_doubt},
                          {"cut.clear_doubt", options.clear_doubt},
                          {"cut.high_doubt", options.high_doubt},
                          {"cut.clearer_rim", options.clearer_rim},
                          {"cut.min_told", options.min_told},
                          {"cut.box_reach", options.box_reach}});
  require_shares(stage, {{"cut.clear_seam_share", options.clear_seam_share}});
  require_options(stage, options.ends);
  require_options(stage, options.disproved);
  require_options(stage, options.moved);
}

void require_options(const char* stage, const UnconfirmedOptions& options) {
  require_amounts(stage, {{"cut.moved.unconfirmed.reach", options.reach},
                          {"cut.moved.unconfirmed.height", options.height},
                          {"cut.moved.unconfirmed.near", options.near}});
}

void require_options(const char* stage, const LostSurfaceOptions& options) {
  require_shares(stage, {{"lost.min_area_share", options.min_area_share},
                         {"lost.min_coarse_share", options.min_coarse_share}});
  require_options(stage, options.astray);
}

void require_options(const char* stage, const MadeUpOptions& options) {
  require_amounts(stage, {{"made_up.distance", options.distance}});
}

void require_options(const char* stage, const MovedCutOptions& options) {
  require_amounts(stage, {{"cut.moved.reach", options.reach},
                          {"cut.moved.unconfirmed_cost", options.unconfirmed_cost}});
  require_options(stage, options.unconfirmed);
}

void require_options(const char* stage, const GapOptions& options) {
  require_amounts(stage, {{"gaps.reach", options.reach}, {"gaps.off_model", options.off_model}});
}

void require_options(const char* stage, const HandleOptions& options) {
  require_amounts(stage, {{"handles.wide", options.wide}});
}

void require_options(const char* stage, const SightOptions& options) {
  require_amounts(stage, {{"sight.clearance", options.clearance}, {"sight.step", options.step}});
}

void require_options(const char* stage, const DenseTrialOptions& options) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  require_shares(stage,
                 {{"dense_trial.min_large_share", options.min_large_share},
                  {"dense_trial.min_large_share_if_refused", options.min_large_share_if_refused}});
  require_number(stage, "dense_trial.neighbor", static_cast<double>(options.neighbor), 1, infinity);
  require_amounts(stage, {{"dense_trial.neighbor_share", options.neighbor_share}});
  require_number(stage, "dense_trial.most_samples", options.most_samples, 1, infinity);
  require_number(stage, "dense_trial.max_given_up", options.max_given_up, -1, infinity);
  require_options(stage, options.lost);
}

void require_options(const char* stage, const DisprovedOptions& options) {
  require_amounts(stage, {{"cut.disproved.off_model", options.off_model},
                          {"cut.disproved.reach", options.reach},
                          {"cut.disproved.scanned", options.scanned},
                          {"cut.disproved.shelter", options.shelter},
                          {"cut.disproved.apart", options.apart},
                          {"cut.disproved.island_reach", options.island_reach}});
  require_number(stage, "cut.disproved.step", options.step, 0.01, 10);
  require_shares(stage, {{"cut.disproved.island_share", options.island_share}});
  require_cosines(stage, {{"cut.disproved.min_side_cosine", options.min_side_cosine},
                          {"cut.disproved.min_cosine", options.min_cosine},
                          {"cut.disproved.min_presumed_cosine", options.min_presumed_cosine}});
}

void require_options(const char* stage, const IslandOptions& options) {
  require_amounts(stage, {{"islands.off_model", options.off_model},
                          {"islands.min_share", options.min_share},
                          {"islands.reach", options.reach},
                          {"islands.facing_reach", options.facing_reach}});
  require_cosines(stage, {{"islands.min_normal_cosine", options.min_normal_cosine}});
}

void require_options(const char* stage, const JoinOptions& options) {
  require_amounts(stage, {{"join.reach", options.reach},
                          {"join.thinning", options.thinning},
                          {"join.coarser", options.coarser}});
  require_shares(stage, {{"join.min_share", options.min_share},
                         {"join.min_covered_share", options.min_covered_share}});
}

void require_options(const char* stage, const OrientOutwardOptions& options) {
  require_amounts(stage, {{"max_opening", options.max_opening}});
}

void require_options(const char* stage, const OutwardOptions& options) {
  require_amounts(stage, {{"outward.min_agreement", options.min_agreement}});
  require_shares(stage, {{"outward.min_part_cosine", options.min_part_cosine},
                         {"outward.min_view_cosine", options.min_view_cosine}});
}

void require_options(const char* stage, const OverlapOptions& options) {
  require_amounts(stage, {{"overlap.max_distance", options.max_distance},
                          {"overlap.facing_preference", options.facing_preference},
                          {"overlap.raised_distance", options.raised_distance},
                          {"overlap.step_distance", options.step_distance}});
  require_shares(stage, {{"overlap.max_unmatched_share", options.max_unmatched_share},
                         {"overlap.max_raised_share", options.max_raised_share},
                         {"overlap.max_raised_outline", options.max_raised_outline}});
  require_cosines(stage, {{"overlap.min_normal_cosine", options.min_normal_cosine}});
}

void require_options(const char* stage, const OverlookedOptions& options) {
  require_amounts(stage, {{"overlooked.reach", options.reach},
                          {"overlooked.min_rim_distance", options.min_rim_distance},
                          {"overlooked.max_kept_share", options.max_kept_share}});
}

void require_options(const char* stage, const UnchangedRestOptions& options) {
  require_amounts(stage, {{"unchanged.reach", options.reach},
                          {"unchanged.around", options.around},
                          {"unchanged.height", options.height}});
}

void require_options(const char* stage, const PinHoleOptions& options) {
  require_amounts(stage, {{"pin_holes.max_distance", options.max_distance},
                          {"pin_holes.min_beyond", options.min_beyond}});
}

void require_options(const char* stage, const ReplaceOptions& options) {
  require_amounts(stage, {{"replace.thinning_distance", options.thinning_distance},
                          {"replace.scanned.rim_zone", options.scanned.rim_zone},
                          {"replace.scanned.sample_reach", options.scanned.sample_reach},
                          {"replace.scanned.cloud_reach", options.scanned.cloud_reach},
                          {"replace.scanned.outer_reach", options.scanned.outer_reach},
                          {"replace.scanned.depth_weight", options.scanned.depth_weight}});
}

void require_options(const char* stage, const RimOptions& options) {
  require_amounts(stage, {{"cloud.rim.min_outline_share", options.min_outline_share}});
  require_options(stage, options.loops);
}

void require_options(const char* stage, const RimSeamOptions& options) {
  require_amounts(stage, {{"cloud.seams.reach", options.reach},
                          {"cloud.seams.few_reach", options.few_reach},
                          {"cloud.seams.min_rim_length", options.min_rim_length}});
  require_shares(stage, {{"cloud.seams.max_seam_share", options.max_seam_share}});
}

void require_options(const char* stage, const SampledRegionOptions& options) {
  require_number(stage, "sampled.reach", options.reach, 0, std::numeric_limits<double>::max());
  require_shares(stage, {{"sampled.min_share", options.min_share},
                         {"sampled.max_outside_share", options.max_outside_share}});
}

void require_options(const char* stage, const ScanEndOptions& options) {
  require_amounts(stage, {{"cut.ends.scanned", options.scanned},
                          {"cut.ends.off_model", options.off_model},
                          {"cut.ends.change_reach", options.change_reach}});
}

void require_options(const char* stage, const ShadowOptions& options) {
  require_amounts(stage, {{"shadow.max_distance", options.max_distance}});
  require_shares(stage, {{"shadow.max_unmatched_share", options.max_unmatched_share}});
}

void require_options(const char* stage, const SharedEdgeOptions& options) {
  require_amounts(stage, {{"shared.reach", options.reach}});
}

void require_options(const char* stage, const ShiftOptions& options) {
  require_amounts(stage, {{"shift.max_residual", options.max_residual},
                          {"shift.prior", options.prior},
                          {"shift.max_shift", options.max_shift},
                          {"shift.fit_distance", options.fit_distance}});
  require_shares(stage, {{"shift.min_share", options.min_share}});
}

void require_options(const char* stage, const StrayOptions& options) {
  require_amounts(stage, {{"stray.outlier_ratio", options.outlier_ratio},
                          {"stray.link_ratio", options.link_ratio}});
  require_neighbors(stage, options.neighbors);
}

void require_options(const char* stage, const TrimOptions& options) {
  require_amounts(stage, {{"cloud.trim.max_edge", options.max_edge}});
}

void require_options(const char* stage, const UnscannedOptions& options) {
  require_amounts(stage, {{"unscanned.reach", options.reach},
                          {"unscanned.off_model", options.off_model},
                          {"unscanned.change_reach", options.change_reach}});
  require_shares(stage, {{"unscanned.explained", options.explained},
                         {"unscanned.max_explained_share", options.max_explained_share}});
}

void require_options(const char* stage, const CrowdedOptions& options) {
  require_amounts(stage, {{"crowded.distance", options.distance},
                          {"crowded.min_thickness", options.min_thickness},
                          {"crowded.max_coarseness", options.max_coarseness},
                          {"crowded.max_width", options.max_width}});
  require_shares(stage, {{"crowded.min_share", options.min_share},
                         {"crowded.max_lost_share", options.max_lost_share}});
}

void require_options(const char* stage, const UnusedChangeOptions& options) {
  require_amounts(stage, {{"unused_changes.off_model", options.off_model},
                          {"unused_changes.reach", options.reach}});
  require_shares(stage, {{"unused_changes.min_share", options.min_share}});
}

void require_options(const char* stage, const WallEdgeOptions& options) {
  require_amounts(stage, {{"walls.reach", options.reach},
                          {"walls.max_inward", options.max_inward},
                          {"walls.min_step", options.min_step},
                          {"walls.off_model", options.off_model},
                          {"walls.thinnest", options.thinnest},
                          {"walls.thickest", options.thickest}});
  require_cosines(stage, {{"walls.min_way_cosine", options.min_way_cosine},
                          {"walls.min_normal_cosine", options.min_normal_cosine}});
}

void require_options(const char* stage, const UpdateOptions& options) {
  require_options(stage, options.reconstruct);
  require_options(stage, options.cloud.reconstruct);
  require_options(stage, options.join);
  require_options(stage, options.cloud);
  require_options(stage, options.pin_holes);
  require_options(stage, options.walls);
  require_options(stage, options.overlap);
  require_options(stage, options.shadow);
  require_options(stage, options.shared);
  require_options(stage, options.outward);
  require_options(stage, options.cut);
  require_options(stage, options.angles);
  require_options(stage, options.choice);
  require_options(stage, options.sampled);
  require_options(stage, options.islands);
  require_options(stage, options.sight);
  require_options(stage, options.replace);
  require_options(stage, options.overlooked);
  require_options(stage, options.unchanged);
  require_options(stage, options.unscanned);
  require_options(stage, options.unused_changes);
  require_options(stage, options.contradicted);
  require_options(stage, options.openings);
  require_options(stage, options.gaps);
  require_options(stage, options.handles);
  require_options(stage, options.crowded);
  require_options(stage, options.shift);
}

}  // namespace cocoon
