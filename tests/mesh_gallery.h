// Small meshes whose properties are known by hand, for the tests of mesh code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

#include "geom/triangle_mesh.h"

namespace cocoon::gallery {

inline TriangleMesh make_mesh(std::initializer_list<Point> points,
                              std::initializer_list<std::array<int, 3>> triangles) {
  TriangleMesh mesh;
  for (const Point& p : points) mesh.points.push_back(p);
  for (const auto& t : triangles) {
    mesh.triangles.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
  }
  return mesh;
}

// Volume 1/6, outward orientation.
inline TriangleMesh tetrahedron() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

// [0, size]^3, two triangles a face. Vertex i has coordinates (i & 1, i & 2, i & 4).
inline TriangleMesh cube(double size = 1) {
  TriangleMesh mesh = make_mesh({}, {{0, 2, 3},
                                     {0, 3, 1},
                                     {4, 5, 7},
                                     {4, 7, 6},
                                     {0, 1, 5},
                                     {0, 5, 4},
                                     {2, 6, 7},
                                     {2, 7, 3},
                                     {0, 4, 6},
                                     {0, 6, 2},
                                     {1, 3, 7},
                                     {1, 7, 5}});
  for (int i = 0; i < 8; ++i) {
    mesh.points.push_back(
        {(i & 1) != 0 ? size : 0, (i & 2) != 0 ? size : 0, (i & 4) != 0 ? size : 0});
  }
  return mesh;
}

// From the origin, so long along the axes.
inline TriangleMesh box(double x, double y, double z) {
  TriangleMesh mesh = cube();
  for (Point& p : mesh.points) p = {x * p.x, y * p.y, z * p.z};
  return mesh;
}

// The same surface, but each triangle has corners of its own.
inline TriangleMesh unshared(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const Triangle& t : mesh.triangles) {
    Triangle own;
    for (std::size_t i = 0; i < 3; ++i) {
      own[i] = VertexId(soup.points.size());
      soup.points.push_back(mesh.points[t[i]]);
    }
    soup.triangles.push_back(own);
  }
  return soup;
}

// Both meshes in one, nothing shared.
inline TriangleMesh join(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh mesh = a;
  const auto shift = static_cast<std::uint32_t>(a.points.size());
  for (const Point& p : b.points) mesh.points.push_back(p);
  for (const Triangle& t : b.triangles) {
    mesh.triangles.push_back(
        {VertexId(t[0].value + shift), VertexId(t[1].value + shift), VertexId(t[2].value + shift)});
  }
  return mesh;
}

inline TriangleMesh translated(TriangleMesh mesh, const Vec3& by) {
  for (Point& p : mesh.points) p = p + by;
  return mesh;
}

inline TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Point& p : mesh.points) p = factor * p;
  return mesh;
}

// Rotation by a quarter turn about z, exact.
inline TriangleMesh quarter_turned(TriangleMesh mesh) {
  for (Point& p : mesh.points) p = {-p.y, p.x, p.z};
  return mesh;
}

inline TriangleMesh flipped(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

// The origin shared, the second tetrahedron in the opposite octant.
inline TriangleMesh two_tetrahedra_sharing_a_vertex() {
  return make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {0, 5, 6}});
}

// The edge 0-1 (on the x-axis) shared by four triangles.
inline TriangleMesh two_tetrahedra_sharing_an_edge() {
  return make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {0, 5, 4}});
}

// A grid of rows x columns quads, each cut in two, in the plane z = 0, seen from above.
inline TriangleMesh open_patch(int rows, int columns) {
  TriangleMesh mesh;
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      mesh.points.push_back({static_cast<double>(c), static_cast<double>(r), 0});
    }
  }
  const auto at = [columns](int r, int c) { return VertexId(r * (columns + 1) + c); };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      mesh.triangles.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
      mesh.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
    }
  }
  return mesh;
}

// Torus about the z-axis: `around` quads the long way, `across` the short way; genus 1, outward.
inline TriangleMesh torus(int around, int across, double major = 2, double minor = 0.75) {
  constexpr double two_pi = 6.283185307179586;
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = two_pi * i / around;
      const double v = two_pi * j / across;
      const double r = major + minor * std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), minor * std::sin(v)});
    }
  }
  const auto at = [around, across](int i, int j) {
    return VertexId((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

// A band of `quads` quads with a half twist: one boundary curve, not orientable.
inline TriangleMesh moebius_strip(int quads) {
  constexpr double two_pi = 6.283185307179586;
  TriangleMesh mesh;
  for (int i = 0; i < quads; ++i) {
    const double u = two_pi * i / quads;
    for (const double side : {-0.5, 0.5}) {
      const double r = 2 + side * std::cos(u / 2);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), side * std::sin(u / 2)});
    }
  }
  const auto at = [quads](int i, int side) {
    return i < quads ? VertexId(2 * i + side) : VertexId(1 - side);
  };
  for (int i = 0; i < quads; ++i) {
    mesh.triangles.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 1)});
    mesh.triangles.push_back({at(i, 0), at(i + 1, 1), at(i, 1)});
  }
  return mesh;
}

// The six-vertex projective plane (combinatorially; in space it crosses itself).
inline TriangleMesh projective_plane() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0.5}, {0.5, 1, 1}},
                   {{0, 1, 2},
                    {0, 2, 3},
                    {0, 3, 4},
                    {0, 4, 5},
                    {0, 5, 1},
                    {1, 2, 4},
                    {2, 3, 5},
                    {3, 4, 1},
                    {4, 5, 2},
                    {5, 1, 3}});
}

// An octahedron whose faces are split in four `levels` times and pushed out to the unit sphere.
inline TriangleMesh sphere(int levels) {
  TriangleMesh mesh = make_mesh(
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  for (int level = 0; level < levels; ++level) {
    std::vector<std::pair<std::array<VertexId, 2>, VertexId>> middles;
    const auto middle = [&](VertexId a, VertexId b) {
      const std::array<VertexId, 2> key = {std::min(a, b), std::max(a, b)};
      for (const auto& [edge, vertex] : middles) {
        if (edge == key) return vertex;
      }
      const VertexId v = mesh.points.push_back(unit(mesh.points[a] + mesh.points[b]));
      middles.emplace_back(key, v);
      return v;
    };
    IdVector<TriangleId, Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const VertexId ab = middle(t[0], t[1]);
      const VertexId bc = middle(t[1], t[2]);
      const VertexId ca = middle(t[2], t[0]);
      finer.push_back({t[0], ab, ca});
      finer.push_back({ab, t[1], bc});
      finer.push_back({ca, bc, t[2]});
      finer.push_back({ab, bc, ca});
    }
    mesh.triangles = finer;
  }
  return mesh;
}

// `count` triangles at random places of the unit cube; the corners of each lie within
// `triangle_size` of each other (per axis).
inline TriangleMesh random_soup(int count, unsigned seed, double triangle_size = 1) {
  std::mt19937 generator(seed);
  const auto random = [&generator] { return static_cast<double>(generator()) * 0x1p-32; };
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Point base = {random(), random(), random()};
    Triangle triangle;
    for (VertexId& v : triangle) {
      v = mesh.points.push_back(base + triangle_size * Vec3{random(), random(), random()});
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

// The same surface with vertices and triangles in another order, and triangles rotated.
inline TriangleMesh shuffled(const TriangleMesh& mesh, unsigned seed) {
  std::mt19937 generator(seed);
  const auto shuffle = [&generator](auto& list) {
    for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[generator() % k]);
  };
  std::vector<std::uint32_t> order(mesh.points.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<std::uint32_t>(k);
  shuffle(order);
  TriangleMesh result;
  result.points.resize(mesh.points.size());
  for (const VertexId v : mesh.points.ids()) {
    result.points[VertexId(order[v.index()])] = mesh.points[v];
  }
  std::vector<Triangle> triangles;
  for (Triangle t : mesh.triangles) {
    for (VertexId& v : t) v = VertexId(order[v.index()]);
    std::rotate(t.begin(), t.begin() + generator() % 3, t.end());
    triangles.push_back(t);
  }
  shuffle(triangles);
  result.triangles = IdVector<TriangleId, Triangle>(std::move(triangles));
  return result;
}

}  // namespace cocoon::gallery
