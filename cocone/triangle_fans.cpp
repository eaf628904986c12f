#include "cocone/triangle_fans.h"

#include <algorithm>
#include <utility>

namespace cocoon {
namespace {

constexpr std::size_t triangles_per_chunk = 8192;

std::array<VertexId, 3> in_lexicographic_order(const Triangulation& triangulation,
                                               std::array<VertexId, 3> v) {
  const auto less = [&](VertexId a, VertexId b) {
    return triangulation.point(a) < triangulation.point(b);
  };
  if (less(v[1], v[0])) std::swap(v[0], v[1]);
  if (less(v[2], v[1])) std::swap(v[1], v[2]);
  if (less(v[1], v[0])) std::swap(v[0], v[1]);
  return v;
}

}  // namespace

TriangleFans triangle_fans(const Triangulation& triangulation, const FacetSet& facets,
                           const Execution& execution) {
  TriangleFans fans;
  facets.for_each(triangulation, [&](FacetId f) { fans.facets.push_back(f); });
  // corners and normals
  fans.corners.resize(fans.size());
  fans.normals.resize(fans.size());
  parallel_chunks(
      execution, fans.size(), triangles_per_chunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          fans.corners[t] =
              in_lexicographic_order(triangulation, triangulation.facet_vertices(fans.facets[t]));
          const Point& a = triangulation.point(fans.corners[t][0]);
          fans.normals[t] = unit(cross(triangulation.point(fans.corners[t][1]) - a,
                                       triangulation.point(fans.corners[t][2]) - a));
        }
      });
  // count, then place
  fans.offsets.assign(triangulation.num_vertices() + 1, 0);
  for (const auto& corners : fans.corners) {
    for (const VertexId v : corners) ++fans.offsets[v.index() + 1];
  }
  for (std::size_t v = 1; v < fans.offsets.size(); ++v) fans.offsets[v] += fans.offsets[v - 1];
  fans.triangles.resize(3 * fans.size());
  std::vector<std::uint32_t> next(fans.offsets.begin(), fans.offsets.end() - 1);
  for (std::size_t t = 0; t < fans.size(); ++t) {
    for (const VertexId v : fans.corners[t]) {
      fans.triangles[next[v.index()]++] = static_cast<std::uint32_t>(t);
    }
  }
  return fans;
}

void collect_spokes(const TriangleFans& fans, VertexId center, std::vector<Spoke>& spokes) {
  spokes.clear();
  std::uint32_t local = 0;
  for (const std::uint32_t t : fans.around(center)) {
    const std::array<VertexId, 3>& corners = fans.corners[t];
    const std::size_t i = corners[0] == center ? 0 : corners[1] == center ? 1 : 2;
    spokes.push_back({corners[(i + 1) % 3], t, local, 1.0});
    spokes.push_back({corners[(i + 2) % 3], t, local, -1.0});
    ++local;
  }
  // A dozen elements: insertion beats the general sort.
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    const Spoke spoke = spokes[i];
    if (i == 48) {
      std::sort(spokes.begin(), spokes.end(),
                [](const Spoke& a, const Spoke& b) { return a.other < b.other; });
      return;
    }
    std::size_t k = i;
    for (; k > 0 && spoke.other < spokes[k - 1].other; --k) spokes[k] = spokes[k - 1];
    spokes[k] = spoke;
  }
}

}  // namespace cocoon
