#include "update/checks/closed_openings.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geom/messages/require_size.h"
#include "update/model/updated_vertices.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

struct OpenEdge {
  EdgeSide updated;  // its ends in the updated mesh
  VertexId low;      // in the model
  bool has_samples = false;
};

// Those that stay, in the order of `updated`.
std::vector<OpenEdge> open_edges(std::span<const EdgeSide> sides,
                                 const IdVector<VertexId, VertexId>& vertex_map) {
  std::vector<OpenEdge> edges;
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::upper_bound(begin, sides.end(), *begin);
    const VertexId a = vertex_map[begin->low];
    const VertexId b = vertex_map[begin->high];
    if (end - begin == 1 && !a.is_none() && !b.is_none()) {
      edges.push_back({{std::min(a, b), std::max(a, b)}, begin->low});
    }
    begin = end;
  }
  std::sort(edges.begin(), edges.end(),
            [](const OpenEdge& a, const OpenEdge& b) { return a.updated < b.updated; });
  return edges;
}

bool is_near(const TriangleMesh& updated, VertexId sample, const EdgeSide& edge, double reach) {
  const Point& a = updated.points[edge.low];
  const Point& b = updated.points[edge.high];
  return distance(updated.points[sample], (a + b) / 2) <= reach * distance(a, b);
}

void note_samples(const TriangleMesh& updated, VertexId first_of_clouds, double reach,
                  std::vector<OpenEdge>& edges) {
  for (const Triangle& t : updated.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] < first_of_clouds) continue;
      const VertexId a = t[(i + 1) % 3];
      const VertexId b = t[(i + 2) % 3];
      const EdgeSide side{std::min(a, b), std::max(a, b)};
      const auto edge = std::lower_bound(
          edges.begin(), edges.end(), side,
          [](const OpenEdge& e, const EdgeSide& value) { return e.updated < value; });
      if (edge == edges.end() || edge->updated != side) continue;
      if (is_near(updated, t[i], side, reach)) edge->has_samples = true;
    }
  }
}

}  // namespace

ClosedOpenings closed_openings(const ModelIndex& model, std::span<const EdgeSide> irregular,
                               const TriangleMesh& updated,
                               const IdVector<VertexId, VertexId>& vertex_map,
                               const ClosedOpeningOptions& options) {
  require_options("closed_openings", options);
  require_size("closed_openings", "vertices of the map", vertex_map.size(),
               model.mesh().points.size());
  ClosedOpenings found;
  std::vector<OpenEdge> edges = open_edges(irregular, vertex_map);
  if (edges.empty()) return found;
  note_samples(updated, first_vertex_of_clouds(vertex_map), options.reach, edges);
  for (const OpenEdge& edge : edges) {
    if (!edge.has_samples && found.edges++ == 0) found.at = edge.low;
  }
  return found;
}

}  // namespace cocoon
