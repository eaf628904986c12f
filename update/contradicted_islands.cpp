#include "update/contradicted_islands.h"

#include <algorithm>

#include "geom/box.h"
#include "geom/id_vector.h"
#include "geom/sort_ids.h"
#include "update/near_facets.h"
#include "update/sample_heights.h"

namespace cocoon {

namespace {

RegionId largest_kept(const Regions& regions, const RegionChoice& choice) {
  RegionId largest;
  for (const RegionId r : regions.regions.ids()) {
    if (choice.replaced[r] != 0) continue;
    if (largest.is_none() || regions.regions[r].facets > regions.regions[largest].facets) {
      largest = r;
    }
  }
  return largest;
}

std::vector<RegionId> islands_seen(const CloudChoice& cloud, const RegionChoice& choice,
                                   RegionId largest) {
  std::vector<RegionId> islands;
  for (const RegionVerdict& verdict : cloud.regions) {
    const bool stays = choice.replaced[verdict.region] == 0 && verdict.region != largest;
    if (stays && verdict.edges > 0) islands.push_back(verdict.region);
  }
  return islands;
}

std::vector<Point> samples_off(const ModelIndex& model, const Scan& scan, double off_model) {
  const std::vector<double> heights = squared_heights(model, scan.samples, off_model);
  std::vector<Point> off;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (heights[k] > off_model * off_model) off.push_back(scan.samples[k]);
  }
  return off;
}

// For each region, samples off the model that lie over or under it. The other side of the body,
// which may be closer to the floor of a pocket than its mouth is, faces the other way.
IdVector<RegionId, std::size_t> samples_against(const ModelIndex& model, const Regions& regions,
                                                const Scan& scan,
                                                const std::vector<RegionId>& islands,
                                                const IslandOptions& options) {
  IdVector<RegionId, std::size_t> against(regions.regions.size(), 0);
  const std::vector<Point> off = samples_off(model, scan, options.off_model * scan.spacing);
  if (off.size() < options.min_samples) return against;
  const double reach = norm(box_of(scan.samples).size());
  const NearFacets near(model, off, reach);
  const auto region_of = [&](TriangleId t) { return regions.region_of_facet[t]; };
  for (const Point& p : off) {
    const ClosestFacet foot = near.closest(p, reach * reach, [&](TriangleId t) {
      return std::find(islands.begin(), islands.end(), region_of(t)) != islands.end();
    });
    if (foot.triangle.is_none()) continue;
    const Vec3 normal = model.normal(foot.triangle);
    const ClosestFacet closest = near.closest(p, foot.squared_distance, [&](TriangleId t) {
      return dot(model.normal(t), normal) >= options.min_normal_cosine;
    });
    if (!closest.triangle.is_none() && region_of(closest.triangle) == region_of(foot.triangle)) {
      ++against[region_of(foot.triangle)];
    }
  }
  return against;
}

}  // namespace

std::vector<RegionId> contradicted_islands(const ModelIndex& model, const Regions& regions,
                                           const RegionChoice& choice, std::span<const Scan> scans,
                                           const IslandOptions& options) {
  std::vector<RegionId> found;
  const RegionId largest = largest_kept(regions, choice);
  for (std::size_t c = 0; c < scans.size(); ++c) {
    const std::vector<RegionId> islands = islands_seen(choice.clouds[c], choice, largest);
    if (islands.empty()) continue;
    const IdVector<RegionId, std::size_t> against =
        samples_against(model, regions, scans[c], islands, options);
    for (const RegionId r : islands) {
      const double limit = options.min_share * static_cast<double>(regions.regions[r].facets);
      if (against[r] >= options.min_samples && static_cast<double>(against[r]) > limit)
        found.push_back(r);
    }
  }
  make_set(found);
  return found;
}

}  // namespace cocoon
