#include "cocone/boundary_loops.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "cocone/inputs/stage_inputs.h"
#include "cocone/orient_surface.h"
#include "geom/arrays/median.h"
#include "geom/mesh/edge_components.h"
#include "geom/messages/require_size.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// A part of the surface, and where its triangles come from.
struct Part {
  TriangleMesh mesh;
  IdVector<TriangleId, TriangleId> origin;
  HalfedgeRings rings;
};

// Cosine of the dihedral of two triangles at their common edge, -1 = flat.
double dihedral_cosine(const TriangleMesh& mesh, Halfedge a, Halfedge b) {
  std::array<VertexId, 2> ends = ends_of_halfedge(mesh, a);
  if (mesh.points[ends[1]] < mesh.points[ends[0]]) std::swap(ends[0], ends[1]);
  const Point& origin = mesh.points[ends[0]];
  const Vec3 edge = mesh.points[ends[1]] - origin;
  const Vec3 normal_a = unit(cross(edge, mesh.points[apex_of_halfedge(mesh, a)] - origin));
  const Vec3 normal_b = unit(cross(edge, mesh.points[apex_of_halfedge(mesh, b)] - origin));
  return dot(normal_a, normal_b);
}

// Marks all but the flattest pair of the triangles at an edge; ties go to the smaller apexes.
void mark_surplus(const TriangleMesh& mesh, std::vector<Halfedge> halfedges,
                  std::vector<std::uint8_t>& surplus) {
  std::sort(halfedges.begin(), halfedges.end(), [&](Halfedge a, Halfedge b) {
    return mesh.points[apex_of_halfedge(mesh, a)] < mesh.points[apex_of_halfedge(mesh, b)];
  });
  std::pair<std::size_t, std::size_t> flattest{0, 1};
  double smallest = 2;
  for (std::size_t i = 0; i < halfedges.size(); ++i) {
    for (std::size_t k = i + 1; k < halfedges.size(); ++k) {
      const double cosine = dihedral_cosine(mesh, halfedges[i], halfedges[k]);
      if (cosine < smallest) {
        smallest = cosine;
        flattest = {i, k};
      }
    }
  }
  for (std::size_t i = 0; i < halfedges.size(); ++i) {
    if (i != flattest.first && i != flattest.second)
      surplus[triangle_of_halfedge(halfedges[i])] = 1;
  }
}

// The triangles to leave out, all but two at each edge that has more; empty if there is no such
// edge.
std::vector<std::uint8_t> surplus_triangles(const TriangleMesh& mesh, const HalfedgeRings& rings) {
  std::vector<std::uint8_t> surplus;
  for (Halfedge halfedge = 0; halfedge < rings.links.size(); ++halfedge) {
    if (!rings.has_edge(halfedge) || rings.is_open(halfedge) || rings.has_two_triangles(halfedge))
      continue;
    if (!rings.is_last(halfedge)) continue;
    std::vector<Halfedge> at_edge;
    for_each_at_edge(rings.links, halfedge, [&](Halfedge other) { at_edge.push_back(other); });
    surplus.resize(mesh.triangles.size(), 0);
    mark_surplus(mesh, std::move(at_edge), surplus);
  }
  return surplus;
}

Part without(const Part& part, const std::vector<std::uint8_t>& surplus) {
  Part rest{{part.mesh.points, {}}, {}, link_rest(part.rings, surplus)};
  for (const TriangleId t : part.mesh.triangles.ids()) {
    if (surplus[t.index()] != 0) continue;
    rest.mesh.triangles.push_back(part.mesh.triangles[t]);
    rest.origin.push_back(part.origin[t]);
  }
  return rest;
}

// Leaves out triangles until no edge has more than two. Precondition: some edge has.
Part without_surplus(const TriangleMesh& surface, const HalfedgeRings& rings,
                     std::vector<std::uint8_t> surplus) {
  Part part{surface, IdVector<TriangleId, TriangleId>(surface.triangles.size()), rings};
  for (const TriangleId t : part.origin.ids()) part.origin[t] = t;
  while (!surplus.empty()) {
    part = without(part, surplus);
    surplus = surplus_triangles(part.mesh, part.rings);
  }
  return part;
}

class LoopWalk {
 public:
  // Precondition: no edge has more than two triangles.
  LoopWalk(const TriangleMesh& mesh, const HalfedgeRings& rings)
      : mesh_(mesh), rings_(rings), passed_(rings.links.size(), 0) {}

  // All loops, each from an arbitrary edge on.
  std::vector<std::vector<BoundaryEdge>> run() {
    std::vector<std::vector<BoundaryEdge>> loops;
    for (Halfedge halfedge = 0; halfedge < rings_.links.size(); ++halfedge) {
      if (rings_.is_open(halfedge) && passed_[halfedge] == 0) loops.push_back(walk(halfedge));
    }
    return loops;
  }

 private:
  std::vector<BoundaryEdge> walk(Halfedge first) {
    std::vector<BoundaryEdge> loop;
    std::array<VertexId, 2> ends = ends_of_halfedge(mesh_, first);
    for (Halfedge halfedge = first; passed_[halfedge] == 0;) {
      passed_[halfedge] = 1;
      loop.push_back({ends[0], ends[1], TriangleId(triangle_of_halfedge(halfedge))});
      halfedge = end_of_fan(halfedge, ends[1]);
      const auto [a, b] = ends_of_halfedge(mesh_, halfedge);
      ends = {ends[1], a == ends[1] ? b : a};
    }
    return loop;
  }

  // From a boundary halfedge through the fan about v to the halfedge where it ends.
  Halfedge end_of_fan(Halfedge halfedge, VertexId v) const {
    for (;;) {
      const Halfedge other = other_halfedge_at(halfedge, v);
      if (rings_.is_open(other)) return other;
      halfedge = rings_.links[other];
    }
  }

  // The other halfedge of the triangle that has v as an end.
  Halfedge other_halfedge_at(Halfedge halfedge, VertexId v) const {
    const Halfedge first = 3 * triangle_of_halfedge(halfedge);
    for (Halfedge other = first; other < first + 3; ++other) {
      if (other != halfedge && apex_of_halfedge(mesh_, other) != v) return other;
    }
    return halfedge;
  }

  const TriangleMesh& mesh_;
  const HalfedgeRings& rings_;
  std::vector<std::uint8_t> passed_;  // of open halfedges
};

// Precondition: no edge has more than two triangles. Which of two halfedges is the first cannot be
// foreseen: no branch depends on it.
double median_edge_length(const TriangleMesh& mesh, const HalfedgeRings& rings) {
  std::vector<double> lengths(rings.links.size());
  std::size_t count = 0;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Triangle& triangle = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const Halfedge halfedge = halfedge_of(t, i);
      lengths[count] = distance(mesh.points[triangle[next_corner(i)]],
                                mesh.points[triangle[previous_corner(i)]]);
      count += rings.has_edge(halfedge) && rings.links[halfedge] >= halfedge ? 1U : 0U;
    }
  }
  lengths.resize(count);
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
BoundaryLoops loops_of(const TriangleMesh& mesh, const HalfedgeRings& rings,
                       const EdgeComponents& found, const BoundaryLoopOptions& options) {
  BoundaryLoops result;
  for (const EdgeComponent& component : found.components) {
    result.non_orientable += component.is_contradictory ? 1U : 0U;
  }
  result.median_edge = median_edge_length(mesh, rings);
  const double smallest_component =
      options.min_component_share * static_cast<double>(mesh.triangles.size());
  const auto is_debris = [&](std::size_t triangles) {
    return static_cast<double>(triangles) < smallest_component;
  };
  result.small_components = static_cast<std::size_t>(std::count_if(
      found.components.begin(), found.components.end(),
      [&](const EdgeComponent& component) { return is_debris(component.triangles); }));
  for (std::vector<BoundaryEdge>& edges : LoopWalk(mesh, rings).run()) {
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
BoundaryLoops loops_of_any(TriangleMesh mesh, HalfedgeRings rings,
                           const BoundaryLoopOptions& options) {
  const EdgeComponents found = edge_components(mesh, rings);
  if (orient_surface(mesh, found).flipped > 0) rings = link_halfedges(mesh);
  return loops_of(mesh, rings, found, options);
}

BoundaryLoops loops_without(const TriangleMesh& surface, const HalfedgeRings& rings,
                            std::vector<std::uint8_t> surplus, const BoundaryLoopOptions& options) {
  Part part = without_surplus(surface, rings, std::move(surplus));
  const std::size_t left = part.mesh.triangles.size();
  BoundaryLoops result = loops_of_any(std::move(part.mesh), std::move(part.rings), options);
  result.surplus_triangles = surface.triangles.size() - left;
  for (BoundaryLoop& loop : result.loops) {
    for (BoundaryEdge& edge : loop.edges) edge.triangle = part.origin[edge.triangle];
  }
  return result;
}

// Of a copy that has been multiplied by `scale`, a power of two: squares of lengths are in the
// range of double there.
BoundaryLoops in_units_of(double scale, BoundaryLoops result) {
  result.median_edge /= scale;
  for (BoundaryLoop& loop : result.loops) loop.perimeter /= scale;
  return result;
}

}  // namespace

BoundaryLoops boundary_loops(const TriangleMesh& open_surface, const BoundaryLoopOptions& options) {
  require_options("boundary_loops", options);
  if (const double scale = working_scale(open_surface.points.span()); scale != 1) {
    return in_units_of(scale, boundary_loops(scaled(open_surface, scale), options));
  }
  HalfedgeRings rings = link_halfedges(open_surface);
  std::vector<std::uint8_t> surplus = surplus_triangles(open_surface, rings);
  if (surplus.empty()) return loops_of_any(open_surface, std::move(rings), options);
  return loops_without(open_surface, rings, std::move(surplus), options);
}

BoundaryLoops boundary_loops(const TriangleMesh& oriented_surface, const HalfedgeRings& rings,
                             const EdgeComponents& components, const BoundaryLoopOptions& options) {
  require_options("boundary_loops", options);
  const std::size_t triangles = oriented_surface.triangles.size();
  require_size("boundary_loops", "linked halfedges", rings.links.size(), 3 * triangles);
  require_size("boundary_loops", "triangles in components", components.component_of.size(),
               triangles);
  if (const double scale = working_scale(oriented_surface.points.span()); scale != 1) {
    return in_units_of(scale,
                       boundary_loops(scaled(oriented_surface, scale), rings, components, options));
  }
  std::vector<std::uint8_t> surplus = surplus_triangles(oriented_surface, rings);
  if (surplus.empty()) return loops_of(oriented_surface, rings, components, options);
  return loops_without(oriented_surface, rings, std::move(surplus), options);
}

}  // namespace cocoon
