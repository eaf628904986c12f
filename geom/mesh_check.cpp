#include "geom/mesh_check.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/sort_ids.h"
#include "geom/mesh/edge_components.h"
#include "geom/mesh/linked_mesh.h"
#include "geom/orient3d.h"
#include "geom/parallel/parallel_list.h"
#include "geom/search/equal_points.h"

namespace cocoon {
namespace {

constexpr std::size_t triangles_per_chunk = 4096;
constexpr std::size_t vertices_per_chunk = 2048;

// What find(i, found) appends to `found` for each i below count, in the order of i.
template <class T, class Find>
std::vector<T> collect(std::size_t count, std::size_t grain, const Execution& execution,
                       Find find) {
  return parallel_list<T>(execution, count, grain,
                          [&](std::size_t begin, std::size_t end, std::vector<T>& found) {
                            for (std::size_t i = begin; i < end; ++i) find(i, found);
                          });
}

// Triangles that hang together by edges with exactly two triangles. A component consists of one or
// more: over edges with more triangles nothing follows for the orientation.
struct Patch {
  TriangleId first_triangle;  // as it was given
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t vertices = 0;
  bool closed = true;
  bool manifold = true;
  bool orientable = true;
};

class Checker {
 public:
  Checker(const LinkedMesh& mesh, const MeshCheckOptions& options, const Execution& execution)
      : mesh_(mesh), options_(options), execution_(execution) {}

  MeshReport check() {
    check_vertices();
    check_triangles();
    find_patches();
    check_edges();
    join_patches();
    check_links();
    check_components();
    conclude();
    return std::move(report_);
  }

 private:
  // The smallest of the examples.
  template <class T>
  std::vector<T> examples(std::vector<T> all) const {
    const std::size_t kept = std::min(all.size(), options_.max_examples);
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end());
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept)};
  }

  void check_vertices() {
    report_.vertices = mesh_.points.size();
    std::span<const Point> points = mesh_.points.span();
    std::vector<VertexId> non_finite;
    for (const VertexId v : mesh_.points.ids()) {
      if (!is_finite(mesh_.points[v])) non_finite.push_back(mesh_.vertex_of[v]);
    }
    report_.non_finite_vertices = non_finite.size();
    report_.examples.non_finite_vertices = examples(std::move(non_finite));
    points = points.first(points.size() - report_.non_finite_vertices);  // they come last
    report_.coincident_vertices = repeated_points(points).size();

    IdVector<VertexId, char> used(mesh_.points.size(), 0);
    for (const VertexId v : mesh_.points.ids()) used[v] = mesh_.corners_at(v).empty() ? 0 : 1;
    vertices_with_edges_ = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
    for (const Triangle& triangle : mesh_.improper) {
      for (const VertexId v : triangle) used[v] = 1;
    }
    report_.used_vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
    report_.unused_vertices = report_.vertices - report_.used_vertices;
  }

  void check_triangles() {
    report_.triangles = mesh_.triangles.size() + mesh_.improper.size();
    report_.repeated_vertex_triangles = mesh_.improper.size();
    report_.examples.repeated_vertex_triangles = examples(mesh_.improper_of);
    std::vector<TriangleId> flat =
        collect<TriangleId>(mesh_.triangles.size(), triangles_per_chunk, execution_,
                            [&](std::size_t t, std::vector<TriangleId>& found) {
                              if (has_no_area(mesh_.triangles[t]))
                                found.push_back(mesh_.triangle_of[t]);
                            });
    report_.zero_area_triangles = flat.size();
    report_.examples.zero_area_triangles = examples(std::move(flat));
  }

  bool has_no_area(const Triangle& triangle) const {
    const Point& a = mesh_.points[triangle[0]];
    const Point& b = mesh_.points[triangle[1]];
    const Point& c = mesh_.points[triangle[2]];
    return is_finite(a) && is_finite(b) && is_finite(c) && are_collinear(a, b, c);
  }

  VertexPair edge_of(Halfedge halfedge) const {
    const VertexId a = mesh_.vertex_of[mesh_.from(halfedge)];
    const VertexId b = mesh_.vertex_of[mesh_.to(halfedge)];
    return {std::min(a, b), std::max(a, b)};
  }

  void find_patches() {
    EdgeComponents found = edge_components(
        mesh_.links, execution_, [](Halfedge) { return true; },
        [&](Halfedge halfedge, Halfedge across) {
          return mesh_.from(halfedge) == mesh_.from(across);
        });
    patch_ = std::move(found.component_of);
    for (const EdgeComponent& component : found.components) {
      patches_.push_back({.first_triangle = TriangleId(),
                          .triangles = component.triangles,
                          .orientable = !component.is_contradictory});
    }
    for (std::size_t t = 0; t < patch_.size(); ++t) {
      TriangleId& first = patches_[patch_[t]].first_triangle;
      first = std::min(first, mesh_.triangle_of[t]);
    }
  }

  // Irregular edges are few; they are looked at one by one.
  void check_edges() {
    at_overfull_ = IdVector<VertexId, char>(mesh_.points.size(), 0);
    at_irregular_ = at_overfull_;
    for (Patch& patch : patches_) patch.edges = 3 * patch.triangles;  // halfedges with a partner
    std::vector<Halfedge> ring;
    std::vector<std::size_t> other_edges(patches_.size(), 0);  // without two triangles
    for (const Halfedge halfedge : mesh_.irregular) {
      ring.clear();
      for_each_at_edge(mesh_.links, halfedge, [&](Halfedge other) { ring.push_back(other); });
      if (ring.size() != 2) {
        for (const Halfedge s : ring) --patches_[patch_[triangle_of_halfedge(s)]].edges;
        ++other_edges[patch_[triangle_of_halfedge(halfedge)]];
        patches_[patch_[triangle_of_halfedge(halfedge)]].closed = false;
      }
      if (ring.size() > 2) overfull_.push_back(halfedge);
      at_irregular_[mesh_.from(halfedge)] = at_irregular_[mesh_.to(halfedge)] = 1;
      check_irregular_edge(ring);
    }
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      patches_[k].edges = patches_[k].edges / 2 + other_edges[k];
      report_.edges += patches_[k].edges;
    }
    for (const Halfedge halfedge : overfull_) {
      at_overfull_[mesh_.from(halfedge)] = at_overfull_[mesh_.to(halfedge)] = 1;
    }
    report_.examples.open_edges = examples(open_);
    report_.examples.overfull_edges = examples(std::move(report_.examples.overfull_edges));
    report_.examples.orientation_conflicts =
        examples(std::move(report_.examples.orientation_conflicts));
    report_.duplicate_triangles = duplicates_.size();
    report_.examples.duplicate_triangles = examples(std::move(duplicates_));
  }

  void check_irregular_edge(std::span<const Halfedge> ring) {
    const VertexPair edge = edge_of(ring[0]);
    const auto forward =
        static_cast<std::size_t>(std::count_if(ring.begin(), ring.end(), [&](Halfedge halfedge) {
          return mesh_.from(halfedge) == mesh_.from(ring[0]);
        }));
    if (ring.size() == 1) {
      ++report_.open_edges;
      open_.push_back(edge);
    }
    if (ring.size() > 2) {
      ++report_.overfull_edges;
      report_.examples.overfull_edges.push_back(edge);
    }
    if (ring.size() % 2 == 1) ++report_.odd_edges;
    if (2 * forward != ring.size()) {
      ++report_.unbalanced_edges;
      if (ring.size() > 2) ++unbalanced_overfull_edges_;
    }
    if (ring.size() == 2 && forward != 1) {
      ++report_.orientation_conflicts;
      report_.examples.orientation_conflicts.push_back(edge);
    }
    find_duplicates(ring);
  }

  // Triangles with the same three vertices lie together on every edge, with the same vertex
  // opposite; told at the edge that is opposite the smallest.
  void find_duplicates(std::span<const Halfedge> ring) {
    const VertexId smaller_end = std::min(mesh_.from(ring[0]), mesh_.to(ring[0]));
    std::vector<std::pair<VertexId, TriangleId>> opposite;
    for (const Halfedge halfedge : ring) {
      if (mesh_.apex(halfedge) >= smaller_end) continue;
      opposite.emplace_back(mesh_.apex(halfedge),
                            mesh_.triangle_of[triangle_of_halfedge(halfedge)]);
    }
    std::sort(opposite.begin(), opposite.end());
    for (std::size_t k = 1; k < opposite.size(); ++k) {
      if (opposite[k].first == opposite[k - 1].first) duplicates_.push_back(opposite[k].second);
    }
  }

  // Patches that meet at edges with more than two triangles make one component.
  void join_patches() {
    DisjointSets sets(patches_.size());
    for (const Halfedge halfedge : overfull_) {
      for_each_at_edge(mesh_.links, mesh_.links[halfedge], [&](Halfedge other) {
        sets.join(patch_[triangle_of_halfedge(halfedge)], patch_[triangle_of_halfedge(other)]);
      });
    }
    component_of_patch_.resize(patches_.size());
    for (std::uint32_t k = 0; k < patches_.size(); ++k) {
      const std::uint32_t root = sets.root(k);
      component_of_patch_[k] =
          root == k ? static_cast<std::uint32_t>(components_.size()) : component_of_patch_[root];
      if (root == k) {
        components_.push_back(patches_[k]);
        continue;
      }
      Patch& component = components_[component_of_patch_[k]];
      component.first_triangle = std::min(component.first_triangle, patches_[k].first_triangle);
      component.triangles += patches_[k].triangles;
      component.edges += patches_[k].edges;
      component.closed = component.closed && patches_[k].closed;
      component.orientable = component.orientable && patches_[k].orientable;
    }
  }

  std::uint32_t component_at(Halfedge halfedge) const {
    return component_of_patch_[patch_[triangle_of_halfedge(halfedge)]];
  }

  // A vertex is pinched iff its link, the graph of the edges opposite to it in its triangles, is
  // not one single path or cycle: if a spoke has more than two triangles, or if a walk around the
  // vertex does not meet all of them.
  void check_links() {
    const std::vector<VertexId> pinched =
        collect<VertexId>(mesh_.points.size(), vertices_per_chunk, execution_,
                          [&](std::size_t i, std::vector<VertexId>& found) {
                            const VertexId v(i);
                            if (mesh_.corners_at(v).empty()) return;
                            if (at_overfull_[v] != 0 || !walks_around(v)) found.push_back(v);
                          });
    for (const VertexId v : pinched) {
      report_.examples.pinched_vertices.push_back(mesh_.vertex_of[v]);
      for (const Halfedge halfedge : mesh_.corners_at(v))
        components_[component_at(halfedge)].manifold = false;
    }
    report_.pinched_vertices = pinched.size();
    report_.examples.pinched_vertices = examples(std::move(report_.examples.pinched_vertices));
    count_vertices();
    count_boundary_curves();
  }

  // Precondition: v has a triangle, and no spoke of v has more than two. If all its spokes are
  // regular its triangles make cycles, each of three or more.
  bool walks_around(VertexId v) const {
    const std::span<const Halfedge> corners = mesh_.corners_at(v);
    std::size_t met = 1;
    // From there on the first cycle must be the only one.
    const std::size_t enough = at_irregular_[v] != 0 ? corners.size() + 1 : corners.size() - 2;
    const std::size_t opposite = corner_of_halfedge(corners[0]);
    for (const std::size_t arrived : {next_corner(opposite), previous_corner(opposite)}) {
      Halfedge corner = corners[0];
      std::size_t spoke = 3 - opposite - arrived;
      for (;;) {
        const Halfedge crossed = 3 * triangle_of_halfedge(corner) + static_cast<Halfedge>(spoke);
        const Halfedge across = mesh_.links[crossed];
        if (across == crossed) break;  // an open edge; the other way remains
        const std::size_t entered = corner_of_halfedge(across);
        const std::size_t at = corner_at_vertex(mesh_.triangles[triangle_of_halfedge(across)], v);
        corner = 3 * triangle_of_halfedge(across) + static_cast<Halfedge>(at);
        spoke = 3 - entered - at;
        if (corner == corners[0]) return met == corners.size();
        if (++met == enough) return true;
      }
    }
    return met == corners.size();
  }

  // Of the components, and which of them share vertices.
  void count_vertices() {
    report_.vertex_components = components_.size();
    if (components_.size() == 1) {
      components_[0].vertices = vertices_with_edges_;
      return;
    }
    DisjointSets sets(components_.size());
    std::vector<std::uint32_t> at_vertex;
    for (const VertexId v : mesh_.points.ids()) {
      at_vertex.clear();
      for (const Halfedge halfedge : mesh_.corners_at(v))
        at_vertex.push_back(component_at(halfedge));
      std::sort(at_vertex.begin(), at_vertex.end());
      at_vertex.erase(std::unique(at_vertex.begin(), at_vertex.end()), at_vertex.end());
      for (const std::uint32_t component : at_vertex) {
        ++components_[component].vertices;
        report_.vertex_components -= sets.join(at_vertex[0], component) ? 1U : 0U;
      }
    }
  }

  void count_boundary_curves() {
    std::vector<VertexId> ends;
    for (const VertexPair& edge : open_) ends.insert(ends.end(), edge.begin(), edge.end());
    make_set(ends);
    const auto place = [&ends](VertexId v) {
      return static_cast<std::uint32_t>(std::lower_bound(ends.begin(), ends.end(), v) -
                                        ends.begin());
    };
    DisjointSets curves(ends.size());
    report_.boundary_curves = ends.size();
    for (const auto& [a, b] : open_) {
      report_.boundary_curves -= curves.join(place(a), place(b)) ? 1U : 0U;
    }
  }

  void check_components() {
    report_.components = components_.size();
    std::sort(components_.begin(), components_.end(),
              [](const Patch& a, const Patch& b) { return a.first_triangle < b.first_triangle; });
    for (const Patch& patch : components_) {
      MeshComponent component;
      component.first_triangle = patch.first_triangle;
      component.triangles = patch.triangles;
      component.vertices = patch.vertices;
      component.edges = patch.edges;
      component.closed = patch.closed;
      component.manifold = patch.manifold;
      component.orientable = patch.orientable;
      component.euler = static_cast<std::ptrdiff_t>(patch.vertices + patch.triangles) -
                        static_cast<std::ptrdiff_t>(patch.edges);
      if (component.closed && component.manifold && component.orientable) {
        component.genus = static_cast<std::size_t>((2 - component.euler) / 2);
      }
      report_.component_reports.push_back(component);
    }
  }

  void conclude() {
    MeshReport& r = report_;
    const std::size_t proper_triangles = r.triangles - r.repeated_vertex_triangles;
    r.euler = static_cast<std::ptrdiff_t>(vertices_with_edges_ + proper_triangles) -
              static_cast<std::ptrdiff_t>(r.edges);
    r.watertight = proper_triangles > 0 && r.odd_edges == 0;
    r.balanced = proper_triangles > 0 && r.unbalanced_edges == 0;
    r.edge_manifold = r.overfull_edges == 0;
    r.vertex_manifold = r.pinched_vertices == 0;
    r.oriented = r.orientation_conflicts == 0 && unbalanced_overfull_edges_ == 0;
    r.orientable = true;
    std::size_t genus = 0;
    bool all_have_genus = proper_triangles > 0;
    for (const MeshComponent& component : r.component_reports) {
      r.orientable = r.orientable && component.orientable;
      all_have_genus = all_have_genus && component.genus.has_value();
      genus += component.genus.value_or(0);
    }
    if (all_have_genus) r.genus = genus;
  }

  const LinkedMesh& mesh_;
  const MeshCheckOptions& options_;
  const Execution& execution_;
  MeshReport report_;
  std::vector<std::uint32_t> patch_;  // per triangle
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> component_of_patch_;
  std::vector<Patch> components_;
  std::vector<Halfedge> overfull_;        // a halfedge of each edge with more than two
  IdVector<VertexId, char> at_overfull_;  // ends of such edges
  IdVector<VertexId, char> at_irregular_;
  std::vector<VertexPair> open_;        // edges, as they were given
  std::vector<TriangleId> duplicates_;  // as they were given
  std::size_t vertices_with_edges_ = 0;
  std::size_t unbalanced_overfull_edges_ = 0;
};

}  // namespace

MeshReport mesh_check(const LinkedMesh& mesh, const MeshCheckOptions& options,
                      const Execution& execution) {
  return Checker(mesh, options, execution).check();
}

MeshReport mesh_check(const TriangleMesh& mesh, const MeshCheckOptions& options,
                      const Execution& execution) {
  return mesh_check(link_mesh(mesh, execution), options, execution);
}

}  // namespace cocoon
