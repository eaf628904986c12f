#include "cocone/orient_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace cocoon {
namespace {

// Union-find over triangles that also knows whether a triangle must be turned relative to its root.
class Orientations {
 public:
  explicit Orientations(std::size_t count) : parent_(count), turned_(count, 0), bad_(count, 0) {
    for (const TriangleId t : parent_.ids()) parent_[t] = t;
  }

  // The root of t; afterwards turned(t) is relative to it.
  TriangleId find(TriangleId t) {
    path_.clear();
    while (parent_[t] != t) {
      path_.push_back(t);
      t = parent_[t];
    }
    std::uint8_t turned = 0;
    for (auto link = path_.rbegin(); link != path_.rend(); ++link) {
      turned ^= turned_[*link];
      turned_[*link] = turned;
      parent_[*link] = t;
    }
    return t;
  }

  // `differ`: exactly one of a and b has to be turned.
  void join(TriangleId a, TriangleId b, bool differ) {
    const TriangleId root_a = find(a);
    const TriangleId root_b = find(b);
    const bool turn_b = (turned(a) != turned(b)) != differ;
    if (root_a == root_b) {
      if (turn_b) bad_[root_a] = 1;
      return;
    }
    parent_[root_b] = root_a;
    turned_[root_b] = turn_b;
    bad_[root_a] |= bad_[root_b];
  }

  bool turned(TriangleId t) const { return turned_[t] != 0; }
  bool is_contradictory(TriangleId root) const { return bad_[root] != 0; }

 private:
  IdVector<TriangleId, TriangleId> parent_;
  IdVector<TriangleId, std::uint8_t> turned_;  // relative to the parent
  IdVector<TriangleId, std::uint8_t> bad_;     // of a root: no consistent orientation
  std::vector<TriangleId> path_;
};

bool run_the_same_way(const TriangleMesh& mesh, HalfedgeId a, HalfedgeId b) {
  return ends_of(mesh, a) == ends_of(mesh, b);
}

std::array<Point, 3> sorted_points(const TriangleMesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.triangles[t];
  std::array<Point, 3> points{mesh.points[a], mesh.points[b], mesh.points[c]};
  std::sort(points.begin(), points.end());
  return points;
}

struct Component {
  std::size_t triangles = 0;
  std::size_t turned = 0;
  TriangleId first;  // lexicographically smallest; looked for in ties only
};

}  // namespace

OrientationReport orient_surface(TriangleMesh& mesh) {
  return orient_surface(mesh, mesh_adjacency(mesh));
}

OrientationReport orient_surface(TriangleMesh& mesh, const MeshAdjacency& adjacency) {
  Orientations orientations(mesh.triangles.size());
  for (const EdgeId e : adjacency.edges.ids()) {
    const auto sides = adjacency.halfedges_at(e);
    if (sides.size() != 2) continue;
    orientations.join(triangle_of(sides[0]), triangle_of(sides[1]),
                      run_the_same_way(mesh, sides[0], sides[1]));
  }
  IdVector<TriangleId, Component> components(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    Component& component = components[orientations.find(t)];
    ++component.triangles;
    component.turned += orientations.turned(t);
  }
  for (const TriangleId t : mesh.triangles.ids()) {
    Component& component = components[orientations.find(t)];
    if (2 * component.turned != component.triangles) continue;
    if (component.first.is_none() ||
        sorted_points(mesh, t) < sorted_points(mesh, component.first)) {
      component.first = t;
    }
  }
  OrientationReport report;
  for (const TriangleId t : mesh.triangles.ids()) {
    const TriangleId root = orientations.find(t);
    const Component& component = components[root];
    report.components += root == t;
    if (orientations.is_contradictory(root)) {
      report.non_orientable += root == t;
      continue;
    }
    const bool turn_roots_way = component.first.is_none()
                                    ? 2 * component.turned > component.triangles
                                    : orientations.turned(component.first);
    if (orientations.turned(t) == turn_roots_way) continue;
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    ++report.flipped;
  }
  return report;
}

}  // namespace cocoon
