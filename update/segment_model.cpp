#include "update/segment_model.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "geom/arrays/visit_where.h"
#include "geom/messages/require_size.h"
#include "update/regions/grow_regions.h"

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
  result.region_of_facet.renew([&](RegionId r) { return r.is_none() ? r : new_id[r]; });
  result.regions = std::move(kept);
}

void count_facets(Regions& result) {
  for (Region& region : result.regions) region = {};
  for (const TriangleId t : result.region_of_facet.ids()) {
    const RegionId r = result.region_of_facet[t];
    if (!r.is_none() && result.regions[r].facets++ == 0) result.regions[r].first = t;
  }
}

// The one region of the facets at a vertex that are not in the border; none if there are several.
RegionId group_of(const ModelIndex& model,
                  const SparseVector<TriangleId, RegionId>& region_of_facet, VertexId v) {
  RegionId group;
  bool several = false;
  model.for_each_triangle_at(v, [&](TriangleId t) {
    const RegionId region = region_of_facet[t];
    if (region.is_none()) return;
    several |= !group.is_none() && group != region;
    group = region;
  });
  return several ? RegionId() : group;
}

// The region with the most facets, of several the first one; none if there is none.
RegionId largest_region(const IdVector<RegionId, Region>& regions) {
  RegionId largest;
  for (const RegionId r : regions.ids()) {
    if (largest.is_none() || regions[r].facets > regions[largest].facets) largest = r;
  }
  return largest;
}

// What regions are: with facets of the border between any two, or not.
enum class Neighbors : std::uint8_t { behind_border, anywhere };

// All vertices are of the largest region but for those at other facets, and those at none.
void group_vertices(const ModelIndex& model, Neighbors neighbors, Regions& result) {
  const TriangleMesh& mesh = model.mesh();
  const RegionId largest = largest_region(result.regions);
  result.group_of_vertex = SparseVector<VertexId, RegionId>(mesh.points.size(), largest);
  result.border_vertices = 0;
  for (Region& region : result.regions) region.vertices = 0;
  std::size_t others = 0;
  visit_where(
      model.is_known_smooth() ? 0 : mesh.points.size(),
      [&](std::size_t i) { return !model.is_used(VertexId(i)); },
      [&](std::size_t i) {
        result.group_of_vertex.set(VertexId(i), RegionId());
        ++others;
      });
  SparseVector<VertexId, std::uint8_t> seen(mesh.points.size());
  // The region is told if it is known: that of a facet at the vertex, which has none of the border.
  const auto look_at = [&](TriangleId t, bool is_known) {
    for (const VertexId v : mesh.triangles[t]) {
      if (seen[v] != 0) continue;
      seen.set(v, 1);
      ++others;
      const RegionId group =
          is_known ? result.region_of_facet[t] : group_of(model, result.region_of_facet, v);
      result.group_of_vertex.set(v, group);
      ++(group.is_none() ? result.border_vertices : result.regions[group].vertices);
    }
  };
  const bool is_known = neighbors == Neighbors::behind_border && model.is_known_smooth();
  result.region_of_facet.visit_where([](RegionId r) { return r.is_none(); },
                                     [&](TriangleId t) { look_at(t, false); });
  result.region_of_facet.visit_where([&](RegionId r) { return r != largest && !r.is_none(); },
                                     [&](TriangleId t) { look_at(t, is_known); });
  if (!largest.is_none()) result.regions[largest].vertices += mesh.points.size() - others;
}

// Everything that tells of vertices, and of the border.
void complete(const ModelIndex& model, Neighbors neighbors, Regions& result) {
  result.border_facets = result.region_of_facet.size();
  for (const Region& region : result.regions) result.border_facets -= region.facets;
  group_vertices(model, neighbors, result);
}

}  // namespace

Regions segment_model(const ModelIndex& model, const TriangleSet& border,
                      const SegmentOptions& options, const Execution& execution) {
  require_size("segment_model", "flags of the border", border.size(),
               model.mesh().triangles.size());
  report_progress(execution, "segment_model", 0);
  Regions result = grow_regions(model, border);
  merge_islands(options.min_region_facets, result);
  complete(model, Neighbors::behind_border, result);
  report_progress(execution, "segment_model", 1);
  return result;
}

Regions segment_model(const TriangleMesh& model, const TriangleSet& border,
                      const SegmentOptions& options, const Execution& execution) {
  return segment_model(ModelIndex(model, execution), border, options, execution);
}

void count_and_group(const ModelIndex& model, Regions& regions) {
  require_size("count_and_group", "facets of the regions", regions.region_of_facet.size(),
               model.mesh().triangles.size());
  count_facets(regions);
  complete(model, Neighbors::anywhere, regions);
}

}  // namespace cocoon
