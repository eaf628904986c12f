#include "geom/mesh_check.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "geom/errors.h"
#include "geom/orient3d.h"

namespace cocoon {
namespace {

// Disjoint sets with a parity on the way to the root: two triangles of one set have equal parity
// iff they agree in orientation. Sets are joined under the smaller root, so a root is the
// smallest member of its set.
class ParitySets {
 public:
  explicit ParitySets(std::size_t count) : parent_(count), parity_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  // Root of `member` and its parity against the root. Halves the path.
  std::pair<std::size_t, int> find(std::size_t member) {
    int parity = 0;
    while (parent_[member] != member) {
      const std::size_t up = parent_[member];
      parity_[member] ^= parity_[up];
      parent_[member] = parent_[up];
      parity ^= parity_[member];
      member = parent_[member];
    }
    return {member, parity};
  }
  std::size_t root(std::size_t member) { return find(member).first; }

  // States that a and b differ by `parity`. False if that contradicts what is known.
  bool join(std::size_t a, std::size_t b, int parity) {
    auto [root_a, parity_a] = find(a);
    auto [root_b, parity_b] = find(b);
    const int between = parity_a ^ parity_b ^ parity;
    if (root_a == root_b) return between == 0;
    if (root_b < root_a) std::swap(root_a, root_b);
    parent_[root_b] = root_a;
    parity_[root_b] = between;
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<int> parity_;  // against the parent; 0 at a root
};

// One side of a triangle.
struct Side {
  VertexPair edge;
  TriangleId triangle;
  bool forward = true;  // runs from edge[0] to edge[1]
  friend auto operator<=>(const Side&, const Side&) = default;
};

// A triangle's corner at `vertex`, seen as an edge of the vertex's link.
struct LinkEdge {
  VertexId vertex;
  VertexPair ends;
  friend auto operator<=>(const LinkEdge&, const LinkEdge&) = default;
};

VertexPair sorted_pair(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

bool repeats_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

class Checker {
 public:
  Checker(const TriangleMesh& mesh, const MeshCheckOptions& options)
      : mesh_(mesh),
        options_(options),
        connected_(mesh.triangles.size()),
        agreeing_(mesh.triangles.size()) {}

  MeshReport check() {
    require_indices();
    check_vertices();
    check_triangles();
    check_edges();
    check_links();
    check_components();
    conclude();
    return std::move(report_);
  }

 private:
  template <class T>
  void add_example(std::vector<T>& list, const T& example) const {
    if (list.size() < options_.max_examples) list.push_back(example);
  }

  void require_indices() const {
    for (const TriangleId t : mesh_.triangles.ids()) {
      for (const VertexId v : mesh_.triangles[t]) {
        if (v.index() < mesh_.points.size()) continue;
        throw InputError("triangle " + std::to_string(t.value) + " names vertex " +
                         std::to_string(v.value) + " of a mesh with " +
                         std::to_string(mesh_.points.size()) + " vertices; repair its indices");
      }
    }
  }

  void check_vertices() {
    report_.vertices = mesh_.points.size();
    std::vector<Point> sorted;
    for (const VertexId v : mesh_.points.ids()) {
      if (is_finite(mesh_.points[v])) {
        sorted.push_back(mesh_.points[v]);
      } else {
        ++report_.non_finite_vertices;
        add_example(report_.examples.non_finite_vertices, v);
      }
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const Point& a, const Point& b) { return (a <=> b) < 0; });
    const auto distinct_end = std::unique(sorted.begin(), sorted.end());
    report_.coincident_vertices = static_cast<std::size_t>(sorted.end() - distinct_end);

    IdVector<VertexId, char> used(mesh_.points.size(), 0);
    for (const Triangle& triangle : mesh_.triangles) {
      for (const VertexId v : triangle) used[v] = 1;
    }
    report_.used_vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
    report_.unused_vertices = report_.vertices - report_.used_vertices;
  }

  // Sorts out the triangles that are no triangles.
  void check_triangles() {
    report_.triangles = mesh_.triangles.size();
    std::vector<std::pair<Triangle, TriangleId>> by_vertices;
    for (const TriangleId t : mesh_.triangles.ids()) {
      Triangle triangle = mesh_.triangles[t];
      if (repeats_vertex(triangle)) {
        ++report_.repeated_vertex_triangles;
        add_example(report_.examples.repeated_vertex_triangles, t);
        continue;
      }
      const Point& a = mesh_.points[triangle[0]];
      const Point& b = mesh_.points[triangle[1]];
      const Point& c = mesh_.points[triangle[2]];
      if (is_finite(a) && is_finite(b) && is_finite(c) && are_collinear(a, b, c)) {
        ++report_.zero_area_triangles;
        add_example(report_.examples.zero_area_triangles, t);
      }
      std::sort(triangle.begin(), triangle.end());
      by_vertices.emplace_back(triangle, t);
    }
    std::sort(by_vertices.begin(), by_vertices.end());
    std::vector<TriangleId> duplicates;
    for (std::size_t k = 1; k < by_vertices.size(); ++k) {
      if (by_vertices[k].first == by_vertices[k - 1].first) {
        duplicates.push_back(by_vertices[k].second);
      }
    }
    std::sort(duplicates.begin(), duplicates.end());
    report_.duplicate_triangles = duplicates.size();
    for (const TriangleId t : duplicates) add_example(report_.examples.duplicate_triangles, t);
  }

  void check_edges() {
    for (const TriangleId t : mesh_.triangles.ids()) {
      const Triangle& triangle = mesh_.triangles[t];
      if (repeats_vertex(triangle)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId from = triangle[i];
        const VertexId to = triangle[(i + 1) % 3];
        sides_.push_back({sorted_pair(from, to), t, from < to});
      }
    }
    std::sort(sides_.begin(), sides_.end());
    contradicted_.assign(mesh_.triangles.size(), 0);
    for_each_edge([this](std::size_t begin, std::size_t end) { check_edge(begin, end); });
  }

  // Calls visit(begin, end) for the range of sides of every edge.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      while (end < sides_.size() && sides_[end].edge == sides_[begin].edge) ++end;
      visit(begin, end);
    }
  }

  void check_edge(std::size_t begin, std::size_t end) {
    const VertexPair& edge = sides_[begin].edge;
    const std::size_t count = end - begin;
    std::size_t forward = 0;
    for (std::size_t k = begin; k < end; ++k) forward += sides_[k].forward ? 1 : 0;
    ++report_.edges;
    if (count == 1) {
      ++report_.open_edges;
      add_example(report_.examples.open_edges, edge);
    }
    if (count > 2) {
      ++report_.overfull_edges;
      add_example(report_.examples.overfull_edges, edge);
    }
    if (count % 2 == 1) ++report_.odd_edges;
    if (2 * forward != count) {
      ++report_.unbalanced_edges;
      if (count > 2) ++unbalanced_overfull_edges_;
    }
    if (count == 2 && forward != 1) {
      ++report_.orientation_conflicts;
      add_example(report_.examples.orientation_conflicts, edge);
    }
    const std::size_t first = sides_[begin].triangle.index();
    for (std::size_t k = begin + 1; k < end; ++k) {
      connected_.join(first, sides_[k].triangle.index(), 0);
    }
    if (count == 2) {
      // Only where exactly two triangles meet does one orientation follow from the other.
      const int parity = forward == 1 ? 0 : 1;
      if (!agreeing_.join(first, sides_[begin + 1].triangle.index(), parity)) {
        contradicted_[first] = 1;
      }
    }
  }

  // A vertex is pinched iff its link, the graph of the edges opposite to it in its triangles, is
  // not one single path or cycle.
  void check_links() {
    std::vector<LinkEdge> links;
    links.reserve(sides_.size());
    for (const Triangle& triangle : mesh_.triangles) {
      if (repeats_vertex(triangle)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        links.push_back({triangle[i], sorted_pair(triangle[(i + 1) % 3], triangle[(i + 2) % 3])});
      }
    }
    std::sort(links.begin(), links.end());
    pinched_.resize(mesh_.points.size(), 0);
    for (std::size_t begin = 0, end = 0; begin < links.size(); begin = end) {
      while (end < links.size() && links[end].vertex == links[begin].vertex) ++end;
      const VertexId v = links[begin].vertex;
      if (is_path_or_cycle({links.data() + begin, end - begin})) continue;
      pinched_[v] = 1;
      ++report_.pinched_vertices;
      add_example(report_.examples.pinched_vertices, v);
    }
  }

  // A connected graph whose nodes all have one or two edges is a path or a cycle.
  static bool is_path_or_cycle(std::span<const LinkEdge> link) {
    std::vector<VertexId> ends;
    for (const LinkEdge& edge : link) ends.insert(ends.end(), edge.ends.begin(), edge.ends.end());
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 2; k < ends.size(); ++k) {
      if (ends[k] == ends[k - 2]) return false;
    }
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto node = [&ends](VertexId v) {
      return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), v) - ends.begin());
    };
    ParitySets connected(ends.size());
    for (const LinkEdge& edge : link) connected.join(node(edge.ends[0]), node(edge.ends[1]), 0);
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (connected.root(k) != 0) return false;
    }
    return true;
  }

  void check_components() {
    count_vertex_components();
    // One report for each root, in the order of roots: each is the smallest triangle of its set.
    std::vector<std::size_t> component_of_root(mesh_.triangles.size());
    for (const TriangleId t : mesh_.triangles.ids()) {
      if (repeats_vertex(mesh_.triangles[t])) continue;
      const std::size_t root = connected_.root(t.index());
      if (root == t.index()) {
        component_of_root[root] = report_.component_reports.size();
        MeshComponent component;
        component.first_triangle = t;
        component.closed = component.manifold = component.orientable = true;
        report_.component_reports.push_back(component);
      }
      ++report_.component_reports[component_of_root[root]].triangles;
    }
    report_.components = report_.component_reports.size();
    const auto component_of = [&](TriangleId t) -> MeshComponent& {
      return report_.component_reports[component_of_root[connected_.root(t.index())]];
    };
    for_each_edge([&](std::size_t begin, std::size_t end) {
      MeshComponent& component = component_of(sides_[begin].triangle);
      ++component.edges;
      if (end - begin != 2) component.closed = false;
      if (end - begin > 2) component.manifold = false;
    });
    for (const TriangleId t : mesh_.triangles.ids()) {
      if (contradicted_[t.index()] != 0) component_of(t).orientable = false;
    }
    count_component_vertices(component_of);
    for (MeshComponent& component : report_.component_reports) finish(component);
  }

  template <class ComponentOf>
  void count_component_vertices(const ComponentOf& component_of) {
    std::vector<std::pair<VertexId, MeshComponent*>> incidences;
    for (const TriangleId t : mesh_.triangles.ids()) {
      const Triangle& triangle = mesh_.triangles[t];
      if (repeats_vertex(triangle)) continue;
      for (const VertexId v : triangle) incidences.emplace_back(v, &component_of(t));
    }
    std::sort(incidences.begin(), incidences.end());
    incidences.erase(std::unique(incidences.begin(), incidences.end()), incidences.end());
    for (const auto& [vertex, component] : incidences) {
      ++component->vertices;
      if (pinched_[vertex] != 0) component->manifold = false;
    }
  }

  static void finish(MeshComponent& component) {
    component.euler = static_cast<std::ptrdiff_t>(component.vertices + component.triangles) -
                      static_cast<std::ptrdiff_t>(component.edges);
    if (component.closed && component.manifold && component.orientable) {
      component.genus = static_cast<std::size_t>((2 - component.euler) / 2);
    }
  }

  // Counts the sets of vertices joined by edges: all edges, and open edges only.
  void count_vertex_components() {
    ParitySets all(mesh_.points.size());
    ParitySets open(mesh_.points.size());
    std::size_t joined_all = 0;
    std::size_t joined_open = 0;
    std::vector<char> in_triangle(mesh_.points.size(), 0);
    std::vector<char> on_boundary(mesh_.points.size(), 0);
    for_each_edge([&](std::size_t begin, std::size_t end) {
      const auto [a, b] = sides_[begin].edge;
      in_triangle[a.index()] = in_triangle[b.index()] = 1;
      if (all.root(a.index()) != all.root(b.index())) ++joined_all;
      all.join(a.index(), b.index(), 0);
      if (end - begin != 1) return;
      on_boundary[a.index()] = on_boundary[b.index()] = 1;
      if (open.root(a.index()) != open.root(b.index())) ++joined_open;
      open.join(a.index(), b.index(), 0);
    });
    const auto count = [](const std::vector<char>& flags) {
      return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
    };
    vertices_with_edges_ = count(in_triangle);
    report_.vertex_components = vertices_with_edges_ - joined_all;
    report_.boundary_curves = count(on_boundary) - joined_open;
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

  const TriangleMesh& mesh_;
  const MeshCheckOptions& options_;
  MeshReport report_;
  ParitySets connected_;              // triangles joined by edges
  ParitySets agreeing_;               // by edges with two triangles; parity = turned
  std::vector<Side> sides_;           // of all proper triangles, sorted by edge
  std::vector<char> contradicted_;    // by triangle: an edge of it contradicts the orientation
  IdVector<VertexId, char> pinched_;  // by vertex
  std::size_t vertices_with_edges_ = 0;
  std::size_t unbalanced_overfull_edges_ = 0;
};

}  // namespace

MeshReport mesh_check(const TriangleMesh& mesh, const MeshCheckOptions& options) {
  return Checker(mesh, options).check();
}

}  // namespace cocoon
