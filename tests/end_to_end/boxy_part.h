// Machine parts made of unit cubes: walls, ribs, pockets. Their surface is known exactly.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "geom/random/random.h"
#include "geom/random/random_point.h"
#include "geom/triangle_mesh.h"
#include "tests/end_to_end/spread_points.h"

namespace cocoon::testing {

// The cubes [x, x + 1] x [y, y + 1] x [z, z + 1] with 0 <= x, y, z < size that are solid.
struct BoxyPart {
  std::array<int, 3> size{};
  std::function<bool(int, int, int)> solid;

  bool has(const std::array<int, 3>& cube) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cube[axis] < 0 || cube[axis] >= size[axis]) return false;
    }
    return solid(cube[0], cube[1], cube[2]);
  }
};

// The boundary, facing outward. Closed; manifold if no two cubes touch in an edge or corner alone.
inline TriangleMesh surface_of(const BoxyPart& part) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, VertexId> ids;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [entry, is_new] = ids.try_emplace(at);
    if (is_new) {
      entry->second = mesh.points.push_back(
          {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])});
    }
    return entry->second;
  };
  const auto add_face = [&](std::array<int, 3> at, std::size_t axis, bool high) {
    at[axis] += high ? 1 : 0;
    std::array<int, 3> along_u = at;
    ++along_u[(axis + 1) % 3];
    std::array<int, 3> along_v = at;
    ++along_v[(axis + 2) % 3];
    std::array<int, 3> across = along_u;
    ++across[(axis + 2) % 3];
    if (!high) std::swap(along_u, along_v);
    mesh.triangles.push_back({corner(at), corner(along_u), corner(across)});
    mesh.triangles.push_back({corner(at), corner(across), corner(along_v)});
  };
  for (int x = 0; x < part.size[0]; ++x) {
    for (int y = 0; y < part.size[1]; ++y) {
      for (int z = 0; z < part.size[2]; ++z) {
        if (!part.has({x, y, z})) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const bool high : {false, true}) {
            std::array<int, 3> next = {x, y, z};
            next[axis] += high ? 1 : -1;
            if (!part.has(next)) add_face({x, y, z}, axis, high);
          }
        }
      }
    }
  }
  return mesh;
}

// Samples of a mesh no closer to each other than `least`, without gaps much wider than that: of the
// triangles for which wanted(t) holds.
template <class Wanted>
std::vector<Point> scan_of_mesh(const TriangleMesh& mesh, double least, Random& random,
                                const Wanted& wanted) {
  std::vector<TriangleId> triangles;
  for (const TriangleId t : mesh.triangles.ids()) {
    if (wanted(t)) triangles.push_back(t);
  }
  SpreadPoints samples(least);
  // Each triangle has half a unit of area.
  const double darts = 20 * 0.5 * static_cast<double>(triangles.size()) / (least * least);
  for (double thrown = 0; thrown < darts; ++thrown) {
    const auto& [a, b, c] = mesh.triangles[triangles[random.below(triangles.size())]];
    samples.add(random_point_in(mesh.points[a], mesh.points[b], mesh.points[c], random));
  }
  return samples.points();
}

}  // namespace cocoon::testing
