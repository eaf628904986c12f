#include "app/report/update_report.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/arguments/surface_options.h"
#include "app/report/surface_report.h"
#include "geom/messages/counted.h"
#include "update/report/update_messages.h"

namespace cocoon::app {

namespace {

// Loops that take part in the border: not the holes inside a cloud.
std::size_t border_loops(const CloudReport& cloud) {
  std::size_t count = 0;
  for (const LoopReport& loop : cloud.loops) count += loop.match == LoopMatch::on_model ? 1U : 0U;
  return count;
}

// Pin-holes among them.
std::size_t opened_pin_holes(const CloudReport& cloud) {
  std::size_t count = 0;
  for (const LoopReport& loop : cloud.loops) {
    count += loop.pin_hole && loop.match == LoopMatch::on_model ? 1U : 0U;
  }
  return count;
}

const char* word_for(LoopMatch match) {
  return match == LoopMatch::on_model  ? "on_model"
         : match == LoopMatch::covered ? "covered"
                                       : "off_model";
}

// Each loop of its rim.
void add_rims(JsonReport& entry, const CloudReport& cloud) {
  entry.set_empty_array("rims");
  for (const LoopReport& loop : cloud.loops) {
    JsonReport rim;
    rim.set("edges", loop.edges);
    rim.set("perimeter", loop.perimeter);
    rim.set("pin_hole", loop.pin_hole);
    rim.set("match", word_for(loop.match));
    rim.set("unmatched_points", loop.unmatched);
    entry.append("rims", rim);
  }
}

void add_search(JsonReport& entry, const CloudSurface& surface) {
  entry.set("rho", surface.search.rho);
  entry.set("alpha_deg", told_in_degrees(std::acos(surface.search.alpha_cosine)));
  entry.set("radius", name_of(surface.search.radius_mode));
  entry.set("rho_trials", surface.trials.size());
}

void add_seams(JsonReport& entry, const CloudRim& rim) {
  entry.set("rim_edges", rim.rim_edges);
  entry.set("seam_edges", rim.seam_edges);
  entry.set("lone_edges", rim.lone_edges);
  entry.set("shared_edges", rim.shared_edges);
  entry.set("wall_edges", rim.wall_edges);
  entry.set("seam_loops", rim.seam_loops);
  entry.set("seamed_loops", rim.seamed_loops);
}

JsonReport cloud_entry(const CloudReport& cloud) {
  JsonReport entry;
  if (cloud.joined_with) entry.set("joined_with", *cloud.joined_with);
  for (const RegionVerdict& group : cloud.groups) {
    entry.set("mean_angle_deg/" + std::to_string(group.region.value), group.mean_angle_deg());
  }
  entry.set("replaced_groups", numbers_of(cloud.replaced_groups));
  entry.set("margin_deg", cloud.margin_deg);
  entry.set("told_by_samples", cloud.is_told_by_samples);
  entry.set("told_by_sure_angles", cloud.is_told_by_sure_angles);
  if (cloud.joined_with) return entry;
  entry.set("loops", cloud.loops.size());
  add_rims(entry, cloud);
  entry.set("border_loops", border_loops(cloud));
  entry.set("pin_holes", cloud.surface.rim.pin_holes);
  entry.set("opened_pin_holes", opened_pin_holes(cloud));
  add_seams(entry, cloud.surface.rim);
  entry.set("is_cut", !cloud.cut.is_empty());
  entry.set("cut_edges", cloud.cut.cut_edges);
  entry.set("cut_length", cloud.cut.cut_length);
  entry.set("cut_contradicted", cloud.cut.contradicted);
  entry.set("disproved_facets", cloud.cut.said_under.size());
  entry.set("scan_ends", cloud.cut.scan_ends);
  entry.set("cut_splinters", cloud.cut.splinters.size());
  entry.set("contradicted_samples", cloud.contradicted.count);
  entry.set("boundary_points", cloud.boundary_points);
  entry.set("boundary_samples", cloud.surface.boundary_samples);
  entry.set("chords", cloud.surface.literal.chords);
  entry.set("missed_edges", cloud.surface.literal.missed_edges);
  entry.set("set_aside", cloud.surface.set_aside);
  entry.set("is_layered", cloud.surface.is_layered);
  add_search(entry, cloud.surface);
  entry.set("compared_rims", cloud.compared_rims);
  entry.set("taken_rim", cloud.taken_rim);
  entry.set("trimmed_triangles", cloud.surface.trimmed);
  entry.set("rim_spacing", cloud.surface.rim.spacing);
  const SpacingRange& spacing = cloud.surface.spacing;
  entry.set("spacing_range", std::vector<double>{spacing.low, spacing.high});
  entry.set("largest_distance", cloud.overlap.largest_distance);
  entry.set("median_distance", cloud.overlap.median_distance);
  entry.set("largest_excess", cloud.overlap.largest_excess);
  entry.set("shift", cloud.shift);
  entry.set("overlapping_facets", cloud.overlapping_facets.size());
  entry.set("border_facets", cloud.border.facets);
  entry.set("border_walks", cloud.border.walks);
  entry.set("border_searches", cloud.border.searches);
  entry.set("border_breaks", cloud.border.breaks);
  entry.set("star_misses", cloud.overlap.star_misses);
  entry.set("facing_away", cloud.overlap.facing_away);
  entry.set("steep_points", cloud.overlap.steep);
  entry.set("relocated_points", cloud.overlap.relocated);
  std::size_t unmatched = 0;
  for (const LoopReport& loop : cloud.loops) unmatched += loop.unmatched;
  entry.set("unmatched_points", unmatched);
  entry.set("in_shadow", cloud.overlap.in_shadow);
  return entry;
}

// Each group of the model, in the order of their numbers.
void add_regions(JsonReport& report, const UpdateResult& result) {
  report.set_empty_array("update/regions");
  for (const RegionId r : result.regions.regions.ids()) {
    const Region& region = result.regions.regions[r];
    JsonReport entry;
    entry.set("facets", region.facets);
    entry.set("vertices", region.vertices);
    entry.set("replaced",
              std::binary_search(result.replaced_groups.begin(), result.replaced_groups.end(), r));
    report.append("update/regions", entry);
  }
}

// What is doubtful about the result.
void add_doubts(JsonReport& report, const UpdateResult& result) {
  report.set("update/unexplained_handles", result.unexplained_handles);
  report.set("update/sampled_handles", result.sampled_handles);
  report.set("update/loose_parts", result.loose_parts.count);
  if (result.crowded.distance > 0) {
    report.set("update/crowded_samples", result.crowded.closer);
    report.set("update/crowded_distance", result.crowded.distance);
    report.set("update/crowded_thickness", result.crowded.thickness);
    report.set("update/left_out_samples", result.replacement.left_out);
  }
  report.set("update/closed_openings", result.closed_openings.edges);
  report.set("update/model_euler", result.euler_before);
  report.set("update/updated_euler", result.euler);
  report.set("update/contradicted_islands", numbers_of(result.islands));
  report.set("update/unused_changes", result.unused_changes.samples);
  report.set("update/bridging_triangles", result.gaps.triangles);
  report.set("update/longest_gap", result.gaps.longest);
  report.set("update/far_losses", result.unscanned.far);
  report.set("update/unscanned_losses", result.unscanned.vertices);
}

void add_update_section(JsonReport& report, const UpdateResult& result) {
  std::vector<std::size_t> loops;
  std::size_t boundary_points = 0;
  std::size_t overlapping_facets = 0;
  for (const CloudReport& cloud : result.clouds) {
    loops.push_back(border_loops(cloud));
    boundary_points += cloud.boundary_points;
    overlapping_facets += cloud.overlapping_facets.size();
  }
  report.set("update/loops", loops);
  report.set("update/boundary_points", boundary_points);
  report.set("update/overlapping_facets", overlapping_facets);
  report.set("update/border_facets", result.regions.border_facets);
  report.set("update/groups", result.regions.regions.size());
  add_regions(report, result);
  report.set_empty_array("update/clouds");
  for (const CloudReport& cloud : result.clouds) report.append("update/clouds", cloud_entry(cloud));
  report.set("update/replaced_groups", numbers_of(result.replaced_groups));
  const Replacement& replacement = result.replacement;
  const ReplacedVertices& vertices = replacement.vertices;
  report.set("update/replaced_points", vertices.replaced);
  report.set("update/kept_points", vertices.kept);
  report.set("update/border_kept", vertices.border_kept);
  report.set("update/border_replaced", vertices.border_replaced);
  report.set("update/enclosed_replaced", vertices.enclosed_replaced);
  report.set("update/scanned_replaced", vertices.scanned_replaced);
  report.set("update/unscanned_kept", vertices.unscanned_kept);
  report.set("update/overlooked", result.overlooked.vertices.size());
  report.set("update/overlooked_replaced", vertices.overlooked);
  report.set("update/unchanged_kept", vertices.unchanged);
  report.set("update/rescanned", result.overlooked.scanned);
  report.set("update/rescanned_kept", result.overlooked.kept);
  add_doubts(report, result);
  const ReconstructCounters& counters = result.reconstruction.counters;
  report.set("update/yielded_cells", counters.yielded_cells);
  report.set("update/first_conflicts", counters.first_conflicts);
  report.set("update/second_look", counters.second_look);
  report.set("update/seen_cells", counters.likely_cells);
  report.set("update/contradicted_seen_cells", counters.contradicted_likely);
  report.set("update/heeded_seen_cells", counters.heeded_likely);
  report.set("update/thinned_points", vertices.thinned);
  report.set("update/duplicate_points", replacement.duplicates);
  report.set("update/updated_points", replacement.points.size());
}

}  // namespace

std::vector<std::size_t> numbers_of(const std::vector<RegionId>& regions) {
  std::vector<std::size_t> numbers;
  numbers.reserve(regions.size());
  for (const RegionId region : regions) numbers.push_back(region.index());
  return numbers;
}

std::string verdict_on(const RegionVerdict& group, const CloudReport& cloud,
                       std::span<const RegionId> islands, const RegionOverrides& overrides) {
  const std::string verdict = group.under_cloud ? "replaced" : "kept";
  if (overrides.names(group.region)) return verdict + ", as was said";
  const bool contradicted =
      group.under_cloud && std::find(islands.begin(), islands.end(), group.region) != islands.end();
  if (contradicted) return verdict + ": samples off the model lie over it";
  if (cloud.is_told_by_samples) return verdict + ", as its samples tell";
  return verdict + (cloud.is_told_by_sure_angles ? ", as sure angles tell" : "");
}

void add_update(JsonReport& report, const UpdateRecord& record) {
  const UpdateResult& result = record.result;
  report.set("input/points", record.model.points.size());
  report.set("input/triangles", record.model.triangles.size());
  report.set("input/duplicates", result.replacement.duplicates);
  std::vector<std::size_t> cloud_sizes;
  for (std::size_t c = 0; c < record.clouds.size(); ++c) {  // stray samples included
    cloud_sizes.push_back(record.strays.empty() ? record.clouds[c].size()
                                                : record.strays[c].kept.size());
  }
  report.set("input/clouds", cloud_sizes);
  add_model(report, result.reconstruction, result.mesh, record.certificate);
  add_update_section(report, result);
}

void add_model(JsonReport& report, const ReconstructResult& reconstruction,
               const TriangleMesh& mesh, const MeshReport& certificate) {
  const bool is_made_here = reconstruction.vertices > 0;
  if (is_made_here) {
    report.set("delaunay/points", reconstruction.vertices);
    report.set("delaunay/tetrahedra", reconstruction.tetrahedra);
  }
  add_surface(report, mesh, certificate);
  if (is_made_here) report.set("surface/unused_points", reconstruction.unused_points);
}

void say_update(Job& job, const UpdateRecord& record) {
  const UpdateResult& result = record.result;
  job.say("model {}: {} points, {} triangles", record.model_name, record.model.points.size(),
          record.model.triangles.size());
  for (std::size_t c = 0; c < result.clouds.size(); ++c) {
    const CloudReport& cloud = result.clouds[c];
    if (cloud.joined_with) {
      job.say("cloud {}: {}, one surface with {}", record.cloud_names[c],
              counted(record.clouds[c].size(), "point"), record.cloud_names[*cloud.joined_with]);
      continue;
    }
    job.say("cloud {}: {}, {} with {}, on {} of the model", record.cloud_names[c],
            counted(record.clouds[c].size(), "point"), counted(cloud.loops.size(), "boundary loop"),
            counted(cloud.boundary_points, "point"),
            counted(cloud.overlapping_facets.size(), "facet"));
    if (cloud.surface.trials.size() > 1) {
      job.say("  rim found with rho {:.4g} after {} trials{}", cloud.surface.search.rho,
              cloud.surface.trials.size(),
              cloud.taken_rim > 0 ? ", as the one that leaves the least doubt on the model" : "");
    }
    for (const std::string& note : notes_of_cloud(cloud)) job.say("  {}", note);
    for (const std::string& note : notes_of_cut(cloud.cut)) job.say("  {}", note);
    for (const RegionVerdict& group : cloud.groups) {
      job.say("  group {}: mean angle {:.2f} degrees, {}", group.region.value,
              group.mean_angle_deg(), verdict_on(group, cloud, result.islands, record.overrides));
    }
  }
  job.say("{} of {} groups replaced: {} points out, {} points in all",
          result.replaced_groups.size(), result.regions.regions.size(),
          result.replacement.vertices.replaced, result.replacement.points.size());
  const std::string change = topology_change(result);
  if (!change.empty()) job.say("{}", change);
}

std::string topology_change(const UpdateResult& result) {
  if (result.euler == result.euler_before) return "";
  return fmt::format("topology: Euler characteristic {} -> {}", result.euler_before, result.euler);
}

}  // namespace cocoon::app
