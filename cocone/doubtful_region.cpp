#include "cocone/doubtful_region.h"

#include <algorithm>

namespace cocoon {
namespace {

std::vector<VertexId> doubtful_vertices(const Triangulation& triangulation,
                                        const CellMarks& marks) {
  struct Place {
    double x;  // decides nearly always
    VertexId vertex;
  };
  std::vector<Place> places;
  for (const VertexId v : triangulation.vertices()) {
    if (marks.good[v] != 0 && marks.conflicts == 0) continue;
    places.push_back({triangulation.point(v).x, v});
  }
  std::sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
    if (a.x != b.x) return a.x < b.x;
    return triangulation.point(a.vertex) < triangulation.point(b.vertex);
  });
  std::vector<VertexId> vertices;
  vertices.reserve(places.size());
  for (const Place& place : places) vertices.push_back(place.vertex);
  return vertices;
}

}  // namespace

DoubtfulRegion find_doubtful_region(const Triangulation& triangulation, const CellMarks& marks) {
  DoubtfulRegion region;
  region.vertices = doubtful_vertices(triangulation, marks);
  region.rank = ZeroedArray<VertexId, std::uint32_t>(triangulation.num_vertices());
  for (std::uint32_t k = 0; k < region.vertices.size(); ++k) {
    region.rank[region.vertices[k]] = k + 1;
  }
  for (const CellId c : triangulation.cells()) {
    const auto& vertices = triangulation.cell(c).vertices;
    const bool doubtful = std::any_of(vertices.begin(), vertices.end(),
                                      [&](VertexId v) { return region.contains(v); });
    if (!doubtful) continue;
    region.cells.push_back(c);
    if (triangulation.is_infinite(c)) continue;
    const bool decided = std::any_of(vertices.begin(), vertices.end(),
                                     [&](VertexId v) { return marks.good[v] != 0; });
    if (!decided) region.undecided.push_back(c);
  }
  return region;
}

}  // namespace cocoon
