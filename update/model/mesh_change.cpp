#include "update/model/mesh_change.h"

#include <algorithm>
#include <utility>

#include "geom/arrays/large_pages.h"
#include "geom/mesh/triangle_order.h"

namespace cocoon {
namespace {

// A triangle in the numbers of the new mesh, with its place in its own.
struct Numbered {
  Triangle triangle;
  TriangleId source;
  friend bool operator<(const Numbered& a, const Numbered& b) {
    return a.triangle != b.triangle ? a.triangle < b.triangle : a.source < b.source;
  }
};

// Compares lists that are in canonical order both, once the old triangles have new numbers: without
// copies. False if they are not; then the lists are of no use.
bool compare_in_order(const TriangleMesh& before, const TriangleMesh& after,
                      const IdVector<VertexId, VertexId>& vertex_map, MeshChange& change) {
  auto next = after.triangles.begin();
  const auto end = after.triangles.end();
  Triangle last_old = lowest_triangle;
  Triangle last_new = lowest_triangle;
  Triangle now = lowest_triangle;
  bool sorted = true;
  const auto look = [&] {
    if (next == end) return;
    now = smallest_first(*next);
    sorted = sorted && !precedes(now, last_new);
    last_new = now;
  };
  look();
  for (const TriangleId id : before.triangles.ids()) {
    const Triangle& t = before.triangles[id];
    Triangle mapped{vertex_map[t[0]], vertex_map[t[1]], vertex_map[t[2]]};
    if (mapped[0].is_none() || mapped[1].is_none() || mapped[2].is_none()) {
      change.removed.push_back(t);
      continue;
    }
    mapped = smallest_first(mapped);
    if (precedes(mapped, last_old) || !sorted) return false;
    last_old = mapped;
    for (; next != end && precedes(now, mapped); ++next, look()) change.added.push_back(now);
    if (next != end && now == mapped) {
      change.triangle_map[id] =
          TriangleId(static_cast<std::size_t>(next - after.triangles.begin()));
      ++next;
      look();
    } else {
      change.removed.push_back(t);
    }
  }
  for (; next != end; ++next, look()) change.added.push_back(now);
  return sorted;
}

// The same for lists in any order.
void compare_sorted_copies(const TriangleMesh& before, const TriangleMesh& after,
                           const IdVector<VertexId, VertexId>& vertex_map, MeshChange& change) {
  std::vector<Numbered> old;
  old.reserve(before.triangles.size());
  for (const TriangleId t : before.triangles.ids()) {
    const auto& [a, b, c] = before.triangles[t];
    Numbered mapped{{vertex_map[a], vertex_map[b], vertex_map[c]}, t};
    if (mapped.triangle[0].is_none() || mapped.triangle[1].is_none() ||
        mapped.triangle[2].is_none()) {
      change.removed.push_back(before.triangles[t]);
      continue;
    }
    mapped.triangle = smallest_first(mapped.triangle);
    old.push_back(mapped);
  }
  std::sort(old.begin(), old.end());
  std::vector<Numbered> now;
  now.reserve(after.triangles.size());
  for (const TriangleId t : after.triangles.ids()) {
    now.push_back({smallest_first(after.triangles[t]), t});
  }
  std::sort(now.begin(), now.end());

  auto next = old.begin();
  for (const Numbered& t : now) {
    for (; next != old.end() && next->triangle < t.triangle; ++next) {
      change.removed.push_back(before.triangles[next->source]);
    }
    if (next != old.end() && next->triangle == t.triangle) {
      change.triangle_map[next->source] = t.source;
      ++next;
    } else {
      change.added.push_back(t.triangle);
    }
  }
  for (; next != old.end(); ++next) change.removed.push_back(before.triangles[next->source]);
}

}  // namespace

MeshChange mesh_change(const TriangleMesh& before, const TriangleMesh& after,
                       IdVector<VertexId, VertexId> vertex_map) {
  MeshChange change;
  change.triangle_map.reserve(before.triangles.size());
  prefer_large_pages(change.triangle_map.raw());
  change.triangle_map.resize(before.triangles.size());
  if (!compare_in_order(before, after, vertex_map, change)) {
    change = {};
    change.triangle_map.resize(before.triangles.size());
    compare_sorted_copies(before, after, vertex_map, change);
  }
  for (Triangle& t : change.removed) t = smallest_first(t);
  std::sort(change.removed.begin(), change.removed.end());
  change.vertex_map = std::move(vertex_map);
  return change;
}

}  // namespace cocoon
