#include "cocone/boundary_loops.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "cocone/orient_surface.h"
#include "geom/median.h"

namespace cocoon {
namespace {

// A part of the surface, and where its triangles come from.
struct Part {
  TriangleMesh mesh;
  IdVector<TriangleId, TriangleId> origin;
  MeshAdjacency adjacency;
};

VertexId apex_of(const TriangleMesh& mesh, HalfedgeId side) {
  return mesh.triangles[triangle_of(side)][static_cast<std::size_t>(corner_of(side))];
}

// Cosine of the dihedral of two triangles at their common edge, -1 = flat.
double dihedral_cosine(const TriangleMesh& mesh, HalfedgeId a, HalfedgeId b) {
  std::array<VertexId, 2> ends = ends_of(mesh, a);
  if (mesh.points[ends[1]] < mesh.points[ends[0]]) std::swap(ends[0], ends[1]);
  const Vec3 edge = mesh.points[ends[1]] - mesh.points[ends[0]];
  const Vec3 normal_a = unit(cross(edge, mesh.points[apex_of(mesh, a)] - mesh.points[ends[0]]));
  const Vec3 normal_b = unit(cross(edge, mesh.points[apex_of(mesh, b)] - mesh.points[ends[0]]));
  return dot(normal_a, normal_b);
}

// Marks all but the flattest pair of the triangles at an edge; ties go to the smaller apexes.
void mark_surplus(const TriangleMesh& mesh, std::vector<HalfedgeId> sides,
                  IdVector<TriangleId, std::uint8_t>& surplus) {
  std::sort(sides.begin(), sides.end(), [&](HalfedgeId a, HalfedgeId b) {
    return mesh.points[apex_of(mesh, a)] < mesh.points[apex_of(mesh, b)];
  });
  std::pair<std::size_t, std::size_t> flattest{0, 1};
  double smallest = 2;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const double cosine = dihedral_cosine(mesh, sides[i], sides[k]);
      if (cosine < smallest) {
        smallest = cosine;
        flattest = {i, k};
      }
    }
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i != flattest.first && i != flattest.second) surplus[triangle_of(sides[i])] = 1;
  }
}

// Leaves out triangles until no edge has more than two.
Part without_surplus(const TriangleMesh& surface, MeshAdjacency adjacency_of_surface) {
  Part part{surface, IdVector<TriangleId, TriangleId>(surface.triangles.size()),
            std::move(adjacency_of_surface)};
  for (const TriangleId t : part.origin.ids()) part.origin[t] = t;
  for (;;) {
    const MeshAdjacency& adjacency = part.adjacency;
    IdVector<TriangleId, std::uint8_t> surplus(part.mesh.triangles.size(), 0);
    bool found = false;
    for (const EdgeId e : adjacency.edges.ids()) {
      const auto sides = adjacency.halfedges_at(e);
      if (sides.size() < 3) continue;
      mark_surplus(part.mesh, {sides.begin(), sides.end()}, surplus);
      found = true;
    }
    if (!found) return part;
    Part rest{{part.mesh.points, {}}, {}, {}};
    for (const TriangleId t : part.mesh.triangles.ids()) {
      if (surplus[t] != 0) continue;
      rest.mesh.triangles.push_back(part.mesh.triangles[t]);
      rest.origin.push_back(part.origin[t]);
    }
    rest.adjacency = mesh_adjacency(rest.mesh);
    part = std::move(rest);
  }
}

// The number of triangles in the edge-connected component of each triangle.
struct Components {
  IdVector<TriangleId, std::uint32_t> component_of;
  std::vector<std::size_t> triangles;
};

Components edge_connected_components(const MeshAdjacency& adjacency) {
  constexpr std::uint32_t unseen = 0xFFFFFFFFU;
  Components result{IdVector<TriangleId, std::uint32_t>(adjacency.neighbors.size(), unseen), {}};
  std::vector<TriangleId> stack;
  for (const TriangleId seed : adjacency.neighbors.ids()) {
    if (result.component_of[seed] != unseen) continue;
    const auto number = static_cast<std::uint32_t>(result.triangles.size());
    result.triangles.push_back(0);
    result.component_of[seed] = number;
    stack.push_back(seed);
    while (!stack.empty()) {
      const TriangleId t = stack.back();
      stack.pop_back();
      ++result.triangles[number];
      for (const TriangleId n : adjacency.neighbors[t]) {
        if (n.is_none() || result.component_of[n] != unseen) continue;
        result.component_of[n] = number;
        stack.push_back(n);
      }
    }
  }
  return result;
}

class LoopWalk {
 public:
  explicit LoopWalk(const Part& part)
      : part_(part), adjacency_(part.adjacency), passed_(part.adjacency.edges.size(), 0) {}

  // All loops, each from an arbitrary edge on.
  std::vector<std::vector<BoundaryEdge>> run() {
    std::vector<std::vector<BoundaryEdge>> loops;
    for (const EdgeId e : adjacency_.edges.ids()) {
      if (adjacency_.halfedges_at(e).size() != 1 || passed_[e] != 0) continue;
      loops.push_back(walk(e));
    }
    return loops;
  }

 private:
  std::vector<BoundaryEdge> walk(EdgeId first) {
    std::vector<BoundaryEdge> loop;
    HalfedgeId side = adjacency_.halfedges_at(first).front();
    std::array<VertexId, 2> ends = ends_of(part_.mesh, side);
    for (EdgeId e = first; passed_[e] == 0;) {
      passed_[e] = 1;
      loop.push_back({ends[0], ends[1], triangle_of(side)});
      side = end_of_fan(side, ends[1]);
      e = adjacency_.edge_of[side];
      const auto [a, b] = adjacency_.edges[e];
      ends = {ends[1], a == ends[1] ? b : a};
    }
    return loop;
  }

  // From a boundary side through the fan about v to the side where it ends.
  HalfedgeId end_of_fan(HalfedgeId side, VertexId v) const {
    for (;;) {
      const HalfedgeId other = other_side_at(side, v);
      const auto sides = adjacency_.halfedges_at(adjacency_.edge_of[other]);
      if (sides.size() == 1) return other;
      side = sides[0] == other ? sides[1] : sides[0];
    }
  }

  // The other side of the triangle that has v as an end.
  HalfedgeId other_side_at(HalfedgeId side, VertexId v) const {
    const TriangleId t = triangle_of(side);
    for (int i = 0; i < 3; ++i) {
      const bool opposite_v = part_.mesh.triangles[t][static_cast<std::size_t>(i)] == v;
      if (i != corner_of(side) && !opposite_v) return halfedge_of(t, i);
    }
    return side;
  }

  const Part& part_;
  const MeshAdjacency& adjacency_;
  IdVector<EdgeId, std::uint8_t> passed_;
};

double median_edge_length(const TriangleMesh& mesh, const MeshAdjacency& adjacency) {
  std::vector<double> lengths;
  lengths.reserve(adjacency.edges.size());
  for (const auto& [a, b] : adjacency.edges) {
    lengths.push_back(distance(mesh.points[a], mesh.points[b]));
  }
  return median(std::move(lengths));
}

// Begins the loop at its lexicographically smallest edge.
void rotate_to_start(const TriangleMesh& mesh, std::vector<BoundaryEdge>& edges) {
  const auto before = [&](const BoundaryEdge& a, const BoundaryEdge& b) {
    return std::pair(mesh.points[a.from], mesh.points[a.to]) <
           std::pair(mesh.points[b.from], mesh.points[b.to]);
  };
  std::rotate(edges.begin(), std::min_element(edges.begin(), edges.end(), before), edges.end());
}

}  // namespace

BoundaryLoops boundary_loops(const TriangleMesh& open_surface, const BoundaryLoopOptions& options) {
  return boundary_loops(open_surface, mesh_adjacency(open_surface), options);
}

BoundaryLoops boundary_loops(const TriangleMesh& open_surface, MeshAdjacency adjacency,
                             const BoundaryLoopOptions& options) {
  Part part = without_surplus(open_surface, std::move(adjacency));
  BoundaryLoops result;
  result.surplus_triangles = open_surface.triangles.size() - part.mesh.triangles.size();
  const OrientationReport orientation = orient_surface(part.mesh, part.adjacency);
  if (orientation.flipped > 0) part.adjacency = mesh_adjacency(part.mesh);
  result.non_orientable = orientation.non_orientable;
  result.median_edge = median_edge_length(part.mesh, part.adjacency);
  const Components components = edge_connected_components(part.adjacency);
  const double smallest_component =
      options.min_component_share * static_cast<double>(part.mesh.triangles.size());
  const auto is_debris = [&](std::size_t triangles) {
    return static_cast<double>(triangles) < smallest_component;
  };
  result.small_components = static_cast<std::size_t>(
      std::count_if(components.triangles.begin(), components.triangles.end(), is_debris));
  for (std::vector<BoundaryEdge>& edges : LoopWalk(part).run()) {
    BoundaryLoop loop;
    loop.component_triangles =
        components.triangles[components.component_of[edges.front().triangle]];
    if (is_debris(loop.component_triangles)) {
      ++result.discarded_loops;
      continue;
    }
    rotate_to_start(part.mesh, edges);
    for (BoundaryEdge& edge : edges) {
      loop.perimeter += distance(part.mesh.points[edge.from], part.mesh.points[edge.to]);
      edge.triangle = part.origin[edge.triangle];
    }
    loop.edges = std::move(edges);
    loop.pin_hole = loop.edges.size() < options.min_loop_edges ||
                    loop.perimeter < options.min_perimeter_in_edges * result.median_edge;
    result.pin_holes += loop.pin_hole;
    result.loops.push_back(std::move(loop));
  }
  std::sort(result.loops.begin(), result.loops.end(), [&](const auto& a, const auto& b) {
    const auto start = [&](const BoundaryLoop& loop) {
      return std::pair(open_surface.points[loop.edges.front().from],
                       open_surface.points[loop.edges.front().to]);
    };
    return start(a) < start(b);
  });
  return result;
}

}  // namespace cocoon
