#include "update/segment_model.h"

#include "update/grow_regions.h"

namespace cocoon {

namespace {

// Gives the facets of tiny regions to the border and numbers the others again.
void merge_islands(std::size_t min_facets, Regions& result) {
  bool any_large = false;
  for (const Region& region : result.regions) any_large |= region.facets >= min_facets;
  if (!any_large) return;

  IdVector<RegionId, RegionId> new_id(result.regions.size());
  IdVector<RegionId, Region> kept;
  for (const RegionId r : result.regions.ids()) {
    if (result.regions[r].facets >= min_facets) {
      new_id[r] = kept.push_back(result.regions[r]);
    } else {
      ++result.merged_islands;
    }
  }
  if (result.merged_islands == 0) return;
  for (RegionId& region : result.region_of_facet) {
    if (!region.is_none()) region = new_id[region];
  }
  result.regions = std::move(kept);
}

void count_facets(Regions& result) {
  for (Region& region : result.regions) region = {};
  result.border_facets = 0;
  for (const TriangleId t : result.region_of_facet.ids()) {
    const RegionId r = result.region_of_facet[t];
    if (r.is_none()) {
      ++result.border_facets;
    } else if (result.regions[r].facets++ == 0) {
      result.regions[r].first = t;
    }
  }
}

void group_vertices(const TriangleMesh& model, const MeshAdjacency& adjacency, Regions& result) {
  result.group_of_vertex = IdVector<VertexId, RegionId>(model.points.size());
  result.border_vertices = 0;
  for (const VertexId v : model.points.ids()) {
    const auto facets = adjacency.triangles_at(v);
    if (facets.empty()) continue;
    RegionId group;
    bool several = false;
    for (const TriangleId t : facets) {
      const RegionId region = result.region_of_facet[t];
      if (region.is_none()) continue;
      several |= !group.is_none() && group != region;
      group = region;
    }
    if (several || group.is_none()) {
      ++result.border_vertices;
    } else {
      result.group_of_vertex[v] = group;
      ++result.regions[group].vertices;
    }
  }
}

}  // namespace

Regions segment_model(const ModelIndex& model, const TriangleSet& border,
                      const SegmentOptions& options, const Execution& execution) {
  report_progress(execution, "segment_model", 0);
  Regions result = grow_regions(model, border);
  merge_islands(options.min_region_facets, result);
  count_and_group(model.mesh(), model.adjacency(), result);
  report_progress(execution, "segment_model", 1);
  return result;
}

Regions segment_model(const TriangleMesh& model, const TriangleSet& border,
                      const SegmentOptions& options, const Execution& execution) {
  return segment_model(ModelIndex(model), border, options, execution);
}

void count_and_group(const TriangleMesh& model, const MeshAdjacency& adjacency, Regions& regions) {
  count_facets(regions);
  group_vertices(model, adjacency, regions);
}

}  // namespace cocoon
