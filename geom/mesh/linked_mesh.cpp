#include "geom/mesh/linked_mesh.h"

#include <algorithm>
#include <span>

#include "geom/arrays/sort_by_vertex.h"
#include "geom/arrays/visit_where.h"
#include "geom/parallel/parallel_list.h"
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

// Returns where the triangles of each smallest vertex begin.
std::vector<std::uint32_t> copy_triangles(const TriangleMesh& mesh,
                                          const IdVector<VertexId, VertexId>& place,
                                          LinkedMesh& linked, const Execution& execution) {
  const auto copy_of = [&](TriangleId t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return Triangle{place[a], place[b], place[c]};
  };
  struct Copy {
    TriangleId original;
    Triangle triangle;
  };
  std::vector<std::uint32_t> begins = sort_by_vertex<Copy>(
      mesh.triangles.size(), mesh.points.size(), execution,
      [&](std::size_t count) {
        linked.triangles.resize(count);
        linked.triangle_of.resize(count);
      },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (TriangleId t(begin); t.index() < end; ++t) {
          const Triangle triangle = copy_of(t);
          if (repeats_a_vertex(triangle)) continue;
          put(std::min({triangle[0], triangle[1], triangle[2]}), Copy{t, triangle});
        }
      },
      [&](std::uint32_t to) {
        __builtin_prefetch(&linked.triangles[to], 1);
        __builtin_prefetch(&linked.triangle_of[to], 1);
      },
      [&](std::uint32_t to, const Copy& copy) {
        linked.triangles[to] = copy.triangle;
        linked.triangle_of[to] = copy.original;
      });
  if (linked.triangles.size() == mesh.triangles.size()) return begins;
  for (const TriangleId t : mesh.triangles.ids()) {
    if (!repeats_a_vertex(mesh.triangles[t])) continue;
    linked.improper.push_back(copy_of(t));
    linked.improper_of.push_back(t);
  }
  return begins;
}

void list_corners(LinkedMesh& linked, const Execution& execution) {
  linked.corner_begin = sort_by_vertex(
      linked.triangles.size(), linked.points.size(), execution,
      [&](std::size_t count) { linked.corners.resize(count); },
      [&](std::size_t begin, std::size_t end, auto put) {
        auto halfedge = static_cast<Halfedge>(3 * begin);
        for (const Triangle& triangle : std::span(linked.triangles).subspan(begin, end - begin)) {
          for (const VertexId v : triangle) {
            put(v, [&](std::uint32_t to) { linked.corners[to] = halfedge; });
            ++halfedge;
          }
        }
      });
}

// Of edges with more than two triangles, all halfedges but the last are in the list: only the first
// stays. One ring after the other, since to ask each halfedge whether it is the first takes a walk.
void keep_first_of_edges(const LinkedMesh& mesh, std::vector<Halfedge>& irregular) {
  const auto has_others_behind = [&](Halfedge halfedge) {
    return mesh.links[halfedge] > halfedge && mesh.links[mesh.links[halfedge]] != halfedge;
  };
  if (std::none_of(irregular.begin(), irregular.end(), has_others_behind)) return;
  std::vector<bool> is_met(mesh.links.size(), false);
  std::erase_if(irregular, [&](Halfedge halfedge) {
    if (is_met[halfedge]) return true;
    for_each_at_edge(mesh.links, halfedge, [&](Halfedge other) { is_met[other] = true; });
    return false;
  });
}

// A regular edge is looked at from its first halfedge.
std::vector<Halfedge> irregular_edges(const LinkedMesh& mesh, const Execution& execution) {
  constexpr std::size_t halfedges_per_chunk = std::size_t{1} << 14;
  const auto find = [&](std::size_t begin, std::size_t end, std::vector<Halfedge>& found) {
    const auto is_first = [&](Halfedge halfedge) {
      const Halfedge across = mesh.links[halfedge];
      __builtin_prefetch(&mesh.links[across]);
      __builtin_prefetch(&mesh.triangles[triangle_of_halfedge(across)]);
      return across >= halfedge;
    };
    const auto note_irregular = [&](Halfedge halfedge) {
      const Halfedge across = mesh.links[halfedge];
      const bool regular = across != halfedge && mesh.links[across] == halfedge &&
                           mesh.from(halfedge) == mesh.to(across) &&
                           mesh.apex(halfedge) != mesh.apex(across);
      if (!regular) found.push_back(halfedge);
    };
    visit_every_other(static_cast<Halfedge>(begin), static_cast<Halfedge>(end), is_first,
                      note_irregular);
  };
  std::vector<Halfedge> irregular =
      parallel_list<Halfedge>(execution, mesh.links.size(), halfedges_per_chunk, find);
  keep_first_of_edges(mesh, irregular);
  return irregular;
}

}  // namespace

LinkedMesh link_mesh(const TriangleMesh& mesh, const Execution& execution) {
  require_valid_triangles(mesh);
  LinkedMesh linked;
  {
    const std::vector<std::uint32_t> begins =
        copy_triangles(mesh, copy_points(mesh, linked, execution), linked, execution);
    linked.links = halfedge_links(linked.triangles, begins, execution);
  }
  linked.irregular = irregular_edges(linked, execution);
  list_corners(linked, execution);
  return linked;
}

}  // namespace cocoon
