#include "update/checks/loose_parts.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geom/arrays/disjoint_sets.h"
#include "geom/box.h"

namespace cocoon {

LooseParts loose_parts(const TriangleMesh& mesh, VertexId first_new) {
  LooseParts found;
  if (mesh.points.size() <= first_new.index()) return found;
  const std::size_t count = mesh.points.size() - first_new.index();
  const auto is_new = [&](VertexId v) { return v >= first_new; };
  const auto place_of = [&](VertexId v) { return v.value - first_new.value; };
  DisjointSets parts(count);
  std::vector<std::uint8_t> is_held(count, 0);  // has a triangle with a vertex of the model
  for (const Triangle& t : mesh.triangles) {
    const auto anchor = std::find_if(t.begin(), t.end(), is_new);
    if (anchor == t.end()) continue;
    for (const VertexId v : t) {
      if (is_new(v)) {
        parts.join(place_of(*anchor), place_of(v));
      } else {
        is_held[place_of(*anchor)] = 1;
      }
    }
  }
  for (std::uint32_t place = 0; place < count; ++place) {
    if (is_held[place] != 0) is_held[parts.root(place)] = 1;
  }
  // By their first vertices, their roots.
  std::vector<std::size_t> sizes(count, 0);
  std::vector<Box> boxes(count);
  std::vector<VertexId> first(count);  // lexicographically
  for (const Triangle& t : mesh.triangles) {
    if (!std::all_of(t.begin(), t.end(), is_new)) continue;
    const std::uint32_t part = parts.root(place_of(t[0]));
    if (is_held[part] != 0) continue;
    ++sizes[part];
    for (const VertexId v : t) {
      boxes[part].include(mesh.points[v]);
      if (first[part].is_none() || mesh.points[v] < mesh.points[first[part]]) first[part] = v;
    }
  }
  for (std::uint32_t part = 0; part < count; ++part) {
    if (sizes[part] == 0) continue;
    ++found.count;
    found.extents.push_back(norm(boxes[part].size()));
    if (sizes[part] <= found.triangles) continue;
    found.triangles = sizes[part];
    found.at = first[part];
  }
  return found;
}

}  // namespace cocoon
