#include "cocone/linked_facets.h"

#include <algorithm>
#include <utility>

namespace cocoon {
namespace {

constexpr std::size_t triangles_per_chunk = 8192;

// The unit normal of the corners in lexicographic order, turned as the corners run.
Vec3 oriented_normal(const IdVector<VertexId, Point>& points, const Triangle& corners) {
  std::array<Point, 3> p = {points[corners[0]], points[corners[1]], points[corners[2]]};
  bool turned = false;
  const auto order = [&](std::size_t i, std::size_t k) {
    if (!(p[k] < p[i])) return;
    std::swap(p[i], p[k]);
    turned = !turned;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  const Vec3 normal = unit(cross(p[1] - p[0], p[2] - p[0]));
  return turned ? -normal : normal;
}

VertexId smallest(const Triangle& corners) {
  return std::min({corners[0], corners[1], corners[2]});
}

// Facets, mirrors and corners, by a counting sort.
LinkedFacets by_smallest_vertex(const Triangulation& triangulation, const FacetSet& facets) {
  std::vector<std::uint32_t> places(triangulation.num_vertices() + 1, 0);
  std::vector<FacetId> found;
  facets.for_each(triangulation, [&](FacetId f) {
    found.push_back(f);
    ++places[smallest(triangulation.facet_vertices(f)).index() + 1];
  });
  for (std::size_t v = 1; v < places.size(); ++v) places[v] += places[v - 1];
  LinkedFacets triangles;
  triangles.facets.resize(found.size());
  triangles.mirrors.resize(found.size());
  triangles.corners.resize(found.size());
  for (const FacetId f : found) {
    const Triangle corners = triangulation.facet_vertices(f);
    const std::uint32_t t = places[smallest(corners).index()]++;
    triangles.facets[t] = f;
    triangles.mirrors[t] = triangulation.mirror(f);
    triangles.corners[t] = corners;
  }
  return triangles;
}

}  // namespace

void link_corners(const IdVector<VertexId, Point>& points, LinkedFacets& triangles,
                  const Execution& execution) {
  // First: its scratch memory is as large as the normals.
  triangles.links = side_links(triangles.corners, points.size(), execution);
  triangles.normals.resize(triangles.size());
  parallel_chunks(execution, triangles.size(), triangles_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t t = begin; t < end; ++t) {
                      triangles.normals[t] = oriented_normal(points, triangles.corners[t]);
                    }
                  });
}

LinkedFacets link_facets(const Triangulation& triangulation, FacetSet facets,
                         const Execution& execution) {
  LinkedFacets triangles = by_smallest_vertex(triangulation, facets);
  link_corners(triangulation.points(), triangles, execution);
  triangles.set = std::move(facets);
  return triangles;
}

LinkedFacets without(const Triangulation& triangulation, LinkedFacets triangles,
                     const std::vector<std::uint8_t>& removed) {
  // Where each triangle goes; what stays moves up.
  std::vector<std::uint32_t> place(triangles.size());
  std::uint32_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (removed[t] != 0) triangles.set.erase(triangulation, triangles.facets[t]);
    place[t] = kept;
    kept += removed[t] == 0 ? 1U : 0U;
  }
  if (kept == triangles.size()) return triangles;
  // Rings close over the gaps. A side moves to a place that was read already.
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (removed[t] != 0) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      SideId next = triangles.links[3 * t + i];
      while (removed[triangle_of_side(next)] != 0) next = triangles.links[next];
      triangles.links[3 * t + i] = 3 * place[triangle_of_side(next)] + corner_of_side(next);
    }
  }
  for (std::size_t t = 0; t < place.size(); ++t) {
    if (removed[t] != 0) continue;
    const std::size_t to = place[t];
    triangles.facets[to] = triangles.facets[t];
    triangles.mirrors[to] = triangles.mirrors[t];
    triangles.corners[to] = triangles.corners[t];
    triangles.normals[to] = triangles.normals[t];
    for (std::size_t i = 0; i < 3; ++i) triangles.links[3 * to + i] = triangles.links[3 * t + i];
  }
  triangles.facets.resize(kept);
  triangles.mirrors.resize(kept);
  triangles.corners.resize(kept);
  triangles.normals.resize(kept);
  triangles.links.resize(3 * std::size_t{kept});
  return triangles;
}

}  // namespace cocoon
