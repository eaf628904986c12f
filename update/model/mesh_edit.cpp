#include "update/model/mesh_edit.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geom/arrays/edited_ids.h"
#include "geom/arrays/sort_ids.h"
#include "geom/mesh/triangle_order.h"

namespace cocoon {
namespace {

// Where the element was that stays while others go from a list; what comes, comes behind them.
// Complexity: O(log removed).
VertexId place_before(VertexId after, const std::vector<VertexId>& removed) {
  std::size_t low = 0;  // so many of the removed came before it
  std::size_t high = removed.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (removed[middle].index() - middle <= after.index()) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return VertexId(after.index() + low);
}

// All triangles at some vertices, ascending.
std::vector<TriangleId> triangles_at(const ModelIndex& index, std::span<const VertexId> vertices) {
  std::vector<TriangleId> found;
  for (const VertexId v : vertices) {
    index.for_each_triangle_at(v, [&](TriangleId t) { found.push_back(t); });
  }
  make_set(found);
  return found;
}

class EditFinder {
 public:
  EditFinder(const TriangleMesh& mesh, const ListEdit<VertexId>& vertices,
             const IdVector<VertexId, VertexId>& vertex_map)
      : mesh_(mesh),
        removed_(vertices.removed),
        vertex_map_(vertex_map),
        num_kept_(mesh.points.size() - vertices.removed.size()) {}

  // Compares triangles before, ascending, with those after, in canonical order.
  void compare(std::span<const TriangleId> old, std::span<const Triangle> now, MeshEdit& edit) {
    auto next = now.begin();
    for (const TriangleId id : old) {
      const Triangle t = after(mesh_.triangles[id]);
      const bool stays = !t[0].is_none() && !t[1].is_none() && !t[2].is_none();
      for (; stays && next != now.end() && precedes(*next, t); ++next) edit.added.push_back(*next);
      if (stays && next != now.end() && *next == t) {
        ++next;
      } else {
        edit.triangles.removed.push_back(id);
        edit.removed.push_back(mesh_.triangles[id]);
      }
    }
    edit.added.insert(edit.added.end(), next, now.end());
    place(edit);
  }

 private:
  Triangle after(const Triangle& t) const {
    return {vertex_map_[t[0]], vertex_map_[t[1]], vertex_map_[t[2]]};
  }

  // Where the added triangles come to lie.
  void place(MeshEdit& edit) const {
    auto removed = edit.triangles.removed.begin();
    for (const Triangle& t : edit.added) {
      const TriangleId behind = first_behind(t, edit.triangles.removed);
      removed = std::lower_bound(removed, edit.triangles.removed.end(), behind);
      const auto gone = static_cast<std::size_t>(removed - edit.triangles.removed.begin());
      edit.triangles.added.push_back(
          TriangleId(behind.index() - gone + edit.triangles.added.size()));
    }
  }

  // The first old triangle that stays and does not precede t, or the end.
  TriangleId first_behind(const Triangle& t, const std::vector<TriangleId>& removed) const {
    const auto begin = mesh_.triangles.begin();
    const auto end = mesh_.triangles.end();
    if (t[0].index() >= num_kept_) return TriangleId(mesh_.triangles.size());
    const VertexId first = place_before(t[0], removed_);
    auto at = std::partition_point(begin, end, [&](const Triangle& o) { return o[0] < first; });
    for (; at != end && (*at)[0] == first; ++at) {
      const TriangleId id(static_cast<std::size_t>(at - begin));
      if (!std::binary_search(removed.begin(), removed.end(), id) && !precedes(after(*at), t))
        break;
    }
    return TriangleId(static_cast<std::size_t>(at - begin));
  }

  const TriangleMesh& mesh_;
  const std::vector<VertexId>& removed_;
  const IdVector<VertexId, VertexId>& vertex_map_;
  std::size_t num_kept_;
};

}  // namespace

MeshEdit MeshEdit::reversed() const {
  return {vertices.reversed(), added_points, removed_points, triangles.reversed(), added, removed};
}

MeshEdit mesh_edit(const ModelIndex& before, ListEdit<VertexId> vertices,
                   const IdVector<VertexId, VertexId>& vertex_map,
                   std::span<const Point> added_points, std::span<const VertexId> touched,
                   std::span<const Triangle> triangles) {
  MeshEdit edit;
  edit.vertices = std::move(vertices);
  edit.added_points.assign(added_points.begin(), added_points.end());
  for (const VertexId v : edit.vertices.removed) {
    edit.removed_points.push_back(before.mesh().points[v]);
  }
  EditFinder(before.mesh(), edit.vertices, vertex_map)
      .compare(triangles_at(before, touched), triangles, edit);
  return edit;
}

bool leads_to(const MeshEdit& edit, const ModelIndex& after,
              const IdVector<VertexId, VertexId>& vertex_map, std::span<const VertexId> touched,
              std::span<const Triangle> triangles) {
  std::vector<VertexId> now = edit.vertices.added;
  for (const VertexId v : touched) {
    if (!vertex_map[v].is_none()) now.push_back(vertex_map[v]);
  }
  make_set(now);
  const auto all_have_one_of = [](std::span<const VertexId> vertices,
                                  std::span<const Triangle> changed) {
    return std::all_of(changed.begin(), changed.end(), [&](const Triangle& t) {
      return std::any_of(t.begin(), t.end(), [&](VertexId v) {
        return std::binary_search(vertices.begin(), vertices.end(), v);
      });
    });
  };
  if (!all_have_one_of(touched, edit.removed) || !all_have_one_of(now, edit.added)) return false;
  const std::vector<TriangleId> found = triangles_at(after, now);
  return std::equal(
      found.begin(), found.end(), triangles.begin(), triangles.end(),
      [&](TriangleId t, const Triangle& u) { return after.mesh().triangles[t] == u; });
}

void edit_triangles(IdVector<TriangleId, Triangle>& triangles, const MeshEdit& edit,
                    const IdVector<VertexId, VertexId>& vertex_map) {
  const EditedIds<VertexId> vertices(edit.vertices, vertex_map);
  edit_list_by_blocks(triangles, edit.triangles, edit.added,
                      [&](std::span<Triangle> block) { return vertices.renew(block); });
}

}  // namespace cocoon
