#include "cocone/boundary_loops.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "cocone/orient_surface.h"
#include "geom/edge_components.h"
#include "geom/median.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// A part of the surface, and where its triangles come from.
struct Part {
  TriangleMesh mesh;
  IdVector<TriangleId, TriangleId> origin;
  LinkedSides sides;
};

// Cosine of the dihedral of two triangles at their common edge, -1 = flat.
double dihedral_cosine(const TriangleMesh& mesh, SideId a, SideId b) {
  std::array<VertexId, 2> ends = ends_of_side(mesh, a);
  if (mesh.points[ends[1]] < mesh.points[ends[0]]) std::swap(ends[0], ends[1]);
  const Point& origin = mesh.points[ends[0]];
  const Vec3 edge = mesh.points[ends[1]] - origin;
  const Vec3 normal_a = unit(cross(edge, mesh.points[apex_of_side(mesh, a)] - origin));
  const Vec3 normal_b = unit(cross(edge, mesh.points[apex_of_side(mesh, b)] - origin));
  return dot(normal_a, normal_b);
}

// Marks all but the flattest pair of the triangles at an edge; ties go to the smaller apexes.
void mark_surplus(const TriangleMesh& mesh, std::vector<SideId> sides,
                  std::vector<std::uint8_t>& surplus) {
  std::sort(sides.begin(), sides.end(), [&](SideId a, SideId b) {
    return mesh.points[apex_of_side(mesh, a)] < mesh.points[apex_of_side(mesh, b)];
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
    if (i != flattest.first && i != flattest.second) surplus[triangle_of_side(sides[i])] = 1;
  }
}

// The triangles to leave out, all but two at each edge that has more; empty if there is no such
// edge.
std::vector<std::uint8_t> surplus_triangles(const TriangleMesh& mesh, const LinkedSides& sides) {
  std::vector<std::uint8_t> surplus;
  for (SideId side = 0; side < sides.links.size(); ++side) {
    if (!sides.has_edge(side) || sides.is_open(side) || sides.is_two_sided(side)) continue;
    if (!sides.is_first(side)) continue;
    std::vector<SideId> at_edge;
    sides.for_each_at_edge(side, [&](SideId other) { at_edge.push_back(other); });
    surplus.resize(mesh.triangles.size(), 0);
    mark_surplus(mesh, std::move(at_edge), surplus);
  }
  return surplus;
}

Part without(const Part& part, const std::vector<std::uint8_t>& surplus) {
  Part rest{{part.mesh.points, {}}, {}, link_rest(part.sides, surplus)};
  for (const TriangleId t : part.mesh.triangles.ids()) {
    if (surplus[t.index()] != 0) continue;
    rest.mesh.triangles.push_back(part.mesh.triangles[t]);
    rest.origin.push_back(part.origin[t]);
  }
  return rest;
}

// Leaves out triangles until no edge has more than two. Precondition: some edge has.
Part without_surplus(const TriangleMesh& surface, const LinkedSides& sides,
                     std::vector<std::uint8_t> surplus) {
  Part part{surface, IdVector<TriangleId, TriangleId>(surface.triangles.size()), sides};
  for (const TriangleId t : part.origin.ids()) part.origin[t] = t;
  while (!surplus.empty()) {
    part = without(part, surplus);
    surplus = surplus_triangles(part.mesh, part.sides);
  }
  return part;
}

class LoopWalk {
 public:
  // Precondition: no edge has more than two triangles.
  LoopWalk(const TriangleMesh& mesh, const LinkedSides& sides)
      : mesh_(mesh), sides_(sides), passed_(sides.links.size(), 0) {}

  // All loops, each from an arbitrary edge on.
  std::vector<std::vector<BoundaryEdge>> run() {
    std::vector<std::vector<BoundaryEdge>> loops;
    for (SideId side = 0; side < sides_.links.size(); ++side) {
      if (sides_.is_open(side) && passed_[side] == 0) loops.push_back(walk(side));
    }
    return loops;
  }

 private:
  std::vector<BoundaryEdge> walk(SideId first) {
    std::vector<BoundaryEdge> loop;
    std::array<VertexId, 2> ends = ends_of_side(mesh_, first);
    for (SideId side = first; passed_[side] == 0;) {
      passed_[side] = 1;
      loop.push_back({ends[0], ends[1], TriangleId(triangle_of_side(side))});
      side = end_of_fan(side, ends[1]);
      const auto [a, b] = ends_of_side(mesh_, side);
      ends = {ends[1], a == ends[1] ? b : a};
    }
    return loop;
  }

  // From a boundary side through the fan about v to the side where it ends.
  SideId end_of_fan(SideId side, VertexId v) const {
    for (;;) {
      const SideId other = other_side_at(side, v);
      if (sides_.is_open(other)) return other;
      side = sides_.links[other];
    }
  }

  // The other side of the triangle that has v as an end.
  SideId other_side_at(SideId side, VertexId v) const {
    const SideId first = 3 * triangle_of_side(side);
    for (SideId other = first; other < first + 3; ++other) {
      if (other != side && apex_of_side(mesh_, other) != v) return other;
    }
    return side;
  }

  const TriangleMesh& mesh_;
  const LinkedSides& sides_;
  std::vector<std::uint8_t> passed_;  // of open sides
};

double median_edge_length(const TriangleMesh& mesh, const LinkedSides& sides) {
  std::vector<double> lengths;
  lengths.reserve(sides.links.size() / 2 + 1);
  for (SideId side = 0; side < sides.links.size(); ++side) {
    if (!sides.has_edge(side) || !sides.is_first(side)) continue;
    const auto [a, b] = ends_of_side(mesh, side);
    lengths.push_back(distance(mesh.points[a], mesh.points[b]));
  }
  return median(std::move(lengths));
}

// Turns the loop so that its lexicographically smallest edge runs from its smaller end to the other
// one: on a one-sided part the triangles do not tell in which direction a loop runs.
void direct(const TriangleMesh& mesh, std::vector<BoundaryEdge>& edges) {
  const auto sorted_ends = [&](const BoundaryEdge& edge) {
    return std::minmax(mesh.points[edge.from], mesh.points[edge.to]);
  };
  const auto smallest = std::min_element(edges.begin(), edges.end(),
                                         [&](const BoundaryEdge& a, const BoundaryEdge& b) {
                                           return sorted_ends(a) < sorted_ends(b);
                                         });
  if (!(mesh.points[smallest->to] < mesh.points[smallest->from])) return;
  std::reverse(edges.begin(), edges.end());
  for (BoundaryEdge& edge : edges) std::swap(edge.from, edge.to);
}

// Begins the loop at its lexicographically smallest edge.
void rotate_to_start(const TriangleMesh& mesh, std::vector<BoundaryEdge>& edges) {
  const auto before = [&](const BoundaryEdge& a, const BoundaryEdge& b) {
    return std::pair(mesh.points[a.from], mesh.points[a.to]) <
           std::pair(mesh.points[b.from], mesh.points[b.to]);
  };
  std::rotate(edges.begin(), std::min_element(edges.begin(), edges.end(), before), edges.end());
}

// Of an oriented surface with at most two triangles at each edge.
BoundaryLoops loops_of(const TriangleMesh& mesh, const LinkedSides& sides,
                       const EdgeComponents& found, const BoundaryLoopOptions& options) {
  BoundaryLoops result;
  for (const EdgeComponent& component : found.components) {
    result.non_orientable += component.is_contradictory ? 1U : 0U;
  }
  result.median_edge = median_edge_length(mesh, sides);
  const double smallest_component =
      options.min_component_share * static_cast<double>(mesh.triangles.size());
  const auto is_debris = [&](std::size_t triangles) {
    return static_cast<double>(triangles) < smallest_component;
  };
  result.small_components = static_cast<std::size_t>(std::count_if(
      found.components.begin(), found.components.end(),
      [&](const EdgeComponent& component) { return is_debris(component.triangles); }));
  for (std::vector<BoundaryEdge>& edges : LoopWalk(mesh, sides).run()) {
    BoundaryLoop loop;
    const EdgeComponent& component =
        found.components[found.component_of[edges.front().triangle.index()]];
    loop.component_triangles = component.triangles;
    loop.component = found.component_of[edges.front().triangle.index()];
    if (is_debris(loop.component_triangles)) {
      ++result.discarded_loops;
      continue;
    }
    if (component.is_contradictory) direct(mesh, edges);
    rotate_to_start(mesh, edges);
    for (const BoundaryEdge& edge : edges) {
      loop.perimeter += distance(mesh.points[edge.from], mesh.points[edge.to]);
    }
    loop.edges = std::move(edges);
    loop.pin_hole = loop.edges.size() < options.min_loop_edges ||
                    loop.perimeter < options.min_perimeter_in_edges * result.median_edge;
    result.pin_holes += loop.pin_hole;
    result.loops.push_back(std::move(loop));
  }
  std::sort(result.loops.begin(), result.loops.end(), [&](const auto& a, const auto& b) {
    const auto start = [&](const BoundaryLoop& loop) {
      return std::pair(mesh.points[loop.edges.front().from], mesh.points[loop.edges.front().to]);
    };
    return start(a) < start(b);
  });
  return result;
}

// Of a surface with at most two triangles at each edge, oriented in any way.
BoundaryLoops loops_of_any(TriangleMesh mesh, LinkedSides sides,
                           const BoundaryLoopOptions& options) {
  const EdgeComponents found = edge_components(mesh, sides);
  if (orient_surface(mesh, found).flipped > 0) sides = link_sides(mesh);
  return loops_of(mesh, sides, found, options);
}

BoundaryLoops loops_without(const TriangleMesh& surface, const LinkedSides& sides,
                            std::vector<std::uint8_t> surplus, const BoundaryLoopOptions& options) {
  Part part = without_surplus(surface, sides, std::move(surplus));
  const std::size_t left = part.mesh.triangles.size();
  BoundaryLoops result = loops_of_any(std::move(part.mesh), std::move(part.sides), options);
  result.surplus_triangles = surface.triangles.size() - left;
  for (BoundaryLoop& loop : result.loops) {
    for (BoundaryEdge& edge : loop.edges) edge.triangle = part.origin[edge.triangle];
  }
  return result;
}

// By a copy that has been multiplied by `scale`, a power of two: squares of lengths are in the
// range of double there.
BoundaryLoops scaled_loops(const TriangleMesh& surface, double scale,
                           const BoundaryLoopOptions& options) {
  BoundaryLoops result = boundary_loops(scaled(surface, scale), options);
  result.median_edge /= scale;
  for (BoundaryLoop& loop : result.loops) loop.perimeter /= scale;
  return result;
}

}  // namespace

BoundaryLoops boundary_loops(const TriangleMesh& open_surface, const BoundaryLoopOptions& options) {
  if (const double scale = working_scale(open_surface.points.span()); scale != 1) {
    return scaled_loops(open_surface, scale, options);
  }
  LinkedSides sides = link_sides(open_surface);
  std::vector<std::uint8_t> surplus = surplus_triangles(open_surface, sides);
  if (surplus.empty()) return loops_of_any(open_surface, std::move(sides), options);
  return loops_without(open_surface, sides, std::move(surplus), options);
}

BoundaryLoops boundary_loops(const TriangleMesh& oriented_surface, const LinkedSides& sides,
                             const EdgeComponents& components, const BoundaryLoopOptions& options) {
  std::vector<std::uint8_t> surplus = surplus_triangles(oriented_surface, sides);
  if (surplus.empty()) return loops_of(oriented_surface, sides, components, options);
  return loops_without(oriented_surface, sides, std::move(surplus), options);
}

}  // namespace cocoon
