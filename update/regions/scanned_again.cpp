#include "update/regions/scanned_again.h"

#include <limits>

#include "geom/messages/require_size.h"

namespace cocoon {

namespace {

Vec3 sum_of_normals(const ModelIndex& model, VertexId v) {
  Vec3 sum;
  for (const TriangleId t : model.triangles_at(v)) sum = sum + model.normal(t);
  return sum;
}

}  // namespace

std::vector<VertexId> scanned_again(const ModelIndex& model, std::span<const VertexId> vertices,
                                    std::span<const NearestPointTree> clouds,
                                    const OutwardNormals& outward) {
  std::vector<std::vector<Outward>> normals;
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    normals.push_back(outward(c));
    require_size("scanned_again", "normals of samples", normals[c].size(), clouds[c].size());
  }
  std::vector<VertexId> again;
  for (const VertexId v : vertices) {
    const Vec3 normal = sum_of_normals(model, v);
    double least = std::numeric_limits<double>::infinity();
    bool faces_away = false;
    for (std::size_t c = 0; c < clouds.size(); ++c) {
      const NearestPoint nearest = clouds[c].nearest(model.mesh().points[v]);
      if (nearest.squared_distance > least) continue;
      const bool is_away = dot(normal, normals[c][nearest.point.index()].normal) < 0;
      faces_away = is_away && (faces_away || nearest.squared_distance < least);
      least = nearest.squared_distance;
    }
    if (!faces_away) again.push_back(v);
  }
  return again;
}

}  // namespace cocoon
