#include "cocone/live/local_facets.h"

#include <algorithm>

#include "geom/arrays/sort_ids.h"

namespace cocoon {

VertexId LocalFacets::local(VertexId in_whole) const {
  const auto found = std::lower_bound(vertex_in_whole.begin(), vertex_in_whole.end(), in_whole);
  if (found == vertex_in_whole.end() || *found != in_whole) return {};
  return VertexId(static_cast<std::size_t>(found - vertex_in_whole.begin()));
}

LocalFacets FacetCollector::link(const TriangulationView& view, std::vector<FacetId> facets) {
  sort_ids(facets);
  LocalFacets local;
  LinkedFacets& triangles = local.triangles;
  triangles.facets.assign(facets.begin(), facets.end());
  triangles.mirrors.reserve(triangles.facets.size());
  triangles.corners.reserve(triangles.facets.size());
  vertex_here_.resize(view.points().size());
  std::vector<VertexId> vertices;
  for (const FacetId f : triangles.facets) {
    triangles.mirrors.push_back(view.mirror(f));
    triangles.corners.push_back(view.facet_vertices(f));
    for (const VertexId v : triangles.corners.back()) {
      if (!vertex_here_[v].is_none()) continue;
      vertex_here_[v] = v;  // listed
      vertices.push_back(v);
    }
  }
  sort_ids(vertices);
  IdVector<VertexId, Point> points;
  points.reserve(vertices.size());
  for (const VertexId v : vertices) vertex_here_[v] = points.push_back(view.point(v));
  local.vertex_in_whole = IdVector<VertexId, VertexId>(std::move(vertices));
  for (Triangle& corners : triangles.corners) {
    for (VertexId& v : corners) v = vertex_here_[v];
  }
  for (const VertexId v : local.vertex_in_whole) vertex_here_[v] = VertexId();
  link_corners(points, triangles);
  return local;
}

}  // namespace cocoon
