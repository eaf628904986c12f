#include "update/mesh_change.h"

#include <algorithm>
#include <utility>

namespace cocoon {
namespace {

void rotate_smallest_first(Triangle& t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
}

// A triangle of the old mesh in the numbers of the new one.
struct Mapped {
  Triangle triangle;
  TriangleId source;
  friend bool operator<(const Mapped& a, const Mapped& b) {
    return a.triangle != b.triangle ? a.triangle < b.triangle : a.source < b.source;
  }
};

void sort_unless_sorted(auto& list) {
  if (!std::is_sorted(list.begin(), list.end())) std::sort(list.begin(), list.end());
}

}  // namespace

MeshChange mesh_change(const TriangleMesh& before, const TriangleMesh& after,
                       IdVector<VertexId, VertexId> vertex_map) {
  MeshChange change;
  std::vector<Mapped> old;
  old.reserve(before.triangles.size());
  for (const TriangleId t : before.triangles.ids()) {
    const auto& [a, b, c] = before.triangles[t];
    Mapped mapped{{vertex_map[a], vertex_map[b], vertex_map[c]}, t};
    if (mapped.triangle[0].is_none() || mapped.triangle[1].is_none() ||
        mapped.triangle[2].is_none()) {
      change.removed.push_back(before.triangles[t]);
      continue;
    }
    rotate_smallest_first(mapped.triangle);
    old.push_back(mapped);
  }
  sort_unless_sorted(old);
  std::vector<Triangle> now = after.triangles.raw();
  for (Triangle& t : now) rotate_smallest_first(t);
  sort_unless_sorted(now);

  auto next = old.begin();
  for (const Triangle& t : now) {
    for (; next != old.end() && next->triangle < t; ++next) {
      change.removed.push_back(before.triangles[next->source]);
    }
    if (next != old.end() && next->triangle == t) {
      ++next;
    } else {
      change.added.push_back(t);
    }
  }
  for (; next != old.end(); ++next) change.removed.push_back(before.triangles[next->source]);
  for (Triangle& t : change.removed) rotate_smallest_first(t);
  std::sort(change.removed.begin(), change.removed.end());
  change.vertex_map = std::move(vertex_map);
  return change;
}

}  // namespace cocoon
