#include "update/steps/result_doubts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "update/checks/closed_openings.h"
#include "update/checks/contradicted_samples.h"
#include "update/checks/loose_parts.h"
#include "update/checks/unscanned_losses.h"
#include "update/checks/unused_changes.h"
#include "update/cloud/samples_with_flag.h"
#include "update/model/updated_vertices.h"
#include "update/report/update_messages.h"
#include "update/steps/make_surface.h"

namespace cocoon {
namespace {

void warn_of_overlooked(const ModelIndex& model, const OverlookedOptions& options,
                        UpdateResult& result) {
  if (!result.overlooked.is_doubtful(options)) return;
  result.warnings.push_back(warning_of_overlooked(result.overlooked,
                                                  model.mesh().points[result.overlooked.farthest],
                                                  options, result.replacement.vertices.overlooked));
}

void warn_of_loose_parts(UpdateResult& result) {
  if (result.loose_parts.count == 0) return;
  result.warnings.push_back(
      warning_of_loose_parts(result.loose_parts, result.mesh.points[result.loose_parts.at]));
}

void enter_contradictions(const UpdatedClouds& clouds, std::span<const Scan> scans,
                          const ContradictedOptions& options, UpdateResult& result) {
  if (result.reconstruction.contradicted.empty()) return;
  IdVector<PointId, std::uint8_t> flags(result.replacement.points.size(), 0);
  for (const PointId p : result.reconstruction.contradicted) flags[p] = 1;
  const std::vector<std::vector<Point>> contradicted =
      samples_with_flag(result.replacement, clouds.joined, clouds.given, std::move(flags));
  for (std::size_t c = 0; c < scans.size(); ++c) {
    ContradictedSamples& found = result.clouds[c].contradicted;
    found = contradicted_samples(scans[c], contradicted[c], options);
    if (!found.is_doubtful(options)) continue;
    result.warnings.push_back(name_of_clouds(clouds.joined[c].members, clouds.given.size()) + ": " +
                              warning_of_contradicted(found));
  }
}

void enter_unused_changes(const ModelIndex& model, const UpdatedClouds& clouds,
                          std::span<const Scan> scans, const UnusedChangeOptions& options,
                          UpdateResult& result) {
  result.unused_changes = unused_changes(
      model, scans,
      unused_samples(result.replacement, result.reconstruction, clouds.joined, clouds.given),
      options);
  if (result.unused_changes.is_doubtful(options)) {
    result.warnings.push_back(warning_of_unused_changes(result.unused_changes));
  }
}

void enter_gaps(const ModelIndex& model, const UpdatedClouds& clouds, std::span<const Scan> scans,
                std::span<const Triangle> triangles, const GapOptions& options,
                UpdateResult& result) {
  std::vector<double> spacings;
  for (std::size_t c = 0; c < scans.size(); ++c) {
    spacings.push_back(spacing_at(model, scans[c], result.clouds[c].overlapping_facets));
  }
  result.gaps =
      bridged_gaps(model, vertices_of_surface(result), triangles,
                   first_vertex_of_clouds(result.vertex_map), clouds.trees, spacings, options);
  if (result.gaps.triangles == 0) return;
  result.warnings.push_back(warning_of_gaps(result.gaps, options.reach));
}

void enter_closed_openings(const ModelIndex& model, std::span<const EdgeSide> irregular,
                           const ClosedOpeningOptions& options, UpdateResult& result) {
  result.closed_openings =
      closed_openings(model, irregular, result.mesh, result.vertex_map, options);
  if (result.closed_openings.edges == 0) return;
  result.warnings.push_back(
      warning_of_openings(result.closed_openings, model.mesh().points[result.closed_openings.at]));
}

void enter_losses(const ModelIndex& model, const UpdatedClouds& clouds, std::span<const Scan> scans,
                  bool lost_handles, const UnscannedOptions& options, UpdateResult& result) {
  std::vector<VertexId> lost = lost_vertices(model, result.replacement, result.vertex_map,
                                             result.reconstruction.unused_points == 0);
  // What samples lie over or under was scanned through, however far away they are.
  std::erase_if(lost, [&](VertexId v) {
    const RegionId region = result.regions.group_of_vertex[v];
    return std::binary_search(result.islands.begin(), result.islands.end(), region);
  });
  result.unscanned = unscanned_losses(model, lost, scans, clouds.trees, lost_handles, options);
  if (result.unscanned.vertices == 0) return;
  result.warnings.push_back(warning_of_unscanned(result.unscanned, options.reach,
                                                 model.mesh().points[result.unscanned.farthest]));
}

}  // namespace

void enter_doubts(const ModelIndex& model, std::span<const EdgeSide> irregular,
                  const UpdatedClouds& clouds, std::span<const Triangle> triangles,
                  const UpdateOptions& options, UpdateResult& result) {
  const std::vector<Scan> scans = scans_of(clouds.samples, result.clouds);
  warn_of_overlooked(model, options.overlooked, result);
  warn_of_loose_parts(result);
  enter_contradictions(clouds, scans, options.contradicted, result);
  enter_unused_changes(model, clouds, scans, options.unused_changes, result);
  enter_gaps(model, clouds, scans, triangles, options.gaps, result);
  const bool is_closed = irregular.empty();
  if (!is_closed) enter_closed_openings(model, irregular, options.openings, result);
  const std::size_t doubtful = result.unexplained_handles - result.sampled_handles;
  if (doubtful > 0) result.warnings.push_back(warning_of_handles(doubtful));
  const bool lost_handles = is_closed && result.euler > result.euler_before;
  enter_losses(model, clouds, scans, lost_handles, options.unscanned, result);
}

}  // namespace cocoon
