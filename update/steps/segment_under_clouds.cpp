#include "update/steps/segment_under_clouds.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "update/regions/loop_sides.h"
#include "update/report/update_messages.h"
#include "update/scan_ends.h"
#include "update/steps/detect_boundaries.h"
#include "update/steps/find_overlap.h"

namespace cocoon {

namespace {

Separation separation_in(const UpdateRun& run, std::size_t c, std::size_t l,
                         const Regions& regions) {
  return loop_sides(run.model, run.index->neighbors(), run.borders[c].loops[l], regions).separation;
}

// By the whole borders of all clouds, segmented once until they are taken, or traced anew.
const Regions& whole_regions(UpdateRun& run, const Execution& execution) {
  if (!run.whole_regions) {
    run.whole_regions =
        segment_model(*run.index, run.border_facets, run.options.segment, execution);
  }
  return *run.whole_regions;
}

// Takes them as those of the result.
void take_whole_regions(UpdateRun& run, const Execution& execution) {
  whole_regions(run, execution);
  run.result.regions = *std::exchange(run.whole_regions, {});
}

bool is_any_cut(const UpdateRun& run) {
  return std::find(run.is_cut.begin(), run.is_cut.end(), 1) != run.is_cut.end();
}

// A pin-hole that does not cut the model in two, by itself or with other loops, is none of the
// border. False if a cloud has no rim but for such ones.
bool close_pin_holes(UpdateRun& run, const Execution& execution) {
  bool closed = false;
  run.for_each_border_loop([&](std::size_t c, std::size_t l) {
    if (!run.result.clouds[c].loops[l].pin_hole) return;
    if (separation_in(run, c, l, whole_regions(run, execution)) == Separation::separates) {
      return run.warn(
          run.name_of_loop(c, l) +
          ": the model goes on through this small hole of the scan; what is beyond stays");
    }
    run.rims.overlaps[c].loops[l].match = run.result.clouds[c].loops[l].match =
        LoopMatch::off_model;
    closed = true;
  });
  if (!closed) return true;
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    const bool has_rim = run.result.clouds[c].surface.status == CloudStatus::ok;
    if (!has_rim && !run.rims.overlaps[c].is_border()) return fail_without_rim(run, c);
  }
  trace_borders(run, execution);
  return true;
}

// Whether the whole loops of cloud c separate, all regions at them turn away from it, and its
// samples tell which of these lie under it.
bool samples_tell_of_whole_rim(const UpdateRun& run, std::size_t c, const Regions& whole,
                               const CloudChoice& choice, const Execution& execution) {
  bool separates = true;
  run.for_each_border_loop([&](std::size_t of, std::size_t l) {
    if (of == c) separates &= separation_in(run, c, l, whole) == Separation::separates;
  });
  const bool all_turned =
      !choice.turned_away.empty() && choice.turned_away.size() == choice.regions.size();
  const std::vector<Scan> scans = run.scans();
  return separates && all_turned &&
         !regions_under_samples(*run.index, whole, choice.turned_away, scans[c],
                                run.options.sampled, execution)
              .empty();
}

// Whether there are cuts, none of them is clear, and all are of single clouds, of which
// samples_tell_of_whole_rim().
bool needs_no_cut(UpdateRun& run, const std::vector<std::size_t>& joined,
                  std::span<const RegionCut> cuts, const Execution& execution) {
  if (!is_any_cut(run)) return false;
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    if (run.is_cut[c] == 0) continue;
    const bool is_single = std::count(joined.begin(), joined.end(), joined[c]) == 1;
    if (!is_single || cuts[c].doubt() <= run.options.cut.clear_doubt) return false;
  }
  const Regions& whole = whole_regions(run, execution);
  const RegionChoice choice =
      choose_regions(run.measure_angles(whole), run.clouds.size(), run.options.choice);
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    if (run.is_cut[c] == 0) continue;
    if (!samples_tell_of_whole_rim(run, c, whole, choice.clouds[c], execution)) return false;
  }
  return true;
}

// Why the cut of these clouds, which are joined, is not to be believed.
std::optional<std::string> why_not_cut(const UpdateRun& run, std::span<const std::size_t> clouds,
                                       const RegionCut& cut) {
  const CutOptions& options = run.options.cut;
  const bool is_around_handle = std::any_of(clouds.begin(), clouds.end(), [&](std::size_t c) {
    return runs_around_handle(run.result.clouds[c]);
  });
  if (is_around_handle) {
    const std::vector<Scan> all = run.scans();
    std::vector<Scan> scans;
    for (const std::size_t c : clouds) scans.push_back(all[c]);
    const bool is_far = reaches_beyond(*run.index, members(cut.under), scans, options.box_reach);
    if (is_far || cut.doubt() > options.max_doubt) return reason_of_wide_handle();
  } else if (cut.doubt() > options.max_doubt) {
    return reason_of_doubtful_cut(cut);
  }
  return {};
}

std::vector<std::size_t> clouds_joined_to(std::size_t lowest, std::span<const std::size_t> joined) {
  std::vector<std::size_t> clouds;
  for (std::size_t c = 0; c < joined.size(); ++c) {
    if (joined[c] == lowest) clouds.push_back(c);
  }
  return clouds;
}

// Where clouds are cut: takes regions that lie as a whole under each such cloud, or outside. None
// is cut if needs_no_cut().
bool segment(UpdateRun& run, const std::vector<std::size_t>& joined, const Execution& execution) {
  if (!is_any_cut(run)) {
    run.decided.clear();
    take_whole_regions(run, execution);
    return true;
  }
  std::vector<CloudReport>& reports = run.result.clouds;
  const std::vector<CloudRim> rims = border_rims_of(reports);
  const std::vector<Scan> scans = run.scans();
  CutRegions cut =
      cut_regions(*run.index, {rims, run.borders, scans, joined, run.is_cut, run.outward()},
                  run.options.cut, run.options.segment, execution);
  run.is_cut = std::move(cut.is_cut);
  if (needs_no_cut(run, joined, cut.cuts, execution)) {
    run.is_cut.assign(run.clouds.size(), 0);
    for (CloudReport& cloud : reports) cloud.cut = {};
    return segment(run, joined, execution);
  }
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    if (run.is_cut[c] == 0 || joined[c] != c) continue;
    const std::optional<std::string> why =
        why_not_cut(run, clouds_joined_to(c, joined), cut.cuts[c]);
    cut.cuts[c].under = {};
    reports[c].cut = std::move(cut.cuts[c]);
    if (why) {
      take_whole_regions(run, execution);
      return run.fail(UpdateStatus::non_separating, run.name_of_cloud(c) + ": " + *why);
    }
  }
  run.result.regions = std::move(cut.regions);
  run.decided = std::move(cut.under);
  return true;
}

// Whether a rim, though whole, runs around a handle: then the cloud is to be cut, too.
bool cut_across_handles(UpdateRun& run) {
  const std::vector<std::uint8_t> before = run.is_cut;
  run.for_each_border_loop([&](std::size_t c, std::size_t l) {
    if (run.result.clouds[c].loops[l].separation == Separation::non_separating) run.is_cut[c] = 1;
  });
  return run.is_cut != before;
}

// Whether a scan ends on the model in regions that would go: then its rim is not all there, and the
// cloud is to be cut.
bool cut_where_scans_end(UpdateRun& run, std::span<const RegionAngles> angles) {
  const RegionChoice choice =
      choose_regions(angles, run.clouds.size(), run.options.choice, run.decided);
  const std::vector<Scan> scans = run.scans();
  bool found = false;
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    if (run.is_cut[c] != 0 || !scan_ends_under(*run.index, run.result.regions, choice.clouds[c],
                                               scans[c], run.options.cut.ends)) {
      continue;
    }
    run.is_cut[c] = 1;
    found = true;
  }
  return found;
}

// False if a loop has not cut the model in two.
// `angles`: of each border loop. One whose band has no region inside may see that of another
// band, which begins where it ends.
bool check_separation(UpdateRun& run, std::span<const RegionAngles> angles) {
  bool ok = true;
  auto of_loop = angles.begin();
  const auto refuse = [&](const std::string& name, const std::string& reason) {
    if (ok) ok = run.fail(UpdateStatus::non_separating, name + ": " + reason);
  };
  run.for_each_border_loop([&](std::size_t c, std::size_t l) {
    const std::string loop = run.name_of_loop(c, l);
    const Separation separation = run.result.clouds[c].loops[l].separation;
    const std::size_t seen = of_loop++->seen();
    if (run.is_cut[c] != 0) {  // what is known of the rim was enough: segment()
      if (separation == Separation::non_separating && runs_around_handle(run.result.clouds[c]))
        run.warn(loop + ": " + warning_of_handle_across_rim());
    } else if (separation == Separation::encloses_nothing && seen < 2) {
      run.warn(loop + ": " + warning_of_nothing_inside());
    } else if (separation == Separation::open_band) {
      refuse(loop, reason_of_open_band(run.options.trace.max_search_facets));
    } else if (separation == Separation::non_separating) {
      refuse(run.name_of_cloud(c), reason_of_wide_handle());
    }
  });
  return ok;
}

}  // namespace

std::optional<std::vector<RegionAngles>> segment_under_clouds(UpdateRun& run,
                                                              const Execution& execution) {
  if (!close_pin_holes(run, execution)) return {};
  const std::vector<std::size_t> joined = lowest_sharing_clouds(run.rims.shared_with);
  run.is_cut = clouds_to_cut(partial_rims(run.result.clouds), joined);
  if (!segment(run, joined, execution)) return {};
  run.for_each_border_loop([&](std::size_t c, std::size_t l) {
    run.result.clouds[c].loops[l].separation = separation_in(run, c, l, run.result.regions);
  });
  std::vector<RegionAngles> angles = run.measure_angles(run.result.regions);
  const bool runs_around_handles = cut_across_handles(run);
  if (cut_where_scans_end(run, angles) || runs_around_handles) {
    if (!segment(run, joined, execution)) return {};
    angles = run.measure_angles(run.result.regions);
  }
  for (std::size_t c = 0; c < run.clouds.size(); ++c) {
    run.warn_of_cloud(c, warnings_of_cut(run.result.clouds[c].cut, run.options.cut));
  }
  if (!check_separation(run, angles)) return {};
  return angles;
}

}  // namespace cocoon
