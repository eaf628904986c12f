#include "update/steps/choose_replaced.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "geom/angles.h"
#include "geom/arrays/sort_ids.h"
#include "update/report/update_messages.h"

namespace cocoon {

namespace {

// What tells which sides of a cloud's rim lie under it.
enum class ToldBy : std::uint8_t { rim, samples, sure_angles };

// Where both sides of a rim turn away from the cloud, by the choice so far, samples tell, or else
// the angles if they differ much. Returns of each cloud what told; run.decided has what.
std::vector<ToldBy> tell_sides(UpdateRun& run, std::span<const RegionAngles> angles,
                               const Execution& execution) {
  const std::vector<Scan> scans = run.scans();
  std::vector<ToldBy> told_by(run.clouds.size(), ToldBy::rim);
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    const CloudChoice& cloud = run.result.choice.clouds[c];
    if (cloud.turned_away.empty()) continue;
    IdVector<RegionId, std::uint8_t> under =
        regions_under_samples(*run.index, run.result.regions, cloud.turned_away, scans[c],
                              run.options.sampled, execution);
    const bool by_samples = !under.empty();
    if (!by_samples) under = under_by_sure_angles(angles, run.clouds.size(), c, run.options.choice);
    if (under.empty()) continue;
    told_by[c] = by_samples ? ToldBy::samples : ToldBy::sure_angles;
    for (const RegionVerdict& verdict : cloud.regions) {
      const bool was_asked =
          std::binary_search(cloud.turned_away.begin(), cloud.turned_away.end(), verdict.region);
      if (!was_asked && verdict.under_cloud) under[verdict.region] = 1;
    }
    run.decided.resize(run.clouds.size());
    run.decided[c] = std::move(under);
  }
  return told_by;
}

// Of the one region that is kept since all would go.
void say_kept_largest(RegionChoice& choice) {
  if (choice.kept_largest.is_none()) return;
  for (CloudChoice& cloud : choice.clouds) {
    for (RegionVerdict& verdict : cloud.regions) {
      if (verdict.region == choice.kept_largest) verdict.under_cloud = false;
    }
  }
}

// Has contradicted islands go.
void take_islands(UpdateRun& run) {
  RegionChoice& choice = run.result.choice;
  if (choice.status != ChoiceStatus::ok) return;
  const std::vector<ContradictedIsland> islands = part_contradicted_islands(
      *run.index, choice, run.scans(), run.result.regions, run.options.islands, run.outward());
  choice.replaced.resize(run.result.regions.regions.size(), 0);
  for (const ContradictedIsland& island : islands) {
    run.result.islands.push_back(island.part);
    choose_island(island, choice);
  }
  make_set(run.result.islands);
}

// An ambiguous choice of joined clouds ends in a second attempt, with each by itself: the numbers
// that people know are of that.
void take_overrides(UpdateRun& run) {
  RegionChoice& choice = run.result.choice;
  if (run.are_joined() && choice.status == ChoiceStatus::ambiguous) return;
  override_choice(run.options.overrides, choice, run.result.islands);
  std::erase_if(run.result.islands, [&](RegionId r) { return choice.replaced[r] == 0; });
}

void report_choice_of_cloud(UpdateRun& run, std::size_t c, ToldBy told_by) {
  const UpdateOptions& options = run.options;
  CloudReport& report = run.result.clouds[c];
  enter_choice(run.result.choice.clouds[c], report);
  const bool is_said = std::any_of(
      report.groups.begin(), report.groups.end(),
      [&](const RegionVerdict& group) { return options.overrides.names(group.region); });
  if (is_said) return;
  report.is_told_by_samples = told_by == ToldBy::samples;
  report.is_told_by_sure_angles = told_by == ToldBy::sure_angles;
  if (told_by != ToldBy::rim) {
    run.warn(run.name_of_cloud(c) + ": " + warning_of_turned_away(report));
  } else if (run.result.choice.clouds[c].margin < options.choice.narrow_margin) {
    run.warn(run.name_of_cloud(c) + ": " + warning_of_narrow_margin(report.margin_deg));
  }
}

void report_replaced_groups(UpdateRun& run) {
  const RegionChoice& choice = run.result.choice;
  std::size_t seen_by_several = 0;
  std::vector<std::size_t> clouds_over(choice.replaced.size(), 0);
  for (const CloudReport& report : run.result.clouds) {
    for (const RegionId r : report.replaced_groups) {
      if (++clouds_over[r.index()] == 2) ++seen_by_several;
    }
  }
  for (const RegionId r : choice.replaced.ids()) {
    if (choice.replaced[r] != 0) run.result.replaced_groups.push_back(r);
  }
  if (seen_by_several > 0) run.warn(warning_of_shared_regions(seen_by_several));
  if (!choice.kept_largest.is_none()) {
    run.warn("all regions lie under clouds; the one with the largest angle is kept");
  }
}

bool fail_ambiguous(UpdateRun& run) {
  const std::vector<CloudChoice>& clouds = run.result.choice.clouds;
  const bool are_joined = run.are_joined();
  const auto undecided = std::find_if(clouds.begin(), clouds.end(), [&](const CloudChoice& cloud) {
    return cloud.is_ambiguous && (are_joined || !run.options.overrides.decides(cloud));
  });
  const auto c = static_cast<std::size_t>(undecided - clouds.begin());
  const std::span<const RegionVerdict> groups =
      are_joined ? std::span<const RegionVerdict>() : run.result.clouds[c].groups;
  const double margin_deg = run.options.choice.ambiguous_margin * degrees_per_radian;
  return run.fail(UpdateStatus::ambiguous,
                  run.name_of_cloud(c) + ": " +
                      (undecided->turned_away.empty() ? reason_of_ambiguity(margin_deg, groups)
                                                      : reason_of_turned_away(groups)));
}

}  // namespace

bool choose_replaced(UpdateRun& run, std::span<const RegionAngles> angles,
                     const Execution& execution) {
  RegionChoice& choice = run.result.choice;
  const auto choose = [&] {
    choice = choose_regions(angles, run.clouds.size(), run.options.choice, run.decided);
  };
  choose();
  const std::vector<ToldBy> told_by = tell_sides(run, angles, execution);
  const bool are_told =
      std::any_of(told_by.begin(), told_by.end(), [](ToldBy by) { return by != ToldBy::rim; });
  if (are_told) choose();
  // Regions may be without any loop (all rims covered): then there is nothing to replace.
  choice.replaced.resize(run.result.regions.regions.size(), 0);
  take_islands(run);
  take_overrides(run);
  say_kept_largest(choice);
  for (std::size_t c = 0; c < run.clouds.size(); ++c) report_choice_of_cloud(run, c, told_by[c]);
  report_replaced_groups(run);
  return choice.status == ChoiceStatus::ok || fail_ambiguous(run);
}

}  // namespace cocoon
