#include "update/steps/reconstruct_updated.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "update/checks/overlooked_vertices.h"
#include "update/regions/scanned_again.h"
#include "update/regions/unchanged_rest.h"
#include "update/steps/make_surface.h"
#include "update/steps/result_doubts.h"

namespace cocoon {

namespace {

// What lies amid new samples although no rim says so goes, too, if it is much; and what was neither
// scanned nor changed stays, although it lies behind a rim.
ReplacedVertices vertices_to_replace(UpdateRun& run, std::span<const CloudRim> rims,
                                     std::span<const NearestPointTree> trees) {
  UpdateResult& result = run.result;
  const OverlookedOptions& options = run.options.overlooked;
  const auto replaced_but = [&](const SaidVertices& said) {
    return replaced_vertices(*run.index, result.regions, result.choice, rims, run.clouds,
                             run.options.replace, said);
  };
  ReplacedVertices replaced = replaced_but({});
  const std::vector<VertexId> stay =
      unchanged_rest(*run.index, replaced.removed, result.regions, result.choice,
                     run.options.overrides.replaced, run.scans(), trees, run.options.unchanged);
  result.overlooked = overlooked_vertices(*run.index, replaced.removed, rims, trees, options);
  std::vector<VertexId> go;
  if (options.go && result.overlooked.are_many(options)) {
    go = scanned_again(*run.index, result.overlooked.vertices, trees, run.outward());
    const std::vector<RegionId>& kept = run.options.overrides.kept;
    std::erase_if(go, [&](VertexId v) {
      return std::find(kept.begin(), kept.end(), result.regions.group_of_vertex[v]) != kept.end();
    });
  }
  if (!go.empty() || !stay.empty()) replaced = replaced_but({go, stay});
  return replaced;
}

}  // namespace

void reconstruct_updated(UpdateRun& run, const UpdateParts& parts, const Execution& execution) {
  const std::vector<CloudRim> rims = border_rims_of(run.result.clouds);
  const std::vector<NearestPointTree> trees = nearest_point_trees(run.clouds, execution);
  const ReplacedVertices replaced = vertices_to_replace(run, rims, trees);
  const std::vector<EdgeSide> irregular = irregular_sides(*run.index);
  const auto triangles = make_surface(run, parts, replaced, irregular, execution);
  if (!triangles) return;
  enter_doubts(*run.index, irregular, {run.given, run.joined, run.clouds, rims, trees}, *triangles,
               run.options, run.result);
}

}  // namespace cocoon
