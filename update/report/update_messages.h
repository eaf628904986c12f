// What an update says in words: reasons and warnings, one line each.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "update/checks/bridged_gaps.h"
#include "update/checks/closed_openings.h"
#include "update/checks/contradicted_samples.h"
#include "update/checks/crowded_samples.h"
#include "update/checks/loose_parts.h"
#include "update/checks/overlooked_vertices.h"
#include "update/checks/rim_shift.h"
#include "update/checks/unscanned_losses.h"
#include "update/checks/unused_changes.h"
#include "update/cloud_surface.h"
#include "update/cut_regions.h"
#include "update/overlapping_facets.h"
#include "update/report/cloud_report.h"

namespace cocoon {

// In what advises to choose among groups (reason_of_ambiguity, reason_of_turned_away,
// warnings_of_cut): a program may add how.
inline constexpr std::string_view advice_of_groups = "say which group goes";

// "cloud 2 of 3", "cloud 1 of 5 (with cloud 2 of 5 and cloud 4 of 5)"; `members`: at least one,
// ascending, from 0.
std::string name_of_clouds(std::span<const std::size_t> members, std::size_t clouds);
// "rho 0.3 and alpha 30 degrees"
std::string name_of_limits(double rho, double alpha_cosine);
// Behind why a cloud has no surface or no rim: "; only rho 0.3 and alpha 30 degrees were tried,
// ...", if it was so.
std::string hint_of_only_trial(const CloudSurfaceOptions& options);
// "loop of 31 edges at (0, 1, 2)".
std::string name_of_loop(const RimLoop& loop);

// Why there is no rim.
std::string reason_of_closed_cloud(const CloudRim& rim);
// Why the rim is not on the model; `boundary_points`: of all its loops; `unit_factor`: by which it
// would be, see unit_factor().
std::string reason_of_no_overlap(std::size_t unmatched, std::size_t boundary_points,
                                 double max_distance, double rim_spacing,
                                 std::optional<double> unit_factor = {});
// Why a loop does not lie on one part of the model.
std::string reason_of_open_band(std::size_t max_search_facets);
// Why what is left of a partial rim does not tell its sides apart.
std::string reason_of_doubtful_cut(const RegionCut& cut);
// Why a handle across a whole rim is not cut.
std::string reason_of_wide_handle();
// Why the angles do not decide; `margin`: in degrees.
// `groups`: those of which people may say which goes; empty: of none.
std::string reason_of_ambiguity(double margin, std::span<const RegionVerdict> groups);
// Likewise, where no side of the rim lies under the cloud by its angle, and samples do not tell.
std::string reason_of_turned_away(std::span<const RegionVerdict> groups);
// Why nothing is left of the updated points.
std::string reason_of_empty_surface(std::size_t updated_points);
// If all of them are boundary samples.
std::string hint_of_limits(const BoundaryOptions& limits);

// Of a loop.
std::string warning_of_handle_across_rim();
std::vector<std::string> warnings_of_cut(const RegionCut& cut, const CutOptions& options);
// Only if its doubt is more than options.clear_doubt, and no warning up to options.high_doubt.
std::vector<std::string> notes_of_cut(const RegionCut& cut, const CutOptions& options = {});
// Clouds that overlap each other, but not as one surface; `why`: the reason.
std::string warning_of_clouds_apart(const std::string& why);
// `clouds`: the names of those in layers; `why` the rims of all samples were refused.
std::string warning_of_few_samples(const std::string& clouds, const std::string& why);
// Where the rims of few are refused, too.
std::string hint_of_layers(const std::string& clouds);
// Regions under more than one cloud.
std::string warning_of_shared_regions(std::size_t regions);
// Mean angles of regions, in degrees, that hardly differ.
std::string warning_of_narrow_margin(double degrees);
// Of a cloud whose samples tell which group goes, or else angles that differ much.
std::string warning_of_turned_away(const CloudReport& cloud);
// Of the doubtful; `at`: one of them; `replaced`: how many of those that are overlooked go.
std::string warning_of_overlooked(const OverlookedVertices& vertices, const Point& at,
                                  const OverlookedOptions& options = {}, std::size_t replaced = 0);
std::string warning_of_unused_changes(const UnusedChanges& changes);
// `reach`: GapOptions::reach.
std::string warning_of_gaps(const BridgedGaps& gaps, double reach);
std::string warning_of_contradicted(const ContradictedSamples& samples);
// `before`, `after`: handles and parts that nothing explains, with these samples and without.
std::string warning_of_left_out(const CrowdedSamples& crowded, std::size_t before,
                                std::size_t after);
// More than the rims explain.
std::string warning_of_handles(std::size_t handles);
// `at`: the place of the vertex that they name, in the updated mesh and in the model.
std::string warning_of_loose_parts(const LooseParts& parts, const Point& at);
std::string warning_of_openings(const ClosedOpenings& openings, const Point& at);
// `at`: the place of the farthest vertex; `reach`: UnscannedOptions::reach.
std::string warning_of_unscanned(const UnscannedLosses& losses, double reach, const Point& at);
// What may be wrong with a cloud, or where it lies on the model.
std::vector<std::string> warnings_of_cloud(const CloudReport& cloud, const OverlapOptions& options,
                                           const ShiftOptions& shift);
// What is unusual about its surface and its place on the model, but no reason to worry: half of all
// good updates have some.
std::vector<std::string> notes_of_cloud(const CloudReport& cloud);
// Of a loop that is no border but lies on other clouds, or along a seam; `at_others`: its cloud
// reaches other ones.
std::string warning_of_loop(bool at_others);
// Of a loop that encloses nothing.
std::string warning_of_nothing_inside();

}  // namespace cocoon
