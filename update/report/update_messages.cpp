#include "update/report/update_messages.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/angles.h"
#include "geom/messages/counted.h"
#include "geom/messages/place_name.h"
#include "geom/messages/rounded.h"

namespace cocoon {

namespace {

// " (group 0: 90.1, group 2: 89.9)"; empty without groups.
std::string told_in_parentheses(std::span<const RegionVerdict> groups) {
  std::string told;
  for (const RegionVerdict& group : groups) {
    told += (told.empty() ? " (group " : ", group ") + std::to_string(group.region.value) + ": " +
            rounded(group.mean_angle_deg());
  }
  return told.empty() ? told : told + ")";
}

}  // namespace

std::string name_of_clouds(std::span<const std::size_t> members, std::size_t clouds) {
  const auto name_of = [&](std::size_t k) {
    return "cloud " + std::to_string(members[k] + 1) + " of " + std::to_string(clouds);
  };
  std::string name = name_of(0);
  if (members.size() == 1) return name;
  name += " (with " + name_of(1);
  for (std::size_t k = 2; k < members.size(); ++k) {
    name += (k + 1 < members.size() ? ", " : " and ") + name_of(k);
  }
  return name + ")";
}

std::string name_of_limits(double rho, double alpha_cosine) {
  return "rho " + rounded(rho) + " and alpha " +
         rounded(std::acos(alpha_cosine) * degrees_per_radian) + " degrees";
}

std::string hint_of_only_trial(const CloudSurfaceOptions& options) {
  if (!options.finer.empty() || !options.coarser.empty()) return "";
  return "; only " + name_of_limits(options.start.rho, options.start.alpha_cosine) +
         " were tried, and others may do";
}

std::string name_of_loop(const RimLoop& loop) {
  return "loop of " + std::to_string(loop.size()) + " edges at " + place_name(loop.points.front());
}

std::string reason_of_closed_cloud(const CloudRim& rim) {
  return "has no open rim (" + counted(rim.pin_holes, "pin-hole") + ", " +
         counted(rim.seam_loops, "seam") +
         "): it is closed, or so noisy or coarse that its rim cannot be told; give only the "
         "changed "
         "part with some of its surroundings, smoothed or sampled more densely";
}

std::string reason_of_no_overlap(std::size_t unmatched, std::size_t boundary_points,
                                 double max_distance, double rim_spacing,
                                 std::optional<double> unit_factor) {
  const std::string why = "does not lie on the model: " + std::to_string(unmatched) + " of its " +
                          std::to_string(boundary_points) +
                          " rim points are farther from it than " + rounded(max_distance) +
                          " spacings (rim spacing " + rounded(rim_spacing) + "); ";
  if (unit_factor) {
    return why + "perhaps it has other units: multiplied by " + rounded(*unit_factor) +
           " it would lie there; else register it to the model";
  }
  return why +
         "register it to the model, in the same units, and let it reach onto unchanged surface";
}

std::string reason_of_open_band(std::size_t max_search_facets) {
  return "jumps between parts of the model that are not connected, or only by a way over more "
         "than " +
         std::to_string(max_search_facets) + " facets; update each part by a cloud of its own";
}

std::string reason_of_doubtful_cut(const RegionCut& cut) {
  if (cut.seeds_under == 0 || cut.seeds_outside == 0) {
    return "parts of its rim are missing, and none is left that tells where it ends on the model; "
           "smooth it, sample more densely at sharp edges and thin walls, or let it reach farther "
           "onto unchanged surface";
  }
  return "parts of its rim are missing, and what is left of it does not tell its sides apart: " +
         rounded(cut.cut_length) + " median edges of cuts where it is missing, and " +
         rounded(cut.contradicted) + " in contradiction, beside " +
         rounded(std::min(cut.seeds_under, cut.seeds_outside)) +
         "; sample more densely at sharp edges and thin walls, or add a cloud that closes the rim";
}

std::string reason_of_wide_handle() {
  return "its rim runs around a handle and does not cut the model in two, and no short cut across "
         "the handle parts what is near the samples from the rest; add a cloud that closes the cut";
}

std::string choice_of_groups() { return ", or " + std::string(advice_of_groups); }

std::string reason_of_ambiguity(double margin, std::span<const RegionVerdict> groups) {
  const std::string degrees = rounded(margin);
  const std::string told = told_in_parentheses(groups);
  return "the regions inside and outside a rim make angles with the cloud that differ by less "
         "than " +
         degrees + (degrees == "1" ? " degree" : " degrees") + told +
         "; let the cloud reach farther onto unchanged surface" +
         (told.empty() ? "" : choice_of_groups());
}

std::string reason_of_turned_away(std::span<const RegionVerdict> groups) {
  return "the model turns away from it on both sides of its rim" + told_in_parentheses(groups) +
         ", as where a scan ends before it meets the model, and its samples do not tell which side "
         "they replace; let the cloud reach onto unchanged surface" +
         (groups.empty() ? "" : choice_of_groups());
}

std::string reason_of_empty_surface(std::size_t updated_points) {
  return "the " + std::to_string(updated_points) +
         " updated points give no closed surface; check that model and clouds are samples of one "
         "surface at one scale";
}

std::string hint_of_limits(const BoundaryOptions& limits) {
  return "; none of them meets " + name_of_limits(limits.rho, limits.alpha_cosine) +
         ", and larger ones may do";
}

std::string warning_of_handle_across_rim() {
  return "runs around a handle and does not cut the model in two; the handle is cut by the "
         "shortest way; look at the result";
}

std::vector<std::string> warnings_of_cut(const RegionCut& cut, const CutOptions& options) {
  std::vector<std::string> warnings;
  if (cut.scan_ends > options.few_scan_ends) {
    warnings.push_back("the samples end on the model where no rim was found (" +
                       counted(cut.scan_ends, "facet") +
                       "); what is beyond stays; if it has gone, " + std::string(advice_of_groups));
  }
  if (!cut.is_empty() && cut.doubt() > options.high_doubt) {
    warnings.push_back(
        "its rim leaves doubt about what lies under it (" + rounded(cut.doubt()) +
        " of what its weaker side says): parts of it are missing or contradict each other; look "
        "at the result, sample more densely at sharp edges and thin walls, or let the cloud reach "
        "farther onto unchanged surface");
  }
  return warnings;
}

std::vector<std::string> notes_of_cut(const RegionCut& cut, const CutOptions& options) {
  if (cut.cut_edges == 0 || cut.doubt() <= options.clear_doubt) return {};
  return {"where its rim does not tell the border, the model is cut by the shortest way (" +
          counted(cut.cut_edges, "edge") + ")"};
}

std::string warning_of_clouds_apart(const std::string& why) {
  return "clouds overlap each other, but do not make one surface (" + why +
         "); each is taken by itself";
}

std::string warning_of_few_samples(const std::string& clouds, const std::string& why) {
  return clouds + ": samples lie in layers, and the rim of all is refused (" + why +
         "); that of few of them was taken; look at the result";
}

std::string hint_of_layers(const std::string& clouds) {
  return clouds +
         ": samples lie in layers, are noisy, or are too few for what they show; register the "
         "views, leave out what crowds, or sample more densely";
}

std::string warning_of_shared_regions(std::size_t regions) {
  return counted(regions, "region", "regions") + " of the model " +
         (regions == 1 ? "lies" : "lie") + " under more than one cloud";
}

std::string warning_of_narrow_margin(double degrees) {
  return "its regions differ by only " + rounded(degrees) + " degrees; look at the result";
}

std::string warning_of_turned_away(const CloudReport& cloud) {
  return "the model turns away from it on both sides of its rim" +
         told_in_parentheses(cloud.groups) + ", as where a scan ends before it meets the model, " +
         (cloud.is_told_by_samples
              ? "so its samples tell which group goes"
              : "and its samples do not tell which group goes, so the smaller angle does") +
         "; look at the result";
}

std::string warning_of_overlooked(const OverlookedVertices& vertices, const Point& at,
                                  const OverlookedOptions& options, std::size_t replaced) {
  if (!vertices.are_many(options)) {
    return std::to_string(vertices.kept) + " of " +
           counted(vertices.scanned, "vertex", "vertices") +
           " of the model that were scanned anew stay, as at " + place_name(at) +
           ": the rim runs through the scan, whose surface is torn or too coarse there; sample "
           "more densely at sharp edges and thin walls, let the cloud reach farther, and look at "
           "the result";
  }
  const std::string of_them = replaced == 0 ? ", and stay"
                              : replaced == vertices.vertices.size()
                                  ? ", and go with what was scanned"
                                  : ", of which " + std::to_string(replaced) + " go";
  return counted(vertices.vertices.size(), "vertex of the model lies",
                 "vertices of the model lie") +
         " in the midst of the new samples, as at " + place_name(at) + of_them +
         ": a part of the rim was not found, or the wrong region "
         "chosen; sample more densely at sharp edges and thin walls, and look at the result";
}

std::string warning_of_unused_changes(const UnusedChanges& changes) {
  return std::to_string(changes.samples) + " of " +
         counted(changes.of, "sample off the model is", "samples off the model are") +
         " not on the updated surface, as at " + place_name(changes.at) +
         ": the wrong part of the model may have stayed there; scan what joins them to the model, "
         "such as walls, and look at the result";
}

std::string warning_of_contradicted(const ContradictedSamples& samples) {
  return std::to_string(samples.count) + " of its samples contradict each other about what is " +
         "inside, most near " + place_name(samples.at) +
         ": walls may be joined or missing there; sample more densely at gaps and thin walls, and "
         "look at the result";
}

std::string warning_of_left_out(const CrowdedSamples& crowded, std::size_t before,
                                std::size_t after) {
  return counted(crowded.in_layers, "sample") + " in layers of views that are out of register, " +
         "closer than " + rounded(crowded.distance) + " to others, " +
         (crowded.in_layers == 1 ? "is" : "are") + " left out: with all of them the surface has " +
         counted(before, "handle or part", "handles and parts") + " that nothing explains, now " +
         std::to_string(after) + "; register the views, or look at the result";
}

std::string warning_of_handles(std::size_t handles) {
  return "the updated model has " + counted(handles, "handle") +
         " more than what was replaced explains: right if the scans have " +
         (handles == 1 ? "it" : "them") + ", else look at the result";
}

std::string warning_of_loose_parts(const LooseParts& parts, const Point& at) {
  const bool one = parts.count == 1;
  return counted(parts.count, "part of the updated surface hangs",
                 "parts of the updated surface hang") +
         " together with nothing of the model (" + (one ? "" : "the largest has ") +
         counted(parts.triangles, "triangle") + ", at " + place_name(at) +
         "): right if a body was added, else scan what joins " + (one ? "it" : "them") +
         " to the model";
}

std::string warning_of_openings(const ClosedOpenings& openings, const Point& at) {
  return "the model has " + counted(openings.edges, "open edge") + " without samples " +
         "beside them, as at " + place_name(at) +
         ": the updated mesh is closed there; look at the result";
}

std::string warning_of_gaps(const BridgedGaps& gaps, double reach) {
  return counted(gaps.triangles, "triangle of the updated surface spans",
                 "triangles of the updated surface span") +
         " more than " + rounded(reach) + " spacings where the model has changed, up to " +
         rounded(gaps.longest) + " at " + place_name(gaps.at) +
         ": nothing was scanned there, as in a shadow of the scanner; look at the result, or scan "
         "it, too";
}

std::string warning_of_unscanned(const UnscannedLosses& losses, double reach, const Point& at) {
  const bool one = losses.vertices == 1;
  return counted(losses.vertices, "vertex of the model is gone", "vertices of the model are gone") +
         " though nothing was scanned within " + rounded(reach) + " spacings of " +
         (one ? "it; it is " : "them; the farthest is ") + rounded(losses.distance) +
         " spacings from all samples, at " + place_name(at) +
         "; look at the result, and scan there, too, or let the cloud reach less far";
}

std::vector<std::string> notes_of_cloud(const CloudReport& cloud) {
  const CloudSurface& surface = cloud.surface;
  std::vector<std::string> notes;
  const auto tell = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) notes.push_back(counted(count, one, many));
  };
  tell(surface.rim.seam_loops, "loop is a seam inside the cloud (a sharp edge?), not its rim",
       "loops are seams inside the cloud (sharp edges?), not its rim");
  tell(surface.rim.small_components, "small part of its surface is not looked at",
       "small parts of its surface are not looked at");
  tell(surface.rim.non_orientable, "part of its surface is one-sided",
       "parts of its surface are one-sided");
  if (surface.is_layered) {
    notes.push_back(counted(surface.set_aside, "sample was", "samples were") +
                    " set aside to find its rim: layers out of register, noise, or edges and walls "
                    "too sparsely sampled");
  }
  const auto off_model = std::count_if(
      cloud.loops.begin(), cloud.loops.end(),
      [](const LoopReport& loop) { return !loop.pin_hole && loop.match == LoopMatch::off_model; });
  tell(static_cast<std::size_t>(off_model),
       "loop of its rim is off the model: a hole in the cloud, a top or a floor",
       "loops of its rim are off the model: holes in the cloud, tops or floors");
  if (surface.rim.leaves_model && cloud.overlap.in_shadow == 0) {
    notes.push_back("its rim leaves the model here and there, by up to " +
                    rounded(cloud.overlap.largest_excess) +
                    " spacings: there the scan ends on what has changed");
  }
  return notes;
}

std::vector<std::string> warnings_of_cloud(const CloudReport& cloud, const OverlapOptions& options,
                                           const ShiftOptions& shift) {
  std::vector<std::string> warnings;
  const CloudRim& rim = cloud.surface.rim;
  if (rim.seamed_loops > 0) {
    warnings.push_back(counted(rim.seamed_loops, "loop of its rim runs", "loops of its rim run") +
                       " along seams inside the cloud for the most part; look at the result");
  }
  if (cloud.overlap.median_distance > options.step_distance * rim.spacing) {
    warnings.push_back("its rim lies " + rounded(cloud.overlap.median_distance / rim.spacing) +
                       " spacings off the model (median): there will be a step; register it "
                       "better, or let it reach onto unchanged surface");
  } else if (shift.is_too_long(cloud.shift, rim.spacing)) {
    warnings.push_back("its rim lies as if the cloud were moved by " +
                       rounded(cloud.shift / rim.spacing) + " spacings; register it better");
  }
  if (cloud.overlap.in_shadow > 0) {
    warnings.push_back("its rim leaves the model at " + std::to_string(cloud.overlap.in_shadow) +
                       " of " + std::to_string(cloud.overlap.in_shadow_of) +
                       " points of its longest loop, by more than " +
                       rounded(options.max_distance) +
                       " spacings: the scan ends on what has changed, as in a shadow of the "
                       "scanner; look at the result, or scan what lies between it and the model");
  }
  return warnings;
}

std::string warning_of_loop(bool at_others) {
  return at_others ? "lies on other clouds and is no border"
                   : "runs along a seam inside the cloud and is no border";
}

std::string warning_of_nothing_inside() {
  return "no region of the model lies inside; the cloud is added there; check that its units are "
         "those of the model";
}

}  // namespace cocoon
