#include "update/contradicted_islands.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "geom/arrays/sort_ids.h"
#include "geom/id_vector.h"
#include "geom/messages/require_size.h"
#include "geom/search/closest_facet.h"
#include "geom/search/nearest_point.h"
#include "geom/triangle_mesh.h"
#include "update/cloud/off_samples.h"
#include "update/model/near_facets.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

std::vector<RegionId> islands_seen(const CloudChoice& cloud, const RegionChoice& choice,
                                   RegionId largest) {
  std::vector<RegionId> islands;
  for (const RegionVerdict& verdict : cloud.regions) {
    const bool stays = choice.replaced[verdict.region] == 0 && verdict.region != largest;
    if (stays && verdict.edges > 0) islands.push_back(verdict.region);
  }
  return islands;
}

// Facets of the islands, each with corners of its own.
struct IslandFacets {
  TriangleMesh mesh;
  std::vector<TriangleId> of_model;

  IslandFacets(const TriangleMesh& model, const Regions& regions,
               const std::vector<RegionId>& islands) {
    const auto is_of_island = [&](RegionId r) {
      return std::find(islands.begin(), islands.end(), r) != islands.end();
    };
    regions.region_of_facet.visit_where(is_of_island, [&](TriangleId t) {
      Triangle corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = mesh.points.push_back(model.points[model.triangles[t][k]]);
      }
      mesh.triangles.push_back(corners);
      of_model.push_back(t);
    });
  }
};

// A sample, and the place of an island that it lies over or under.
struct Over {
  Point sample;
  TriangleId facet;
  Point foot;
  double facing;  // cosine of the ways in which its surface and the facet face; 0: not known

  double squared_height() const { return squared_distance(sample, foot); }
};

std::vector<Over> samples_over(const ModelIndex& model, const Regions& regions,
                               const std::vector<RegionId>& islands,
                               const std::vector<OffSample>& samples, double min_cosine) {
  const IslandFacets facets(model.mesh(), regions, islands);
  const ClosestFacetTree tree(facets.mesh);
  std::vector<Over> found;
  for (const OffSample& p : samples) {
    const ClosestFacet foot = tree.closest(p.place);
    const TriangleId facet = facets.of_model[foot.triangle.index()];
    const Vec3 normal = model.normal(facet);
    if (std::abs(dot(unit(p.place - foot.point), normal)) < min_cosine) continue;
    found.push_back({p.place, facet, foot.point, dot(p.outward.normal, normal)});
  }
  return found;
}

// Those that do not face their facets, and have none between that clearly do: with feet within
// reach of theirs, and nearer to the model.
std::vector<Over> without_sheltered(const std::vector<Over>& over, double min_cosine,
                                    double reach) {
  std::vector<Point> feet;
  std::vector<double> heights;
  for (const Over& o : over) {
    if (o.facing > -min_cosine || reach == 0) continue;
    feet.push_back(o.foot);
    heights.push_back(o.squared_height());
  }
  std::optional<NearestPointTree> facing;
  if (!feet.empty()) facing.emplace(feet);
  std::vector<Over> open;
  std::copy_if(over.begin(), over.end(), std::back_inserter(open), [&](const Over& o) {
    const auto is_nearer = [&](PointId p) { return heights[p.index()] < o.squared_height(); };
    return o.facing >= 0 && !(facing && facing->any_near(o.foot, reach, is_nearer));
  });
  return open;
}

// For each region, the places over or under which samples off the model lie, with no facet nearer
// that faces the same way. The other side of the body, which may be closer to the floor of a pocket
// than its mouth is, faces the other way.
IdVector<RegionId, std::vector<Point>> contradicted_places(const ModelIndex& model,
                                                           const Regions& regions, const Scan& scan,
                                                           const std::vector<Outward>& outward,
                                                           const std::vector<RegionId>& islands,
                                                           const IslandOptions& options) {
  IdVector<RegionId, std::vector<Point>> places(regions.regions.size());
  const std::vector<OffSample> off =
      outward_samples_off_model(model, scan.samples, outward, options.off_model * scan.spacing);
  if (off.size() < options.min_samples) return places;
  const std::vector<Over> over =
      without_sheltered(samples_over(model, regions, islands, off, options.min_normal_cosine),
                        options.min_normal_cosine, options.facing_reach * scan.spacing);
  double reach = 0;
  std::vector<Point> centers;
  for (const Over& o : over) {
    centers.push_back(o.sample);
    reach = std::max(reach, distance(o.sample, o.foot));
  }
  const NearFacets near(model, centers, reach);
  for (const Over& o : over) {
    const Vec3 normal = model.normal(o.facet);
    const ClosestFacet closest = near.closest(o.sample, o.squared_height(), [&](TriangleId t) {
      return dot(model.normal(t), normal) >= options.min_normal_cosine;
    });
    const RegionId region = regions.region_of_facet[o.facet];
    if (closest.triangle.is_none() || regions.region_of_facet[closest.triangle] == region) {
      places[region].push_back(o.foot);
    }
  }
  return places;
}

// What one cloud has against a region: what is this near to these places goes.
struct Contradiction {
  RegionId region;
  NearestPointTree places;
  double reach = 0;
};

// Makes the facets of the region near the places of some contradiction of it a region of its own,
// unless all are. Returns the region that goes.
RegionId part_near(const ModelIndex& model, std::span<const Contradiction> contradictions,
                   RegionId region, Regions& regions) {
  std::vector<TriangleId> near;
  const auto is_near = [&](TriangleId t) {
    return std::any_of(contradictions.begin(), contradictions.end(), [&](const Contradiction& c) {
      return c.region == region && c.places.any_near(model.centroid(t), c.reach);
    });
  };
  regions.region_of_facet.visit_where([&](RegionId r) { return r == region; },
                                      [&](TriangleId t) {
                                        if (is_near(t)) near.push_back(t);
                                      });
  if (near.empty() || near.size() == regions.regions[region].facets) return region;
  const RegionId part(regions.regions.size());
  regions.regions.push_back({});
  for (const TriangleId t : near) regions.region_of_facet.set(t, part);
  return part;
}

// Who saw the region saw the part of it that goes.
void note_island(RegionId region, RegionId part, std::vector<RegionVerdict>& verdicts) {
  const auto seen = std::find_if(verdicts.begin(), verdicts.end(),
                                 [&](const RegionVerdict& v) { return v.region == region; });
  if (seen == verdicts.end()) return;
  RegionVerdict verdict = *seen;
  verdict.region = part;
  verdict.under_cloud = true;
  if (part == region) {
    *seen = verdict;
  } else {
    verdicts.push_back(verdict);
  }
}

}  // namespace

std::vector<ContradictedIsland> part_contradicted_islands(
    const ModelIndex& model, const RegionChoice& choice, std::span<const Scan> scans,
    Regions& regions, const IslandOptions& options, const OutwardNormals& outward) {
  require_options("part_contradicted_islands", options);
  require_size("part_contradicted_islands", "scans", scans.size(), choice.clouds.size());
  require_size("part_contradicted_islands", "facets of the regions", regions.region_of_facet.size(),
               model.mesh().triangles.size());
  const RegionId largest = largest_kept_region(regions, choice);
  std::vector<Contradiction> contradictions;
  std::vector<RegionId> contradicted;
  for (std::size_t c = 0; c < scans.size(); ++c) {
    const std::vector<RegionId> islands = islands_seen(choice.clouds[c], choice, largest);
    if (islands.empty()) continue;
    const IdVector<RegionId, std::vector<Point>> places = contradicted_places(
        model, regions, scans[c], outward ? outward(c) : std::vector<Outward>(), islands, options);
    for (const RegionId r : islands) {
      const auto count = static_cast<double>(places[r].size());
      const double limit = options.min_share * static_cast<double>(regions.regions[r].facets);
      if (places[r].size() < options.min_samples || count <= limit) continue;
      contradictions.push_back({r, NearestPointTree(places[r]), options.reach * scans[c].spacing});
      contradicted.push_back(r);
    }
  }
  make_set(contradicted);
  const std::size_t before = regions.regions.size();
  std::vector<ContradictedIsland> found;
  found.reserve(contradicted.size());
  for (const RegionId r : contradicted) {
    found.push_back({r, part_near(model, contradictions, r, regions)});
  }
  if (regions.regions.size() > before) count_and_group(model, regions);
  return found;
}

void choose_island(const ContradictedIsland& island, RegionChoice& choice) {
  choice.replaced[island.part] = 1;
  for (CloudChoice& cloud : choice.clouds) {
    note_island(island.region, island.part, cloud.regions);
  }
}

}  // namespace cocoon
