#include "update/overlooked_vertices.h"

#include <algorithm>

#include "geom/box.h"
#include "geom/nearest_point.h"
#include "update/rim_index.h"

namespace cocoon {

namespace {

// The samples of one cloud, and how near to them a vertex has been scanned anew.
class ScannedPlaces {
 public:
  ScannedPlaces(const std::vector<Point>& cloud, double reach) : samples_(cloud), reach_(reach) {
    for (const Point& p : cloud) box_.include(p);
    box_.enlarge(reach);
  }
  bool covers(const Point& p) const {
    return contains(box_, p) && samples_.nearest(p).squared_distance <= reach_ * reach_;
  }

 private:
  NearestPointTree samples_;
  double reach_;
  Box box_;
};

}  // namespace

OverlookedVertices overlooked_vertices(const ModelIndex& model, const Replacement& replacement,
                                       std::span<const CloudRim> rims,
                                       std::span<const std::vector<Point>> clouds,
                                       const OverlookedOptions& options) {
  const auto is_partial = [](const CloudRim& rim) { return rim.is_partial(); };
  if (std::none_of(rims.begin(), rims.end(), is_partial)) return {};
  const RimIndex rim_index(rims);
  if (rim_index.empty()) return {};
  std::vector<ScannedPlaces> scans;
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    if (!clouds[c].empty()) scans.emplace_back(clouds[c], options.reach * rims[c].median_edge);
  }
  OverlookedVertices found;
  double farthest = options.min_rim_distance;
  for (const VertexId v : model.mesh().points.ids()) {
    if (replacement.point_of_vertex[v].is_none()) continue;
    const Point& p = model.mesh().points[v];
    bool scanned = false;
    for (const ScannedPlaces& scan : scans) scanned = scanned || scan.covers(p);
    if (!scanned) continue;
    const RimSide side = rim_index.side_of(p);
    const double edges = side.distance / rims[side.rim].median_edge;
    if (!(edges > options.min_rim_distance)) continue;
    ++found.count;
    if (!(edges > farthest)) continue;
    farthest = edges;
    found.farthest = v;
  }
  return found;
}

}  // namespace cocoon
