#include "update/regions/moved_cut.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geom/messages/require_size.h"
#include "geom/search/nearest_point.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// More than the three edges of a facet, 2^40 each: so none around changes sides. A million of them
// fit into the 62 bits of facet_cut().
constexpr std::int64_t fixed_pull = std::int64_t{1} << 42;

// Both facets at each edge of the cut.
std::vector<TriangleId> facets_at_cut(const ModelIndex& model, const TriangleSet& border,
                                      const TriangleSet& source) {
  std::vector<TriangleId> facets;
  for (const Halfedge halfedge : halfedges_of_cut(model, border, source)) {
    const TriangleId t(triangle_of_halfedge(halfedge));
    facets.push_back(t);
    facets.push_back(model.neighbors()[t][corner_of_halfedge(halfedge)]);
  }
  return facets;
}

// What is labeled anew, and the facets around it, which are not.
struct Zone {
  TriangleSet is_inside;
  std::vector<TriangleId> facets;
  std::vector<TriangleId> around;
};

Zone zone_of(const ModelIndex& model, const TriangleSet& border, std::span<const TriangleId> at_cut,
             double reach) {
  std::vector<Point> places;
  for (const TriangleId t : at_cut) places.push_back(model.centroid(t));
  const NearestPointTree cut(places);
  Zone zone{TriangleSet(border.size(), 0), {}, {}};
  TriangleSet is_seen(border.size(), 0);
  const auto take = [&](TriangleId t) {
    if (is_seen[t] != 0) return;
    is_seen[t] = 1;
    if (cut.any_near(model.centroid(t), reach)) {
      zone.is_inside[t] = 1;
      zone.facets.push_back(t);
    } else {
      zone.around.push_back(t);
    }
  };
  for (const TriangleId t : at_cut) take(t);
  for (std::size_t k = 0; k < zone.facets.size(); ++k) {
    for (const TriangleId next : model.neighbors()[zone.facets[k]]) {
      if (!next.is_none() && border[next] == 0) take(next);
    }
  }
  return zone;
}

}  // namespace

TriangleSet moved_cut(const ModelIndex& model, const TriangleSet& border,
                      std::span<const FacetPull> pulls, double steps_per_unit, TriangleSet source,
                      std::span<const Scan> scans, const MovedCutOptions& options) {
  require_options("moved_cut", options);
  require_size("moved_cut", "labels", source.size(), model.mesh().triangles.size());
  const double spacing = largest_spacing(scans);
  if (options.reach * spacing == 0) return source;
  const std::vector<TriangleId> at_cut = facets_at_cut(model, border, source);
  if (at_cut.empty()) return source;
  const Zone zone = zone_of(model, border, at_cut, options.reach * spacing);
  const TriangleSet unconfirmed =
      unconfirmed_facets(model, scans, zone.facets, options.unconfirmed);
  std::vector<FacetPull> near;
  for (const FacetPull& p : pulls) {
    if (zone.is_inside[p.facet] != 0) near.push_back(p);
  }
  for (const TriangleId t : zone.around) {
    near.push_back({t, source[t] != 0 ? fixed_pull : -fixed_pull});
  }
  const TriangleSet anew =
      facet_cut(model, border, near, {steps_per_unit, &unconfirmed, options.unconfirmed_cost});
  for (const TriangleId t : zone.facets) source[t] = anew[t];
  return source;
}

}  // namespace cocoon
