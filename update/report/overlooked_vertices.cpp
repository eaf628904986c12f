#include "update/report/overlooked_vertices.h"

#include <limits>

#include "geom/messages/require_size.h"
#include "update/cloud/rim_index.h"
#include "update/cloud/scanned_places.h"
#include "update/stage_options.h"

namespace cocoon {

OverlookedVertices overlooked_vertices(const ModelIndex& model, const Replacement& replacement,
                                       std::span<const CloudRim> rims,
                                       std::span<const NearestPointTree> clouds,
                                       const OverlookedOptions& options) {
  require_options("overlooked_vertices", options);
  require_size("overlooked_vertices", "trees of samples", clouds.size(), rims.size());
  const RimIndex rim_index(rims);
  if (rim_index.empty()) return {};
  ScannedPlaces scanned;
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    scanned.add(clouds[c], options.reach * rims[c].median_edge);
  }
  OverlookedVertices found;
  double farthest = -1;
  model.for_each_vertex_in(scanned.box(), [&](VertexId v) {
    const Point& p = model.mesh().points[v];
    if (!model.is_used(v) || !scanned.contain(p)) return;
    ++found.scanned;
    if (replacement.point_of_vertex[v].is_none()) return;
    ++found.kept;
    const RimSide side = rim_index.side_of(p);
    const double edges = side.distance / rims[side.rim].median_edge;
    if (edges > options.min_rim_distance) {
      ++found.count;
      found.vertices.push_back(v);
    }
    if (!(edges > farthest)) return;
    farthest = edges;
    found.farthest = v;
  });
  return found;
}

std::vector<VertexId> scanned_again(const ModelIndex& model, std::span<const VertexId> overlooked,
                                    std::span<const NearestPointTree> clouds,
                                    const OutwardNormals& outward) {
  std::vector<std::vector<Outward>> normals;
  for (std::size_t c = 0; c < clouds.size(); ++c) normals.push_back(outward(c));
  std::vector<VertexId> again;
  for (const VertexId v : overlooked) {
    const Point& p = model.mesh().points[v];
    double least = std::numeric_limits<double>::infinity();
    Vec3 facing;
    for (std::size_t c = 0; c < clouds.size(); ++c) {
      const NearestPoint nearest = clouds[c].nearest(p);
      if (!(nearest.squared_distance < least)) continue;
      least = nearest.squared_distance;
      facing = normals[c][nearest.point.index()].normal;
    }
    Vec3 sum;
    model.for_each_triangle_at(v, [&](TriangleId t) { sum = sum + model.normal(t); });
    if (dot(sum, facing) >= 0) again.push_back(v);
  }
  return again;
}

}  // namespace cocoon
