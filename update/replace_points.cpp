#include "update/replace_points.h"

#include <algorithm>
#include <optional>

#include "geom/equal_points.h"
#include "geom/large_pages.h"
#include "geom/nearest_point.h"
#include "update/rim_index.h"

namespace cocoon {

namespace {

// Whether the vertex is close to a point of the first cloud, second cloud, ...
class ThinningTest {
 public:
  ThinningTest(std::span<const CloudRim> rims, std::span<const std::vector<Point>> clouds,
               double share) {
    if (!(share > 0)) return;
    for (std::size_t c = 0; c < clouds.size() && c < rims.size(); ++c) {
      if (clouds[c].empty()) continue;
      const double reach = share * rims[c].spacing;
      clouds_.push_back({NearestPointTree(clouds[c]), reach * reach});
    }
  }
  bool is_thinned(const Point& p) const {
    for (const Cloud& cloud : clouds_) {
      if (cloud.points.nearest(p).squared_distance < cloud.squared_reach) return true;
    }
    return false;
  }

 private:
  struct Cloud {
    NearestPointTree points;
    double squared_reach;
  };
  std::vector<Cloud> clouds_;
};

// Merges equal points of `points`, of which the first `distinct` differ from each other, keeping
// the first of each in place; returns the new position of every old one.
std::vector<PointId> merge_equal(std::vector<Point>& points, std::size_t distinct) {
  const std::vector<RepeatedPoint> repeated = repeated_points(points, distinct);
  std::vector<PointId> new_position(points.size());
  auto next = repeated.begin();
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (next != repeated.end() && next->point == i) {
      new_position[i] = new_position[next->first];
      ++next;
      continue;
    }
    if (count != i) points[count] = points[i];
    new_position[i] = PointId(count++);
  }
  points.resize(count);
  return new_position;
}

}  // namespace

Replacement replace_points(const ModelIndex& index, const Regions& regions,
                           const RegionChoice& choice, std::span<const CloudRim> rims,
                           std::span<const std::vector<Point>> clouds,
                           const ReplaceOptions& options) {
  Replacement result;
  const TriangleMesh& model = index.mesh();
  const RimIndex rim_index(rims);
  const ThinningTest thinning(rims, clouds, options.thinning_distance);

  const IdVector<VertexId, Scanned> scanned =
      scanned_vertices(index, regions, rim_index, rims, clouds, options.scanned);

  // 1. Kept vertices.
  std::vector<VertexId> kept;
  kept.reserve(model.points.size());
  for (const VertexId v : model.points.ids()) {
    if (index.adjacency().triangles_at(v).empty()) {
      ++result.unused_vertices;
      continue;
    }
    const RegionId group = regions.group_of_vertex[v];
    const bool on_border = group.is_none();
    bool replaced =
        on_border ? rim_index.on_cloud_side(model.points[v]) : choice.replaced[group] != 0;
    if (scanned[v] != Scanned::unclear && replaced != (scanned[v] == Scanned::yes)) {
      replaced = !replaced;
      ++(replaced ? result.scanned_replaced : result.unscanned_kept);
    }
    if (on_border) ++(replaced ? result.border_replaced : result.border_kept);
    if (replaced) {
      ++result.replaced;
    } else if (thinning.is_thinned(model.points[v])) {
      ++result.thinned;
    } else {
      kept.push_back(v);
    }
  }
  result.kept = kept.size();

  // 2. Then the clouds; equal points once.
  std::size_t gathered = kept.size();
  for (const std::vector<Point>& cloud : clouds) gathered += cloud.size();
  result.points.reserve(gathered);
  prefer_large_pages(result.points);
  for (const VertexId v : kept) result.points.push_back(model.points[v]);
  for (const std::vector<Point>& cloud : clouds) {
    result.points.insert(result.points.end(), cloud.begin(), cloud.end());
  }
  const std::vector<PointId> new_position =
      merge_equal(result.points, index.has_distinct_points() ? kept.size() : 0);
  result.duplicates = gathered - result.points.size();

  // 3. Where everything went.
  result.point_of_vertex = IdVector<VertexId, PointId>(model.points.size());
  auto next = new_position.begin();
  for (const VertexId v : kept) result.point_of_vertex[v] = *next++;
  for (const std::vector<Point>& cloud : clouds) {
    const auto end = next + static_cast<std::ptrdiff_t>(cloud.size());
    result.point_of_cloud_point.emplace_back(std::vector<PointId>(next, end));
    next = end;
  }
  return result;
}

std::vector<KnownTriangle> known_triangles(const TriangleMesh& model, const Regions& regions,
                                           const RegionChoice& choice,
                                           const Replacement& replacement) {
  std::vector<KnownTriangle> known;
  for (const TriangleId t : model.triangles.ids()) {
    const RegionId region = regions.region_of_facet[t];
    if (region.is_none() || choice.replaced[region] != 0) continue;
    KnownTriangle corners;
    std::transform(model.triangles[t].begin(), model.triangles[t].end(), corners.begin(),
                   [&](VertexId v) { return replacement.point_of_vertex[v]; });
    const bool stays =
        std::none_of(corners.begin(), corners.end(), [](PointId p) { return p.is_none(); });
    if (stays) known.push_back(corners);
  }
  return known;
}

}  // namespace cocoon
