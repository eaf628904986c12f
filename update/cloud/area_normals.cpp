#include "update/cloud/area_normals.h"

#include "geom/triangle_normal.h"

namespace cocoon {

IdVector<VertexId, Vec3> area_normals(const TriangleMesh& mesh,
                                      const IdVector<VertexId, std::uint8_t>& wanted) {
  IdVector<VertexId, Vec3> sums(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    if ((wanted[a] | wanted[b] | wanted[c]) == 0) continue;
    const Vec3 twice_area = area_normal(mesh.points[a], mesh.points[b], mesh.points[c]);
    for (const VertexId v : {a, b, c}) {
      if (wanted[v] != 0) sums[v] = sums[v] + twice_area;
    }
  }
  for (const VertexId v : sums.ids()) {
    if (wanted[v] != 0) sums[v] = unit(sums[v]);
  }
  return sums;
}

}  // namespace cocoon
