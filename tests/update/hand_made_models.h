// Small models and rims with known answers, for the tests of the update stages.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "geom/random/random.h"
#include "geom/triangle_mesh.h"
#include "tests/mesh_gallery.h"
#include "update/cloud_rim.h"

namespace cocoon::testing {

inline VertexId vertex(std::size_t i) { return VertexId(i); }

// The square [0, n] x [0, n] in the plane z = 0, 2 n^2 triangles facing up.
inline TriangleMesh grid_plane(std::size_t n) {
  return gallery::open_patch(static_cast<int>(n), static_cast<int>(n));
}

// Leaves out the triangles whose centroid lies in the open square (low, high) x (low, high).
inline TriangleMesh with_hole(TriangleMesh mesh, double low, double high) {
  IdVector<TriangleId, Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    const Point c = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    const bool inside = low < c.x && c.x < high && low < c.y && c.y < high;
    if (!inside) kept.push_back(t);
  }
  mesh.triangles = kept;
  return mesh;
}

// The triangles of a mesh in another order, and which of them came to each place.
struct ShuffledMesh {
  TriangleMesh mesh;
  std::vector<TriangleId> order;
};
inline ShuffledMesh shuffled(const TriangleMesh& mesh) {
  ShuffledMesh result{{mesh.points, {}}, {}};
  for (const TriangleId t : mesh.triangles.ids()) result.order.push_back(t);
  Random random(5);
  for (std::size_t i = result.order.size(); i > 1; --i) {
    std::swap(result.order[i - 1], result.order[random.below(i)]);
  }
  for (const TriangleId t : result.order) result.mesh.triangles.push_back(mesh.triangles[t]);
  return result;
}

// The surface of a box of nx * ny * nz unit cells, all on integer coordinates from 0, closed,
// facing outward.
inline TriangleMesh block(std::size_t nx, std::size_t ny, std::size_t nz) {
  TriangleMesh mesh;
  std::map<std::array<std::size_t, 3>, VertexId> ids;
  auto corner = [&](std::array<std::size_t, 3> at) {
    const auto [entry, is_new] = ids.try_emplace(at);
    if (is_new) {
      entry->second = mesh.points.push_back(
          {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])});
    }
    return entry->second;
  };
  const std::array<std::size_t, 3> size = {nx, ny, nz};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      for (std::size_t i = 0; i < size[u]; ++i) {
        for (std::size_t j = 0; j < size[v]; ++j) {
          auto at = [&](std::size_t di, std::size_t dj) {
            std::array<std::size_t, 3> place{};
            place[axis] = high ? size[axis] : 0;
            place[u] = i + di;
            place[v] = j + dj;
            return corner(place);
          };
          Triangle first = {at(0, 0), at(1, 0), at(1, 1)};
          Triangle second = {at(0, 0), at(1, 1), at(0, 1)};
          if (!high) std::swap(first[1], first[2]);
          if (!high) std::swap(second[1], second[2]);
          mesh.triangles.push_back(first);
          mesh.triangles.push_back(second);
        }
      }
    }
  }
  return mesh;
}

// An octahedron whose triangles are split n times in four, pushed to the unit sphere: 8 * 4^n
// triangles facing outward.
inline TriangleMesh sphere(int n) {
  TriangleMesh mesh;
  for (const Point& p : {Point{1, 0, 0}, Point{-1, 0, 0}, Point{0, 1, 0}, Point{0, -1, 0},
                         Point{0, 0, 1}, Point{0, 0, -1}}) {
    mesh.points.push_back(p);
  }
  for (const auto& [x, y, z] : std::vector<std::array<std::size_t, 3>>{{0, 2, 4},
                                                                       {2, 1, 4},
                                                                       {1, 3, 4},
                                                                       {3, 0, 4},
                                                                       {2, 0, 5},
                                                                       {1, 2, 5},
                                                                       {3, 1, 5},
                                                                       {0, 3, 5}}) {
    mesh.triangles.push_back({vertex(x), vertex(y), vertex(z)});
  }
  for (int round = 0; round < n; ++round) {
    std::map<std::pair<VertexId, VertexId>, VertexId> middles;
    auto middle = [&](VertexId a, VertexId b) {
      const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b));
      if (is_new) entry->second = mesh.points.push_back(unit(mesh.points[a] + mesh.points[b]));
      return entry->second;
    };
    IdVector<TriangleId, Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const VertexId ab = middle(a, b);
      const VertexId bc = middle(b, c);
      const VertexId ca = middle(c, a);
      finer.push_back({a, ab, ca});
      finer.push_back({b, bc, ab});
      finer.push_back({c, ca, bc});
      finer.push_back({ab, bc, ca});
    }
    mesh.triangles = finer;
  }
  return mesh;
}

// A torus about the z-axis: radii 1 (center line) and `tube`; nu * nv quads cut in two, facing
// outward.
inline Point torus_point(double u, double v, double tube) {
  const double radius = 1 + tube * std::cos(v);
  return {radius * std::cos(u), radius * std::sin(u), tube * std::sin(v)};
}
inline TriangleMesh torus(std::size_t nu, std::size_t nv, double tube) {
  return gallery::torus(static_cast<int>(nu), static_cast<int>(nv), 1, tube);
}

inline VertexId nearest_vertex(const TriangleMesh& mesh, const Point& p) {
  const auto closer = [&p](const Point& a, const Point& b) {
    return squared_distance(a, p) < squared_distance(b, p);
  };
  const auto nearest = std::min_element(mesh.points.begin(), mesh.points.end(), closer);
  return vertex(static_cast<std::size_t>(nearest - mesh.points.begin()));
}

// A closed loop through `points`, whose cocone triangles reach towards `inside` by the length of
// their rim edge, and whose surface normals are `normals`.
inline RimLoop loop_towards(const std::vector<Point>& points, const std::vector<Vec3>& normals,
                            const Point& inside) {
  RimLoop loop;
  loop.points = points;
  loop.normals = normals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& a = points[i];
    const Point& b = points[(i + 1) % points.size()];
    const Point middle = 0.5 * (a + b);
    loop.apexes.push_back(middle + distance(a, b) * unit(inside - middle));
    loop.vertices.push_back(vertex(i));
    loop.perimeter += distance(a, b);
  }
  return loop;
}

inline CloudRim rim_of(std::vector<RimLoop> loops) {
  CloudRim rim;
  rim.loops = std::move(loops);
  rim.spacing = distance(rim.loops.at(0).points[0], rim.loops.at(0).points[1]);
  return rim;
}

// A circle of n points in the horizontal plane of its center, with the cloud inside it and facing
// up.
inline RimLoop circle(std::size_t n, const Point& center, double radius) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + 0.25) / static_cast<double>(n);
    points.push_back(center + radius * Vec3{std::cos(angle), std::sin(angle), 0});
  }
  return loop_towards(points, std::vector<Vec3>(n, Vec3{0, 0, 1}), center);
}

// The rim of a cap of the unit sphere: the circle at polar angle `polar` from `axis` (unit).
inline RimLoop cap_rim(std::size_t n, const Vec3& axis, double polar) {
  const Vec3 u = unit(cross(axis, std::abs(axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(axis, u);
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + 0.25) / static_cast<double>(n);
    points.push_back(std::cos(polar) * axis +
                     std::sin(polar) * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return loop_towards(points, points, axis);
}

}  // namespace cocoon::testing
