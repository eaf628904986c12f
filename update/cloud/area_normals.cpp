#include "update/cloud/area_normals.h"

#include <algorithm>

#include "geom/triangle_normal.h"

namespace cocoon {

IdVector<VertexId, Vec3> area_normals(const TriangleMesh& mesh) {
  IdVector<VertexId, Vec3> normals(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 twice_area = area_normal(mesh.points[a], mesh.points[b], mesh.points[c]);
    for (const VertexId v : {a, b, c}) normals[v] = normals[v] + twice_area;
  }
  for (Vec3& normal : normals) normal = unit(normal);
  return normals;
}

std::vector<Vec3> area_normals_of_parts(const TriangleMesh& mesh,
                                        std::span<const std::uint32_t> part_of,
                                        std::span<const VertexOfPart> wanted) {
  std::vector<VertexOfPart> sorted(wanted.begin(), wanted.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  IdVector<VertexId, std::uint8_t> is_wanted(mesh.points.size(), 0);
  for (const VertexOfPart& corner : sorted) is_wanted[corner.vertex] = 1;
  const auto position_of = [&](const VertexOfPart& corner) {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), corner) -
                                    sorted.begin());
  };
  std::vector<Vec3> sums(sorted.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto& [a, b, c] = mesh.triangles[t];
    if ((is_wanted[a] | is_wanted[b] | is_wanted[c]) == 0) continue;
    const Vec3 twice_area = area_normal(mesh.points[a], mesh.points[b], mesh.points[c]);
    for (const VertexId v : {a, b, c}) {
      if (is_wanted[v] == 0) continue;
      const VertexOfPart corner{v, part_of[t.index()]};
      const std::size_t k = position_of(corner);
      if (k < sorted.size() && sorted[k] == corner) sums[k] = sums[k] + twice_area;
    }
  }
  std::vector<Vec3> normals;
  normals.reserve(wanted.size());
  for (const VertexOfPart& corner : wanted) normals.push_back(unit(sums[position_of(corner)]));
  return normals;
}

}  // namespace cocoon
