#include "update/rim_angles.h"

#include <algorithm>
#include <vector>

#include "geom/angles.h"
#include "geom/arrays/sort_ids.h"
#include "geom/messages/require_size.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// The vertex of each group that is closest to the midpoint of a rim edge, for the few groups near
// one edge.
struct NearestOfGroup {
  RegionId region;
  VertexId vertex;
  double squared = 0;
  bool widened = false;
};

class NearestOfGroups {
 public:
  NearestOfGroups(const TriangleMesh& mesh, const Regions& regions, const Point& midpoint)
      : mesh_(mesh), regions_(regions), midpoint_(midpoint) {}

  // Enters the corners of a facet; `widened`: of the ring around those at the edge.
  void enter(TriangleId facet, bool widened) {
    for (const VertexId v : mesh_.triangles[facet]) {
      const RegionId region = regions_.group_of_vertex[v];
      if (!region.is_none()) offer(region, v, widened);
    }
  }

  const std::vector<NearestOfGroup>& found() const { return found_; }

 private:
  void offer(RegionId region, VertexId v, bool widened) {
    const double squared = squared_distance(mesh_.points[v], midpoint_);
    for (NearestOfGroup& entry : found_) {
      if (entry.region != region) continue;
      if (widened && !entry.widened) return;  // the facets under the edge come first
      const bool closer = squared < entry.squared || (squared == entry.squared &&
                                                      mesh_.points[v] < mesh_.points[entry.vertex]);
      if (closer) {
        entry.vertex = v;
        entry.squared = squared;
      }
      return;
    }
    found_.push_back({region, v, squared, widened});
  }

  const TriangleMesh& mesh_;
  const Regions& regions_;
  Point midpoint_;
  std::vector<NearestOfGroup> found_;
};

// Distance of p from the line through a and b, relative to its distance from a; 0 at an end.
double relative_height(const Point& a, const Point& b, const Point& p) {
  const Vec3 along = unit(b - a);
  const Vec3 offset = p - a;
  const double length = norm(offset);
  if (!(length > 0) || p == b) return 0;
  return norm(offset - dot(offset, along) * along) / length;
}

}  // namespace

RegionAngles mean_rim_angles(const ModelIndex& model, const Regions& regions, const RimLoop& loop,
                             const LoopBorder& band, const AngleOptions& options) {
  require_options("mean_rim_angles", options);
  const TriangleMesh& mesh = model.mesh();
  require_size("mean_rim_angles", "groups of vertices", regions.group_of_vertex.size(),
               mesh.points.size());
  if (!band.begin.empty()) {
    require_size("mean_rim_angles", "edges of the band", band.begin.size() - 1, loop.size());
  }
  RegionAngles result;
  result.regions = IdVector<RegionId, AngleMean>(regions.regions.size());
  if (band.begin.empty()) return result;
  std::vector<VertexId> corners;  // of the facets under an edge
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto facets = band.facets_of(i);
    if (facets.empty()) continue;
    const Point& from = loop.points[i];
    const Point& to = loop.points[loop.next(i)];
    if (relative_height(from, to, loop.apexes[i]) < options.min_relative_height) {
      ++result.degenerate;
      continue;
    }
    // The paper's P3, P4: first under the edge, then around.
    NearestOfGroups nearest(mesh, regions, 0.5 * (from + to));
    for (const TriangleId t : facets) nearest.enter(t, false);
    corners.clear();
    for (const TriangleId t : facets) {
      corners.insert(corners.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
    make_set(corners);  // facets on the way share some
    for (const VertexId v : corners) {
      model.for_each_triangle_at(v, [&](TriangleId around) { nearest.enter(around, true); });
    }
    for (const NearestOfGroup& entry : nearest.found()) {
      const Point& p = mesh.points[entry.vertex];
      if (relative_height(from, to, p) < options.min_relative_height) {
        ++result.degenerate;
        continue;
      }
      AngleMean& mean = result.regions[entry.region];
      mean.sum += wedge_angle(from, to, loop.apexes[i], p);
      ++mean.edges;
      if (entry.widened) ++result.widened;
    }
  }
  return result;
}

}  // namespace cocoon
