#include "update/model/orient_outward.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "cocone/orient_surface.h"
#include "geom/mesh/edge_components.h"
#include "geom/mesh/halfedges.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/mesh_measure.h"
#include "geom/random/mixed_bits.h"
#include "update/stage_options.h"

namespace cocoon {
namespace {

// Whether each halfedge has its opposite, told by a checksum: that of a mesh which is closed and
// oriented is 0, that of others with a probability of 2^-64. Linking all halfedges takes ten times
// as long, and nearly all models are as they should be.
bool halfedges_cancel(const TriangleMesh& mesh) {
  const auto word = [](VertexId from, VertexId to) {
    return mixed_bits(std::uint64_t{from.value} << 32 | to.value);
  };
  std::uint64_t sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += word(a, b) + word(b, c) + word(c, a) - word(b, a) - word(c, b) - word(a, c);
  }
  return sum == 0;
}

double volume_of(const TriangleMesh& mesh) {
  double sum = 0;
  const Point& apex = mesh.points[mesh.triangles[TriangleId(0)][0]];
  for (const TriangleId t : mesh.triangles.ids()) sum += volume_over(mesh, t, apex);
  return sum;
}

// What is measured of each part.
struct Part {
  // Of the open edges; of a closed part any of its points.
  Point center() const {
    return open_edges > 0 ? sum_of_middles / static_cast<double>(open_edges) : corner;
  }
  Point corner;
  Vec3 sum_of_middles;  // of the open edges
  std::size_t open_edges = 0;
  double open_length = 0;
  double area = 0;
  double volume = 0;
  bool is_body = false;
};

void measure_openings(const TriangleMesh& mesh, const HalfedgeRings& rings,
                      const EdgeComponents& found, std::vector<Part>& parts) {
  for (const TriangleId t : mesh.triangles.ids()) {
    Part& part = parts[found.component_of[t.index()]];
    part.corner = mesh.points[mesh.triangles[t][0]];
    for (std::size_t i = 0; i < 3; ++i) {
      const Halfedge halfedge = halfedge_of(t, i);
      if (!rings.has_edge(halfedge) || rings.has_two_triangles(halfedge)) continue;
      const auto [from, to] = ends_of_halfedge(mesh, halfedge);
      const Point& a = mesh.points[from];
      const Point& b = mesh.points[to];
      part.sum_of_middles = part.sum_of_middles + 0.5 * (a + b);
      part.open_length += distance(a, b);
      ++part.open_edges;
    }
  }
}

std::vector<Part> measure(const TriangleMesh& mesh, const HalfedgeRings& rings,
                          const EdgeComponents& found, const OrientOutwardOptions& options) {
  std::vector<Part> parts(found.components.size());
  measure_openings(mesh, rings, found, parts);
  for (const TriangleId t : mesh.triangles.ids()) {
    Part& part = parts[found.component_of[t.index()]];
    part.area += area_of(mesh, t);
    part.volume += volume_over(mesh, t, part.center());
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Part& part = parts[k];
    part.is_body = !found.components[k].is_contradictory &&
                   part.open_length * part.open_length < options.max_opening * part.area;
  }
  return parts;
}

// Whether the triangles of each part are turned once more, all of them.
std::vector<std::uint8_t> parts_to_turn(const EdgeComponents& found,
                                        const std::vector<Part>& parts) {
  const auto was_at_odds = [&](std::size_t k) { return found.components[k].turned > 0; };
  double sum = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].is_body) sum += was_at_odds(k) ? std::abs(parts[k].volume) : parts[k].volume;
  }
  std::vector<std::uint8_t> turns(parts.size(), 0);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].is_body) turns[k] = (was_at_odds(k) ? parts[k].volume : sum) < 0 ? 1 : 0;
  }
  return turns;
}

}  // namespace

OutwardReport orient_outward(TriangleMesh& mesh, const OrientOutwardOptions& options) {
  require_options("orient_outward", options);
  require_valid_triangles(mesh);
  if (mesh.triangles.empty() || (halfedges_cancel(mesh) && volume_of(mesh) >= 0)) return {};
  const HalfedgeRings rings = link_halfedges(mesh);
  const EdgeComponents found = edge_components(mesh, rings);
  const IdVector<TriangleId, Triangle> given = mesh.triangles;
  OutwardReport report;
  report.one_sided = orient_surface(mesh, found).non_orientable;
  const std::vector<std::uint8_t> turns =
      parts_to_turn(found, measure(mesh, rings, found, options));
  for (const TriangleId t : mesh.triangles.ids()) {
    Triangle& triangle = mesh.triangles[t];
    if (turns[found.component_of[t.index()]] != 0) std::swap(triangle[1], triangle[2]);
    report.turned += triangle != given[t] ? 1U : 0U;
  }
  return report;
}

}  // namespace cocoon
