#include "geom/linked_mesh.h"

#include <algorithm>
#include <span>

#include "geom/parallel_list.h"
#include "geom/sort_by_vertex.h"
#include "geom/spatial_order.h"

namespace cocoon {
namespace {

// Returns what became of each vertex.
IdVector<VertexId, VertexId> copy_points(const TriangleMesh& mesh, LinkedMesh& linked,
                                         const Execution& execution) {
  IdVector<VertexId, VertexId> place(mesh.points.size());
  linked.points.resize(mesh.points.size());
  linked.vertex_of.resize(mesh.points.size());
  const std::vector<PointId> order = rough_order(mesh.points.span(), execution);
  constexpr std::size_t points_per_chunk = std::size_t{1} << 14;
  parallel_chunks(execution, order.size(), points_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (VertexId to(begin); to.index() < end; ++to) {
                      const VertexId v(order[to.index()].value);
                      place[v] = to;
                      linked.points[to] = mesh.points[v];
                      linked.vertex_of[to] = v;
                    }
                  });
  return place;
}

void copy_triangles(const TriangleMesh& mesh, const IdVector<VertexId, VertexId>& place,
                    LinkedMesh& linked, const Execution& execution) {
  const auto copy_of = [&](TriangleId t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return Triangle{place[a], place[b], place[c]};
  };
  sort_by_vertex(
      mesh.triangles.size(), mesh.points.size(), execution,
      [&](std::size_t count) {
        linked.triangles.resize(count);
        linked.triangle_of.resize(count);
      },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (TriangleId t(begin); t.index() < end; ++t) {
          const Triangle triangle = copy_of(t);
          if (repeats_a_vertex(triangle)) continue;
          put(std::min({triangle[0], triangle[1], triangle[2]}), [&](std::uint32_t to) {
            linked.triangles[to] = triangle;
            linked.triangle_of[to] = t;
          });
        }
      });
  if (linked.triangles.size() == mesh.triangles.size()) return;
  for (const TriangleId t : mesh.triangles.ids()) {
    if (!repeats_a_vertex(mesh.triangles[t])) continue;
    linked.improper.push_back(copy_of(t));
    linked.improper_of.push_back(t);
  }
}

void list_corners(LinkedMesh& linked, const Execution& execution) {
  linked.corner_begin = sort_by_vertex(
      linked.triangles.size(), linked.points.size(), execution,
      [&](std::size_t count) { linked.corners.resize(count); },
      [&](std::size_t begin, std::size_t end, auto put) {
        auto side = static_cast<SideId>(3 * begin);
        for (const Triangle& triangle : std::span(linked.triangles).subspan(begin, end - begin)) {
          for (const VertexId v : triangle) {
            put(v, [&](std::uint32_t to) { linked.corners[to] = side; });
            ++side;
          }
        }
      });
}

std::vector<SideId> irregular_edges(const LinkedMesh& mesh, const Execution& execution) {
  constexpr std::size_t sides_per_chunk = std::size_t{1} << 14;
  return parallel_list<SideId>(execution, mesh.links.size(), sides_per_chunk,
                               [&](std::size_t begin, std::size_t end, std::vector<SideId>& found) {
                                 for (auto side = static_cast<SideId>(begin); side < end; ++side) {
                                   const SideId across = mesh.links[side];
                                   const bool regular = across != side &&
                                                        mesh.links[across] == side &&
                                                        mesh.from(side) == mesh.to(across) &&
                                                        mesh.apex(side) != mesh.apex(across);
                                   if (!regular && mesh.is_first(side)) found.push_back(side);
                                 }
                               });
}

}  // namespace

LinkedMesh link_mesh(const TriangleMesh& mesh, const Execution& execution) {
  require_valid_triangles(mesh);
  LinkedMesh linked;
  copy_triangles(mesh, copy_points(mesh, linked, execution), linked, execution);
  linked.links = side_links(linked.triangles, linked.points.size(), execution);
  linked.irregular = irregular_edges(linked, execution);
  list_corners(linked, execution);
  return linked;
}

}  // namespace cocoon
