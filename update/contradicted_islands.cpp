#include "update/contradicted_islands.h"

#include "geom/id_vector.h"
#include "geom/sort_ids.h"
#include "update/near_facets.h"

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

// For each region, samples off the model whose closest facet is one of its.
IdVector<RegionId, std::size_t> samples_against(const ModelIndex& model, const Regions& regions,
                                                const Scan& scan, const IslandOptions& options,
                                                const Execution& execution) {
  IdVector<RegionId, std::size_t> against(regions.regions.size(), 0);
  const double off_model = options.off_model * scan.spacing;
  for (const ClosestFacet& closest : closest_facets(model, scan.samples, off_model, execution)) {
    if (closest.squared_distance <= off_model * off_model) continue;
    const RegionId region = regions.region_of_facet[closest.triangle];
    if (!region.is_none()) ++against[region];
  }
  return against;
}

}  // namespace

std::vector<RegionId> contradicted_islands(const ModelIndex& model, const Regions& regions,
                                           const RegionChoice& choice, std::span<const Scan> scans,
                                           const IslandOptions& options,
                                           const Execution& execution) {
  std::vector<RegionId> found;
  const RegionId largest = largest_kept(regions, choice);
  for (std::size_t c = 0; c < scans.size(); ++c) {
    const std::vector<RegionId> islands = islands_seen(choice.clouds[c], choice, largest);
    if (islands.empty()) continue;
    const IdVector<RegionId, std::size_t> against =
        samples_against(model, regions, scans[c], options, execution);
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
