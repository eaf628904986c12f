#include "update/update_steps.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "geom/angles.h"
#include "geom/arrays/sort_ids.h"
#include "geom/errors.h"
#include "update/cloud/outward_normals.h"
#include "update/model/euler_number.h"
#include "update/model/model_index.h"
#include "update/regions/kept_surface.h"
#include "update/report/unit_factor.h"
#include "update/report/update_messages.h"
#include "update/report/updated_vertices.h"
#include "update/result_doubts.h"

namespace cocoon {
namespace {

// Few samples of layers look smoother by themselves. They stand for all only if these have no rim,
// or if locate_rims() finds theirs far clearer.
std::vector<CloudSurface> layers_behind(std::vector<CloudSurface> surfaces) {
  std::stable_partition(surfaces.begin(), surfaces.end(), [](const CloudSurface& surface) {
    return surface.status == CloudStatus::ok && !surface.is_layered;
  });
  return surfaces;
}

}  // namespace

UpdateSteps::UpdateSteps(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                         const UpdateOptions& options)
    : model_(model), given_(clouds), clouds_(clouds), options_(options) {
  for (std::size_t c = 0; c < clouds.size(); ++c) joined_.push_back({.members = {c}, .sheet = {}});
  result_.clouds.resize(clouds_.size());
}

UpdateSteps::UpdateSteps(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                         std::vector<JoinedCloud> joined, const UpdateOptions& options)
    : model_(model), given_(clouds), joined_(std::move(joined)), options_(options) {
  for (const JoinedCloud& cloud : joined_) samples_.push_back(samples_of(cloud, clouds));
  clouds_ = samples_;
  result_.clouds.resize(clouds_.size());
}

UpdateResult UpdateSteps::take_result() {
  tell_members();
  return std::move(result_);
}

void UpdateSteps::tell_members() {
  result_.clouds = reports_of_members(std::move(result_.clouds), joined_, given_.size());
  const std::vector<CloudChoice> of_joined = std::move(result_.choice.clouds);
  result_.choice.clouds.resize(of_joined.empty() ? 0 : given_.size());
  for (std::size_t j = 0; j < of_joined.size(); ++j) {
    for (const std::size_t c : joined_[j].members) result_.choice.clouds[c] = of_joined[j];
  }
}

bool UpdateSteps::detect_boundaries(const Execution& execution) {
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    try {
      other_surfaces_.push_back(layers_behind(surfaces_of_cloud(c, execution)));
    } catch (const DegenerateInput& error) {
      if (joined_[c].sheet.empty()) throw;
      return fail(UpdateStatus::no_cloud_surface, error.what());  // of a choice of the samples
    }
    result_.clouds[c] = report_of_surface(std::move(other_surfaces_[c].front()));
    other_surfaces_[c].erase(other_surfaces_[c].begin());
    if (!result_.clouds[c].surface.has_loops()) return fail_surface(c);
  }
  return true;
}

bool UpdateSteps::find_overlapping_facets(const ModelIndex& index, const Execution& execution) {
  rims_ = locate_rims(index, clouds_, other_surfaces_, options_, result_.clouds, execution);
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    CloudReport& report = result_.clouds[c];
    if (report.surface.rim.loops.empty()) return fail_surface(c);
    report_overlap(c);
    enter_shift(
        cloud_shift(index, clouds_[c], report.surface.rim, rims_.overlaps[c], options_.shift),
        options_.shift, report);
    warn_of_cloud(c, warnings_of_cloud(report, options_.overlap, options_.shift));
    if (rims_.overlaps[c].status == OverlapStatus::no_overlap)
      return fail_no_overlap(c, index, execution);
  }
  trace_borders(index, execution);
  return true;
}

bool UpdateSteps::segment_and_choose(const ModelIndex& index, const Execution& execution) {
  if (close_pin_holes(index, execution)) {
    for (std::size_t c = 0; c < clouds_.size(); ++c) {
      const bool has_rim = result_.clouds[c].surface.status == CloudStatus::ok;
      if (!has_rim && !rims_.overlaps[c].is_border()) return fail_surface(c);
    }
    trace_borders(index, execution);
  }
  const std::vector<std::size_t> joined = lowest_sharing_clouds(rims_.shared_with);
  is_cut_ = clouds_to_cut(partial_rims(result_.clouds), joined);
  if (!segment(index, joined, execution)) return false;
  find_separations(index);
  std::vector<RegionAngles> angles = measure_angles(index, result_.regions);
  const bool runs_around_handles = cut_across_handles();
  if (cut_where_scans_end(index, angles) || runs_around_handles) {
    if (!segment(index, joined, execution)) return false;
    angles = measure_angles(index, result_.regions);
  }
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    warn_of_cloud(c, warnings_of_cut(result_.clouds[c].cut));
  }
  if (!check_separation(angles)) return false;
  result_.choice = choose_regions(angles, clouds_.size(), options_.choice, decided_);
  if (tell_sides(index, angles, execution)) {
    result_.choice = choose_regions(angles, clouds_.size(), options_.choice, decided_);
  }
  // Regions may be without any loop (all rims covered): then there is nothing to replace.
  result_.choice.replaced.resize(result_.regions.regions.size(), 0);
  take_islands(index);
  take_overrides();
  return report_choice();
}

OutwardNormals UpdateSteps::outward(const ModelIndex& index) const {
  return [this, &index](std::size_t c) {
    return outward_normals(index, clouds_[c], result_.clouds[c].surface, rims_.overlaps[c],
                           options_.outward);
  };
}

void UpdateSteps::take_islands(const ModelIndex& index) {
  RegionChoice& choice = result_.choice;
  if (choice.status != ChoiceStatus::ok) return;
  const std::vector<ContradictedIsland> islands =
      part_contradicted_islands(index, choice, scans_of(clouds_, result_.clouds), result_.regions,
                                options_.islands, outward(index));
  choice.replaced.resize(result_.regions.regions.size(), 0);
  for (const ContradictedIsland& island : islands) {
    result_.islands.push_back(island.part);
    choose_island(island, choice);
  }
  make_set(result_.islands);
}

// An ambiguous choice of joined clouds ends in a second attempt, with each by itself: the numbers
// that people know are of that.
void UpdateSteps::take_overrides() {
  if (are_joined() && result_.choice.status == ChoiceStatus::ambiguous) return;
  override_choice(options_.overrides, result_.choice);
  std::erase_if(result_.islands, [&](RegionId r) { return result_.choice.replaced[r] == 0; });
}

void UpdateSteps::reconstruct(const ModelIndex& index, const UpdateParts& parts,
                              const Execution& execution) {
  const std::vector<CloudRim> rims = border_rims_of(result_.clouds);
  result_.replacement = replace_points(index, result_.regions, result_.choice, rims, clouds_,
                                       given_, options_.replace);
  const std::vector<NearestPointTree> trees = nearest_point_trees(clouds_, execution);
  const KeptSurface kept(index, result_.regions, result_.choice, result_.replacement);
  UpdatedSurface surface = parts.reconstruct(result_.replacement, kept.told(), execution);
  result_.reconstruction = std::move(surface.result);
  if (result_.reconstruction.status == SurfaceStatus::refuted) {
    fail(UpdateStatus::refuted, result_.reconstruction.verification.failure);
    return;
  }
  if (result_.reconstruction.status != SurfaceStatus::ok) {
    const ReconstructResult& updated = result_.reconstruction;
    const bool is_all_boundary = updated.counters.boundary_samples >= updated.vertices;
    fail(UpdateStatus::empty_surface,
         reason_of_empty_surface(result_.replacement.points.size()) +
             (is_all_boundary ? hint_of_limits(options_.reconstruct.boundary) : ""));
    return;
  }
  result_.mesh = std::exchange(result_.reconstruction.mesh, {});
  result_.vertex_map = updated_vertices(result_.replacement, result_.reconstruction);
  const std::size_t points = result_.replacement.points.size();
  const std::size_t unused = result_.reconstruction.unused_points;
  result_.euler = euler_number(points - unused, surface.triangles);
  enter_doubts(index, {given_, joined_, clouds_, rims, trees}, options_, result_);
}

std::string UpdateSteps::name_of_cloud(std::size_t c) const {
  return name_of_clouds(joined_[c].members, given_.size());
}

std::string UpdateSteps::name_of_loop(std::size_t c, std::size_t l) const {
  return name_of_cloud(c) + ", " + cocoon::name_of_loop(result_.clouds[c].surface.rim.loops[l]);
}

void UpdateSteps::warn_of_cloud(std::size_t c, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) warn(name_of_cloud(c) + ": " + warning);
}

std::vector<RegionAngles> UpdateSteps::measure_angles(const ModelIndex& index,
                                                      const Regions& regions) const {
  std::vector<RegionAngles> angles;
  for_each_border_loop([&](std::size_t c, std::size_t l) {
    angles.push_back(mean_rim_angles(index, regions, result_.clouds[c].surface.rim.loops[l],
                                     borders_[c].loops[l], options_.angles));
    angles.back().cloud = static_cast<std::uint32_t>(c);
  });
  return angles;
}

std::vector<CloudSurface> UpdateSteps::surfaces_of_cloud(std::size_t c,
                                                         const Execution& execution) const {
  try {
    return joined_cloud_surfaces(clouds_[c], joined_[c], options_.cloud, execution);
  } catch (const DegenerateInput& error) {
    throw DegenerateInput(name_of_cloud(c) + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(name_of_cloud(c) + ": " + error.what());
  }
}

bool UpdateSteps::close_pin_holes(const ModelIndex& index, const Execution& execution) {
  std::optional<Regions> regions;
  bool closed = false;
  for_each_border_loop([&](std::size_t c, std::size_t l) {
    if (!result_.clouds[c].loops[l].pin_hole) return;
    if (!regions) regions = segment_model(index, border_facets_, options_.segment, execution);
    const LoopSides sides = loop_sides(model_, index.neighbors(), borders_[c].loops[l], *regions);
    if (sides.separation == Separation::separates) {
      return warn(name_of_loop(c, l) +
                  ": the model goes on through this small hole of the scan; what is beyond stays");
    }
    rims_.overlaps[c].loops[l].match = result_.clouds[c].loops[l].match = LoopMatch::off_model;
    closed = true;
  });
  return closed;
}

void UpdateSteps::trace_borders(const ModelIndex& index, const Execution& execution) {
  borders_.clear();
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    CloudReport& report = result_.clouds[c];
    borders_.push_back(
        trace_border(index, report.surface.rim, rims_.overlaps[c], options_.trace, execution));
    Border& border = borders_[c];
    TriangleSet facets = std::exchange(border.facets, {});
    if (c == 0) {
      border_facets_ = std::move(facets);
    } else {
      for (const TriangleId t : facets.ids()) border_facets_[t] |= facets[t];
    }
    report.border = border.figures;
  }
}

void UpdateSteps::report_overlap(std::size_t c) {
  const Overlap& overlap = rims_.overlaps[c];
  enter_overlap(overlap, result_.clouds[c]);
  for (std::size_t l = 0; l < overlap.loops.size(); ++l) {
    const LoopOverlap& loop = overlap.loops[l];
    if (loop.match == LoopMatch::on_model) continue;
    if (result_.clouds[c].surface.rim.loops[l].is_seam) continue;
    warn(name_of_loop(c, l) + ": " +
         warning_of_loop(loop, loop.covered > 0 || !rims_.shared_with[c].empty()));
  }
}

bool UpdateSteps::fail_surface(std::size_t c) {
  const CloudSurface& surface = result_.clouds[c].surface;
  const bool is_empty = surface.status == CloudStatus::no_surface;
  return fail(is_empty ? UpdateStatus::no_cloud_surface : UpdateStatus::cloud_closed,
              name_of_cloud(c) + " " +
                  (is_empty ? "gives no surface; sample it more densely or remove noise"
                            : reason_of_closed_cloud(surface.rim)) +
                  hint_of_only_trial(options_.cloud));
}

bool UpdateSteps::fail_no_overlap(std::size_t c, const ModelIndex& index,
                                  const Execution& execution) {
  const CloudReport& report = result_.clouds[c];
  const CloudRim& rim = report.surface.rim;
  return fail(UpdateStatus::no_overlap,
              name_of_cloud(c) + " " +
                  reason_of_no_overlap(
                      rims_.overlaps[c].unmatched, report.boundary_points,
                      options_.overlap.max_distance, rim.spacing,
                      unit_factor(index, rim, rims_.overlaps[c], options_.overlap, execution)));
}

void UpdateSteps::find_separations(const ModelIndex& index) {
  for_each_border_loop([&](std::size_t c, std::size_t l) {
    result_.clouds[c].loops[l].separation =
        loop_sides(model_, index.neighbors(), borders_[c].loops[l], result_.regions).separation;
  });
}

bool UpdateSteps::cut_across_handles() {
  const std::vector<std::uint8_t> before = is_cut_;
  for_each_border_loop([&](std::size_t c, std::size_t l) {
    if (separation_of(c, l) == Separation::non_separating) is_cut_[c] = 1;
  });
  return is_cut_ != before;
}

bool UpdateSteps::check_separation(std::span<const RegionAngles> angles) {
  bool ok = true;
  auto of_loop = angles.begin();
  const auto refuse = [&](const std::string& name, const std::string& reason) {
    if (ok) ok = fail(UpdateStatus::non_separating, name + ": " + reason);
  };
  for_each_border_loop([&](std::size_t c, std::size_t l) {
    const std::string loop = name_of_loop(c, l);
    const Separation separation = separation_of(c, l);
    const std::size_t seen = of_loop++->seen();
    if (is_cut_[c] != 0) {  // what is known of the rim was enough: segment()
      if (separation == Separation::non_separating && runs_around_handle(result_.clouds[c]))
        warn(loop + ": " + warning_of_handle_across_rim());
    } else if (separation == Separation::encloses_nothing && seen < 2) {
      warn(loop + ": " + warning_of_nothing_inside());
    } else if (separation == Separation::open_band) {
      refuse(loop, reason_of_open_band(options_.trace.max_search_facets));
    } else if (separation == Separation::non_separating) {
      refuse(name_of_cloud(c), reason_of_wide_handle());
    }
  });
  return ok;
}

bool UpdateSteps::segment(const ModelIndex& index, const std::vector<std::size_t>& joined,
                          const Execution& execution) {
  if (std::count(is_cut_.begin(), is_cut_.end(), 1) == 0) {
    decided_.clear();
    result_.regions = segment_model(index, border_facets_, options_.segment, execution);
    return true;
  }
  CutRegions cut = cut_regions(index, border_rims_of(result_.clouds), borders_,
                               scans_of(clouds_, result_.clouds), joined, is_cut_, options_.cut,
                               options_.segment, execution, outward(index));
  is_cut_ = std::move(cut.is_cut);
  if (needs_no_cut(index, joined, cut.cuts, execution)) {
    is_cut_.assign(clouds_.size(), 0);
    for (CloudReport& cloud : result_.clouds) cloud.cut = {};
    return segment(index, joined, execution);
  }
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    if (is_cut_[c] == 0 || joined[c] != c) continue;
    const std::optional<std::string> why = why_not_cut(c, cut.cuts[c], index);
    cut.cuts[c].under = {};
    result_.clouds[c].cut = std::move(cut.cuts[c]);
    if (why) {
      result_.regions = segment_model(index, border_facets_, options_.segment, execution);
      return fail(UpdateStatus::non_separating, name_of_cloud(c) + ": " + *why);
    }
  }
  result_.regions = std::move(cut.regions);
  decided_ = std::move(cut.under);
  return true;
}

bool UpdateSteps::needs_no_cut(const ModelIndex& index, const std::vector<std::size_t>& joined,
                               std::span<const RegionCut> cuts, const Execution& execution) const {
  if (std::count(is_cut_.begin(), is_cut_.end(), 1) == 0) return false;
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    if (is_cut_[c] == 0) continue;
    const bool is_single = std::count(joined.begin(), joined.end(), joined[c]) == 1;
    if (!is_single || cuts[c].doubt() <= options_.cut.clear_doubt) return false;
  }
  const Regions whole = segment_model(index, border_facets_, options_.segment, execution);
  const std::vector<RegionAngles> angles = measure_angles(index, whole);
  const RegionChoice choice = choose_regions(angles, clouds_.size(), options_.choice);
  const std::vector<Scan> scans = scans_of(clouds_, result_.clouds);
  std::vector<std::uint8_t> separates(clouds_.size(), 1);
  for_each_border_loop([&](std::size_t c, std::size_t l) {
    const LoopSides sides = loop_sides(model_, index.neighbors(), borders_[c].loops[l], whole);
    if (sides.separation != Separation::separates) separates[c] = 0;
  });
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    if (is_cut_[c] == 0) continue;
    const CloudChoice& cloud = choice.clouds[c];
    const bool all_turned =
        !cloud.turned_away.empty() && cloud.turned_away.size() == cloud.regions.size();
    if (separates[c] == 0 || !all_turned ||
        regions_under_samples(index, whole, cloud.turned_away, scans[c], options_.sampled,
                              execution)
            .empty()) {
      return false;
    }
  }
  return true;
}

std::optional<std::string> UpdateSteps::why_not_cut(std::size_t c, const RegionCut& cut,
                                                    const ModelIndex& index) const {
  if (runs_around_handle(result_.clouds[c])) {
    const std::vector<Scan> scans = scans_of(clouds_, result_.clouds);
    const bool is_far =
        reaches_beyond(index, members(cut.under), std::span(&scans[c], 1), options_.cut.box_reach);
    if (is_far || cut.doubt() > options_.cut.max_doubt) return reason_of_wide_handle();
  } else if (cut.doubt() > options_.cut.max_doubt) {
    return reason_of_doubtful_cut(cut);
  }
  return {};
}

bool UpdateSteps::cut_where_scans_end(const ModelIndex& index,
                                      std::span<const RegionAngles> angles) {
  const RegionChoice choice = choose_regions(angles, clouds_.size(), options_.choice, decided_);
  const std::vector<Scan> scans = scans_of(clouds_, result_.clouds);
  bool found = false;
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    if (is_cut_[c] != 0 ||
        !scan_ends_under(index, result_.regions, choice.clouds[c], scans[c], options_.cut.ends)) {
      continue;
    }
    is_cut_[c] = 1;
    found = true;
  }
  return found;
}

bool UpdateSteps::tell_sides(const ModelIndex& index, std::span<const RegionAngles> angles,
                             const Execution& execution) {
  const std::vector<Scan> scans = scans_of(clouds_, result_.clouds);
  told_by_.assign(clouds_.size(), ToldBy::rim);
  bool any = false;
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    const CloudChoice& cloud = result_.choice.clouds[c];
    if (cloud.turned_away.empty()) continue;
    IdVector<RegionId, std::uint8_t> under = regions_under_samples(
        index, result_.regions, cloud.turned_away, scans[c], options_.sampled, execution);
    const bool by_samples = !under.empty();
    if (!by_samples) under = under_by_sure_angles(angles, clouds_.size(), c, options_.choice);
    if (under.empty()) continue;
    told_by_[c] = by_samples ? ToldBy::samples : ToldBy::sure_angles;
    for (const RegionVerdict& verdict : cloud.regions) {
      const bool was_asked =
          std::binary_search(cloud.turned_away.begin(), cloud.turned_away.end(), verdict.region);
      if (!was_asked && verdict.under_cloud) under[verdict.region] = 1;
    }
    decided_.resize(clouds_.size());
    decided_[c] = std::move(under);
    any = true;
  }
  return any;
}

bool UpdateSteps::report_choice() {
  const RegionChoice& choice = result_.choice;
  std::size_t seen_by_several = 0;
  std::vector<std::size_t> clouds_over(choice.replaced.size(), 0);
  for (std::size_t c = 0; c < clouds_.size(); ++c) {
    CloudReport& report = result_.clouds[c];
    enter_choice(choice.clouds[c], report);
    for (const RegionId r : report.replaced_groups)
      if (++clouds_over[r.index()] == 2) ++seen_by_several;
    const bool is_said = std::any_of(
        report.groups.begin(), report.groups.end(),
        [&](const RegionVerdict& group) { return options_.overrides.names(group.region); });
    if (is_said) continue;
    report.is_told_by_samples = told_by_[c] == ToldBy::samples;
    report.is_told_by_sure_angles = told_by_[c] == ToldBy::sure_angles;
    if (told_by_[c] != ToldBy::rim) {
      warn(name_of_cloud(c) + ": " +
           warning_of_turned_away(report.groups, report.is_told_by_samples));
    } else if (choice.clouds[c].margin < options_.choice.narrow_margin) {
      warn(name_of_cloud(c) + ": " + warning_of_narrow_margin(report.margin_deg));
    }
  }
  for (const RegionId r : choice.replaced.ids()) {
    if (choice.replaced[r] != 0) result_.replaced_groups.push_back(r);
  }
  if (seen_by_several > 0) warn(warning_of_shared_regions(seen_by_several));
  if (choice.kept_largest) {
    warn("all regions lie under clouds; the one with the largest angle is kept");
  }
  if (choice.status == ChoiceStatus::ok) return true;
  const auto is_undecided = [&](const CloudChoice& cloud) {
    return cloud.is_ambiguous && (are_joined() || !options_.overrides.decides(cloud));
  };
  const auto undecided = std::find_if(choice.clouds.begin(), choice.clouds.end(), is_undecided);
  const auto c = static_cast<std::size_t>(undecided - choice.clouds.begin());
  const std::span<const RegionVerdict> groups =
      are_joined() ? std::span<const RegionVerdict>() : result_.clouds[c].groups;
  return fail(UpdateStatus::ambiguous,
              name_of_cloud(c) + ": " +
                  (!undecided->turned_away.empty()
                       ? reason_of_turned_away(groups)
                       : reason_of_ambiguity(options_.choice.ambiguous_margin * degrees_per_radian,
                                             groups)));
}

}  // namespace cocoon
