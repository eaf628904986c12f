#include "update/scanned_vertices.h"

#include <algorithm>
#include <cstddef>

#include "geom/box_tree.h"

namespace cocoon {

namespace {

// The spacing of the model at the corners of border facets, 0 at all other vertices: the mean edge
// of the facets around each of them, smoothed over its neighbors among them, since a few edges vary
// a lot.
class BorderSpacing {
 public:
  BorderSpacing(const TriangleMesh& model, const Regions& regions)
      : model_(model), at_border_(model.points.size(), 0) {
    for (const TriangleId t : model.triangles.ids()) {
      if (!regions.region_of_facet[t].is_none()) continue;
      for (const VertexId v : model.triangles[t]) at_border_[v] = 1;
    }
  }

  IdVector<VertexId, double> compute() const {
    const IdVector<VertexId, double> own = mean_around([&](VertexId v, VertexId other) {
      return distance(model_.points[v], model_.points[other]);
    });
    return mean_around([&](VertexId v, VertexId other) {
      return at_border_[other] != 0 ? 0.5 * (own[v] + own[other]) : own[v];
    });
  }

 private:
  // The mean of value(v, other) over the other corners of the facets at v.
  template <class Value>
  IdVector<VertexId, double> mean_around(const Value& value) const {
    IdVector<VertexId, double> means(model_.points.size(), 0);
    IdVector<VertexId, std::uint32_t> counts(model_.points.size(), 0);
    for (const Triangle& corners : model_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId v = corners[i];
        if (at_border_[v] == 0) continue;
        means[v] += value(v, corners[(i + 1) % 3]) + value(v, corners[(i + 2) % 3]);
        counts[v] += 2;
      }
    }
    for (const VertexId v : means.ids()) {
      if (counts[v] > 0) means[v] /= static_cast<double>(counts[v]);
    }
    return means;
  }

  const TriangleMesh& model_;
  IdVector<VertexId, std::uint8_t> at_border_;
};

// A vertex that may have been scanned, and how close a sample must be.
struct Candidate {
  VertexId vertex;
  double squared_reach;
};

}  // namespace

IdVector<VertexId, Scanned> scanned_vertices(const TriangleMesh& model, const Regions& regions,
                                             const RimIndex& rim_index,
                                             std::span<const CloudRim> rims,
                                             std::span<const std::vector<Point>> clouds,
                                             const ScannedOptions& options) {
  IdVector<VertexId, Scanned> result(model.points.size(), Scanned::unclear);
  if (rim_index.empty() || !(options.rim_zone > 0)) return result;

  // 1. Who is close to a rim.
  const IdVector<VertexId, double> spacings = BorderSpacing(model, regions).compute();
  std::vector<Candidate> candidates;
  std::vector<Box> boxes;
  double largest = 0;
  for (const VertexId v : spacings.ids()) {
    if (!(spacings[v] > 0)) continue;
    const RimSide side = rim_index.side_of(model.points[v]);
    const double largest_spacing = std::max(rims[side.rim].spacing, spacings[v]);
    if (!(side.distance <= options.rim_zone * largest_spacing)) continue;
    result[v] = Scanned::no;
    const double reach = options.sample_reach * spacings[v];
    candidates.push_back({v, reach * reach});
    boxes.push_back(box_of({&model.points[v], 1}));
    largest = std::max(largest, reach * reach);
  }

  // 2. Which of them have a sample close by.
  const BoxTree tree(boxes);
  for (const std::vector<Point>& cloud : clouds) {
    for (const Point& p : cloud) {
      tree.visit_near(p, largest, [&](std::uint32_t slot) {
        const Candidate& candidate = candidates[tree.items()[slot]];
        const double squared = squared_distance(p, model.points[candidate.vertex]);
        if (squared <= candidate.squared_reach) result[candidate.vertex] = Scanned::yes;
        return largest;
      });
    }
  }
  return result;
}

}  // namespace cocoon
