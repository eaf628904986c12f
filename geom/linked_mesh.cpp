#include "geom/linked_mesh.h"

#include <algorithm>
#include <numeric>

#include "geom/spatial_order.h"

namespace cocoon {
namespace {

bool repeats_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Returns what became of each vertex.
IdVector<VertexId, VertexId> copy_points(const TriangleMesh& mesh, LinkedMesh& linked,
                                         const Execution& execution) {
  IdVector<VertexId, VertexId> place(mesh.points.size());
  linked.points.reserve(mesh.points.size());
  linked.vertex_of.reserve(mesh.points.size());
  for (const PointId p : rough_order(mesh.points.span(), execution)) {
    const VertexId v(p.value);
    place[v] = linked.points.push_back(mesh.points[v]);
    linked.vertex_of.push_back(v);
  }
  return place;
}

// By a counting sort.
void copy_triangles(const TriangleMesh& mesh, const IdVector<VertexId, VertexId>& place,
                    LinkedMesh& linked) {
  std::vector<Triangle> proper;
  std::vector<TriangleId> ids;
  std::vector<std::uint32_t> places(mesh.points.size() + 1, 0);
  const auto smallest = [](const Triangle& t) { return std::min({t[0], t[1], t[2]}).index(); };
  proper.reserve(mesh.triangles.size());
  ids.reserve(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Triangle triangle{place[a], place[b], place[c]};
    if (repeats_vertex(triangle)) {
      linked.improper.push_back(triangle);
      linked.improper_of.push_back(t);
    } else {
      proper.push_back(triangle);
      ids.push_back(t);
      ++places[smallest(triangle) + 1];
    }
  }
  std::partial_sum(places.begin(), places.end(), places.begin());
  linked.triangles.resize(proper.size());
  linked.triangle_of.resize(proper.size());
  for (std::size_t k = 0; k < proper.size(); ++k) {
    const std::uint32_t to = places[smallest(proper[k])]++;
    linked.triangles[to] = proper[k];
    linked.triangle_of[to] = ids[k];
  }
}

void list_corners(LinkedMesh& linked) {
  std::vector<std::uint32_t>& begin = linked.corner_begin;
  begin.assign(linked.points.size() + 2, 0);
  for (const Triangle& triangle : linked.triangles) {
    for (const VertexId v : triangle) ++begin[v.index() + 2];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  linked.corners.resize(begin.back());
  SideId side = 0;
  for (const Triangle& triangle : linked.triangles) {
    for (const VertexId v : triangle) linked.corners[begin[v.index() + 1]++] = side++;
  }
  begin.pop_back();
}

}  // namespace

LinkedMesh link_mesh(const TriangleMesh& mesh, const Execution& execution) {
  require_valid_triangles(mesh);
  LinkedMesh linked;
  copy_triangles(mesh, copy_points(mesh, linked, execution), linked);
  linked.links = side_links(linked.triangles, linked.points.size(), execution);
  list_corners(linked);
  return linked;
}

}  // namespace cocoon
