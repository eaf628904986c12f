#include "update/regions/scanned_vertices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "geom/arrays/sort_ids.h"
#include "geom/search/box_tree.h"
#include "update/model/mean_at_vertex.h"

namespace cocoon {

namespace {

// The corners of border facets, ascending, and the spacing of the model at them: the mean edge of
// the facets around each of them, smoothed over its neighbors among them, since a few edges vary a
// lot.
class BorderSpacing {
 public:
  BorderSpacing(const ModelIndex& model, const Regions& regions)
      : model_(model), place_(model.mesh().points.size()) {
    regions.region_of_facet.visit_where([](RegionId r) { return r.is_none(); },
                                        [&](TriangleId t) {
                                          for (const VertexId v : model.mesh().triangles[t])
                                            vertices_.push_back(v);
                                        });
    make_set(vertices_);
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) place_.set(vertices_[i], i + 1);
  }

  const std::vector<VertexId>& vertices() const { return vertices_; }

  std::vector<double> compute() const {
    const Points points = model_.mesh().points.span();
    const std::vector<double> own = mean_around([&](VertexId v, VertexId other) {
      return distance(points[v.index()], points[other.index()]);
    });
    return mean_around([&](VertexId v, VertexId other) {
      const double at_v = own[place_[v] - 1];
      return place_[other] != 0 ? 0.5 * (at_v + own[place_[other] - 1]) : at_v;
    });
  }

 private:
  // The mean of value(v, other) over the other corners of the facets at each vertex v.
  template <class Value>
  std::vector<double> mean_around(const Value& value) const {
    std::vector<double> means;
    means.reserve(vertices_.size());
    for (const VertexId v : vertices_) {
      means.push_back(mean_at_vertex(model_, v, [&](VertexId other) { return value(v, other); }));
    }
    return means;
  }

  const ModelIndex& model_;
  SparseVector<VertexId, std::uint32_t> place_;  // 1 + that among vertices_; 0: not there
  std::vector<VertexId> vertices_;
};

// A vertex that may have been scanned.
struct Candidate {
  VertexId vertex;
  double spacing;  // of the model
  double depth;    // beyond the rim, on the side of the cloud, in spacings; negative: before it
};

// How close to each candidate a sample of a cloud must be, squared; negative: none is close enough.
std::vector<double> squared_reaches(std::span<const Candidate> candidates, const CloudRim& rim,
                                    const ScannedOptions& options) {
  std::vector<double> squared;
  squared.reserve(candidates.size());
  const double most_before_rim = options.outer_reach * rim.spacing;
  for (const Candidate& candidate : candidates) {
    const double at_rim =
        std::max(options.sample_reach * candidate.spacing, options.cloud_reach * rim.median_edge);
    double reach = at_rim * (1 + options.depth_weight * candidate.depth);
    if (candidate.depth < 0) reach = std::min(reach, most_before_rim);
    squared.push_back(reach > 0 ? reach * reach : -1);
  }
  return squared;
}

}  // namespace

SparseVector<VertexId, Scanned> scanned_vertices(const ModelIndex& index, const Regions& regions,
                                                 const RimIndex& rim_index,
                                                 std::span<const CloudRim> rims,
                                                 std::span<const std::vector<Point>> clouds,
                                                 const ScannedOptions& options) {
  const TriangleMesh& model = index.mesh();
  SparseVector<VertexId, Scanned> result(model.points.size(), Scanned::unclear);
  if (rim_index.empty() || !(options.rim_zone > 0)) return result;

  // 1. Who is close to a rim.
  const BorderSpacing border(index, regions);
  const std::vector<double> spacings = border.compute();
  std::vector<Candidate> candidates;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < spacings.size(); ++i) {
    const VertexId v = border.vertices()[i];
    const double spacing = spacings[i];
    if (!(spacing > 0)) continue;
    const RimSide side = rim_index.side_of(model.points[v]);
    const double largest_spacing = std::max(rims[side.rim].spacing, spacing);
    if (!(side.distance <= options.rim_zone * largest_spacing)) continue;
    result.set(v, Scanned::no);
    const double depth = (side.on_cloud_side ? side.distance : -side.distance) / spacing;
    candidates.push_back({v, spacing, depth});
    boxes.push_back(box_of({&model.points[v], 1}));
  }

  // 2. Which of them have a sample close by.
  if (candidates.empty()) return result;
  const BoxTree tree(boxes);
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    const std::vector<double> reaches = squared_reaches(candidates, rims[c], options);
    const double largest = *std::max_element(reaches.begin(), reaches.end());
    if (largest < 0) continue;
    for (const Point& p : clouds[c]) {
      tree.visit_near(p, largest, [&](std::uint32_t slot) {
        const std::uint32_t item = tree.items()[slot];
        const VertexId v = candidates[item].vertex;
        if (squared_distance(p, model.points[v]) <= reaches[item]) result.set(v, Scanned::yes);
        return largest;
      });
    }
  }
  return result;
}

}  // namespace cocoon
