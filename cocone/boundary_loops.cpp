#include "cocone/boundary_loops.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "cocone/orient_surface.h"
#include "geom/edge_components.h"
#include "geom/median.h"

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

// Leaves out triangles until no edge has more than two.
Part without_surplus(const TriangleMesh& surface, LinkedSides sides_of_surface) {
  Part part{surface, IdVector<TriangleId, TriangleId>(surface.triangles.size()),
            std::move(sides_of_surface)};
  for (const TriangleId t : part.origin.ids()) part.origin[t] = t;
  for (;;) {
    const LinkedSides& sides = part.sides;
    std::vector<std::uint8_t> surplus(part.mesh.triangles.size(), 0);
    bool found = false;
    for (SideId side = 0; side < sides.links.size(); ++side) {
      if (!sides.has_edge(side) || sides.is_open(side) || sides.is_two_sided(side)) continue;
      if (!sides.is_first(side)) continue;
      std::vector<SideId> at_edge;
      sides.for_each_at_edge(side, [&](SideId other) { at_edge.push_back(other); });
      mark_surplus(part.mesh, std::move(at_edge), surplus);
      found = true;
    }
    if (!found) return part;
    Part rest{{part.mesh.points, {}}, {}, link_rest(sides, surplus)};
    for (const TriangleId t : part.mesh.triangles.ids()) {
      if (surplus[t.index()] != 0) continue;
      rest.mesh.triangles.push_back(part.mesh.triangles[t]);
      rest.origin.push_back(part.origin[t]);
    }
    part = std::move(rest);
  }
}

class LoopWalk {
 public:
  explicit LoopWalk(const Part& part)
      : part_(part), sides_(part.sides), passed_(part.sides.links.size(), 0) {}

  // All loops, each from an arbitrary edge on.
  std::vector<std::vector<BoundaryEdge>> run() {
    std::vector<std::vector<BoundaryEdge>> loops;
    for (const SideId side : open_sides()) {
      if (passed_[side] == 0) loops.push_back(walk(side));
    }
    return loops;
  }

 private:
  // By their vertices, the smaller one first: which loop of a one-sided part begins where tells in
  // which direction it runs.
  std::vector<SideId> open_sides() const {
    std::vector<SideId> open;
    for (SideId side = 0; side < sides_.links.size(); ++side) {
      if (sides_.is_open(side)) open.push_back(side);
    }
    const auto edge_of = [&](SideId side) {
      const auto [a, b] = ends_of_side(part_.mesh, side);
      return std::pair(std::min(a, b), std::max(a, b));
    };
    std::sort(open.begin(), open.end(),
              [&](SideId a, SideId b) { return edge_of(a) < edge_of(b); });
    return open;
  }

  std::vector<BoundaryEdge> walk(SideId first) {
    std::vector<BoundaryEdge> loop;
    std::array<VertexId, 2> ends = ends_of_side(part_.mesh, first);
    for (SideId side = first; passed_[side] == 0;) {
      passed_[side] = 1;
      loop.push_back({ends[0], ends[1], TriangleId(triangle_of_side(side))});
      side = end_of_fan(side, ends[1]);
      const auto [a, b] = ends_of_side(part_.mesh, side);
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
      if (other != side && apex_of_side(part_.mesh, other) != v) return other;
    }
    return side;
  }

  const Part& part_;
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
  return boundary_loops(open_surface, link_sides(open_surface), options);
}

BoundaryLoops boundary_loops(const TriangleMesh& open_surface, LinkedSides sides,
                             const BoundaryLoopOptions& options) {
  Part part = without_surplus(open_surface, std::move(sides));
  BoundaryLoops result;
  result.surplus_triangles = open_surface.triangles.size() - part.mesh.triangles.size();
  const EdgeComponents found = edge_components(part.mesh, part.sides);
  const OrientationReport orientation = orient_surface(part.mesh, found);
  if (orientation.flipped > 0) part.sides = link_sides(part.mesh);
  result.non_orientable = orientation.non_orientable;
  result.median_edge = median_edge_length(part.mesh, part.sides);
  const double smallest_component =
      options.min_component_share * static_cast<double>(part.mesh.triangles.size());
  const auto is_debris = [&](std::size_t triangles) {
    return static_cast<double>(triangles) < smallest_component;
  };
  result.small_components = static_cast<std::size_t>(std::count_if(
      found.components.begin(), found.components.end(),
      [&](const EdgeComponent& component) { return is_debris(component.triangles); }));
  for (std::vector<BoundaryEdge>& edges : LoopWalk(part).run()) {
    BoundaryLoop loop;
    loop.component_triangles =
        found.components[found.component_of[edges.front().triangle.index()]].triangles;
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
