#include "cocone/local_facets.h"

#include <algorithm>

namespace cocoon {

VertexId LocalFacets::local(VertexId in_whole) const {
  const auto found = std::lower_bound(vertex_in_whole.begin(), vertex_in_whole.end(), in_whole);
  if (found == vertex_in_whole.end() || *found != in_whole) return {};
  return VertexId(static_cast<std::size_t>(found - vertex_in_whole.begin()));
}

LocalFacets FacetCollector::link(const DynamicDelaunay& delaunay, std::vector<FacetId> facets) {
  std::sort(facets.begin(), facets.end());
  const TriangulationView view = delaunay.view();
  LocalFacets local;
  LinkedFacets& triangles = local.triangles;
  triangles.facets = std::move(facets);
  std::vector<VertexId> vertices;
  for (const FacetId f : triangles.facets) {
    triangles.mirrors.push_back(view.mirror(f));
    triangles.corners.push_back(view.facet_vertices(f));
    const Triangle& corners = triangles.corners.back();
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  IdVector<VertexId, Point> points;
  vertex_here_.resize(delaunay.num_vertex_slots());
  for (const VertexId v : vertices) vertex_here_[v] = points.push_back(view.point(v));
  local.vertex_in_whole = IdVector<VertexId, VertexId>(std::move(vertices));
  for (Triangle& corners : triangles.corners) {
    for (VertexId& v : corners) v = vertex_here_[v];
  }
  link_corners(points, triangles);
  return local;
}

}  // namespace cocoon
