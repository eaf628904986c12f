#include "update/split_regions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <tuple>

#include "geom/box.h"
#include "geom/nearest_point.h"
#include "geom/require_size.h"
#include "update/cloud/rim_index.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// In the order in which they win at equal distance.
enum class Label : std::uint8_t { outside, under };

struct Labeled {
  double distance = std::numeric_limits<double>::infinity();
  Label label = Label::outside;
  friend auto operator<=>(const Labeled&, const Labeled&) = default;
};

// Labels the facets of one region from its seeds.
class Labeling {
 public:
  Labeling(const ModelIndex& model, const Regions& regions, RegionId region)
      : model_(model),
        regions_(regions),
        region_(region),
        labels_(regions.region_of_facet.size()) {}

  // Facets beside the border at which the rim is close enough to tell.
  void seed(const RimIndex& rims, std::span<const double> spacings, double reach,
            SplitRegion& counts) {
    for (const TriangleId t : labels_.ids()) {
      if (regions_.region_of_facet[t] != region_ || !is_beside_border(t)) continue;
      const RimSide side = rims.side_of(model_.centroid(t));
      const double spacing = std::max(spacings[side.rim], shortest_edge(model_.mesh(), t));
      if (!(side.distance <= reach * spacing)) continue;
      labels_[t] = {0, side.on_cloud_side ? Label::under : Label::outside};
      ++(side.on_cloud_side ? counts.under_seeds : counts.outside_seeds);
      queue_.push({labels_[t], t});
    }
  }

  void spread() {
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.labeled != labels_[entry.facet]) continue;  // reached on a shorter way meanwhile
      for (const TriangleId next : model_.neighbors()[entry.facet]) {
        if (next.is_none() || regions_.region_of_facet[next] != region_) continue;
        const double step = distance(model_.centroid(entry.facet), model_.centroid(next));
        const Labeled offer = {entry.labeled.distance + step, entry.labeled.label};
        if (!(offer < labels_[next])) continue;
        labels_[next] = offer;
        queue_.push({offer, next});
      }
    }
  }

  // Facets of other regions are never labeled.
  bool is_under(TriangleId t) const { return labels_[t].label == Label::under; }

 private:
  bool is_beside_border(TriangleId t) const {
    for (const TriangleId next : model_.neighbors()[t]) {
      if (!next.is_none() && regions_.region_of_facet[next].is_none()) return true;
    }
    return false;
  }

  struct Entry {
    Labeled labeled;
    TriangleId facet;
    friend bool operator<(const Entry& a, const Entry& b) {  // the top of the queue is the nearest
      return std::tuple(b.labeled, b.facet) < std::tuple(a.labeled, a.facet);
    }
  };

  const ModelIndex& model_;
  const Regions& regions_;
  RegionId region_;
  IdVector<TriangleId, Labeled> labels_;
  std::priority_queue<Entry> queue_;
};

// Distances from the clouds, each as a share of its extent.
class CloudReach {
 public:
  explicit CloudReach(std::span<const std::vector<Point>> clouds) {
    for (const std::vector<Point>& cloud : clouds) {
      if (cloud.empty()) continue;
      Box box;
      for (const Point& p : cloud) box.include(p);
      clouds_.push_back({NearestPointTree(cloud), distance(box.low, box.high)});
    }
  }
  double at(const Point& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Cloud& cloud : clouds_) {
      least = std::min(least, std::sqrt(cloud.points.nearest(p).squared_distance) / cloud.extent);
    }
    return least;
  }

 private:
  struct Cloud {
    NearestPointTree points;
    double extent;
  };
  std::vector<Cloud> clouds_;
};

void require_inputs(const ModelIndex& model, const Regions& regions,
                    std::span<const RegionId> divided, std::span<const CloudRim> rims,
                    std::span<const std::vector<Point>> clouds) {
  require_size("split_regions", "facets of the regions", regions.region_of_facet.size(),
               model.mesh().triangles.size());
  require_size("split_regions", "clouds", clouds.size(), rims.size());
  for (const RegionId region : divided) {
    require_index("split_regions", "region", region.index(), regions.regions.size());
  }
}

}  // namespace

RegionSplit split_regions(const ModelIndex& model, const Regions& regions,
                          std::span<const RegionId> divided, std::span<const CloudRim> rims,
                          std::span<const std::vector<Point>> clouds, const SplitOptions& options) {
  require_options("split_regions", options);
  require_inputs(model, regions, divided, rims, clouds);
  const RimIndex rim_index(rims);
  const CloudReach cloud_reach(clouds);
  std::vector<double> spacings;
  for (const CloudRim& rim : rims) spacings.push_back(rim.spacing);

  RegionSplit result;
  result.regions = regions;
  for (const RegionId region : divided) {
    SplitRegion& split = result.split.emplace_back();
    split.outside = region;
    Labeling labeling(model, regions, region);
    if (!rim_index.empty()) labeling.seed(rim_index, spacings, options.seed_reach, split);
    if (split.under_seeds == 0 || split.outside_seeds == 0) {
      result.status = SplitStatus::one_sided;
      return result;
    }
    labeling.spread();

    split.under = result.regions.regions.push_back({});
    for (const TriangleId t : regions.region_of_facet.ids()) {
      if (!labeling.is_under(t)) continue;
      ++split.under_facets;
      result.regions.region_of_facet.set(t, split.under);
      split.reach = std::max(split.reach, cloud_reach.at(model.centroid(t)));
      for (const TriangleId next : model.neighbors()[t]) {
        if (next.is_none() || regions.region_of_facet[next] != region) continue;
        if (!labeling.is_under(next)) ++split.cut_edges;
      }
    }
    if (split.reach > options.max_reach) {
      result.status = SplitStatus::too_far;
      return result;
    }
  }
  count_and_group(model, result.regions);
  return result;
}

}  // namespace cocoon
