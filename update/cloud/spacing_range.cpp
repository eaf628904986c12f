#include "update/cloud/spacing_range.h"

#include <cstdint>
#include <vector>

#include "geom/arrays/median.h"
#include "geom/id_vector.h"

namespace cocoon {

SpacingRange spacing_range(const TriangleMesh& surface) {
  IdVector<VertexId, double> sum(surface.points.size(), 0);
  IdVector<VertexId, std::uint32_t> edges(surface.points.size(), 0);
  for (const Triangle& t : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = t[i];
      const VertexId w = t[(i + 1) % 3];
      const double length = distance(surface.points[v], surface.points[w]);
      for (const VertexId end : {v, w}) {
        sum[end] += length;
        ++edges[end];
      }
    }
  }
  std::vector<double> means;
  means.reserve(sum.size());
  for (const VertexId v : sum.ids()) {
    if (edges[v] > 0) means.push_back(sum[v] / edges[v]);
  }
  if (means.empty()) return {};
  return {quantile_in_place(means, 0.1), quantile_in_place(means, 0.9)};
}

}  // namespace cocoon
