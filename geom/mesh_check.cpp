#include "geom/mesh_check.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
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
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  // Root of `member` and its parity against the root. Halves the path.
  std::pair<std::size_t, int> find(std::size_t member) {
    int parity = 0;
    while (parent_[member] != member) {
      const std::size_t up = parent_[member];
      parity_[member] = static_cast<std::uint8_t>(parity_[member] ^ parity_[up]);
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
    parent_[root_b] = static_cast<std::uint32_t>(root_a);
    parity_[root_b] = static_cast<std::uint8_t>(between);
    return true;
  }
  // States that a and b agree. True if they were in different sets.
  bool unite(std::size_t a, std::size_t b) {
    if (root(a) == root(b)) return false;
    return join(a, b, 0);
  }

 private:
  std::vector<std::uint32_t> parent_;  // ids of vertices and triangles have 32 bits
  std::vector<std::uint8_t> parity_;   // against the parent; 0 at a root
};

// Sorts items whose order begins with a vertex, vertex_of(item): a counting sort by the vertices
// brings together the few items of each, which are then sorted among themselves.
template <class T, class VertexOf>
void sort_by_vertex(std::vector<T>& items, std::size_t num_vertices, VertexOf vertex_of) {
  std::vector<std::uint32_t> ends(num_vertices + 1, 0);
  for (const T& item : items) ++ends[vertex_of(item).index() + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<T> sorted(items.size());
  for (const T& item : items) sorted[ends[vertex_of(item).index()]++] = item;
  // Placing moved the begin of each range to its end.
  auto begin = sorted.begin();
  for (std::size_t v = 0; v < num_vertices; ++v) {
    const auto end = sorted.begin() + ends[v];
    std::sort(begin, end);
    begin = end;
  }
  items = std::move(sorted);
}

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
  TriangleId triangle;
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
    sort_by_vertex(by_vertices, mesh_.points.size(),
                   [](const auto& triangle) { return triangle.first[0]; });
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
    sides_.reserve(3 * mesh_.triangles.size());
    for (const TriangleId t : mesh_.triangles.ids()) {
      const Triangle& triangle = mesh_.triangles[t];
      if (repeats_vertex(triangle)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId from = triangle[i];
        const VertexId to = triangle[(i + 1) % 3];
        sides_.push_back({sorted_pair(from, to), t, from < to});
      }
    }
    sort_by_vertex(sides_, mesh_.points.size(), [](const Side& side) { return side.edge[0]; });
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
    links_.reserve(sides_.size());
    for (const TriangleId t : mesh_.triangles.ids()) {
      const Triangle& triangle = mesh_.triangles[t];
      if (repeats_vertex(triangle)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        links_.push_back(
            {triangle[i], t, sorted_pair(triangle[(i + 1) % 3], triangle[(i + 2) % 3])});
      }
    }
    sort_by_vertex(links_, mesh_.points.size(), [](const LinkEdge& edge) { return edge.vertex; });
    pinched_.resize(mesh_.points.size(), 0);
    std::vector<VertexPair> edges;
    for_each_link([&](std::span<const LinkEdge> link) {
      edges.clear();
      for (const LinkEdge& edge : link) edges.push_back(edge.ends);
      if (edges.size() <= longest_walked_link ? walks_as_path_or_cycle(edges)
                                              : is_path_or_cycle(edges)) {
        return;
      }
      const VertexId v = link[0].vertex;
      pinched_[v] = 1;
      ++report_.pinched_vertices;
      add_example(report_.examples.pinched_vertices, v);
    });
  }

  // Calls visit(span) for the link of every vertex that has one, in the order of vertices.
  template <class Visit>
  void for_each_link(const Visit& visit) const {
    for (std::size_t begin = 0, end = 0; begin < links_.size(); begin = end) {
      while (end < links_.size() && links_[end].vertex == links_[begin].vertex) ++end;
      visit(std::span(links_).subspan(begin, end - begin));
    }
  }

  // Walking compares all edges with all: better than sorting for the links of ordinary vertices.
  static constexpr std::size_t longest_walked_link = 32;

  // Lengthens a walk at its head, or at its tail when the head is a dead end; the edges of the walk
  // come to the front. At an end of the walk exactly one more edge may be found.
  static bool walks_as_path_or_cycle(std::span<VertexPair> edges) {
    VertexId tail = edges[0][0];
    VertexId head = edges[0][1];
    const auto at_head = [&head](const VertexPair& e) { return e[0] == head || e[1] == head; };
    for (auto rest = edges.begin() + 1; rest != edges.end(); ++rest) {
      if (head == tail) return false;  // closed already
      auto next = std::find_if(rest, edges.end(), at_head);
      if (next == edges.end()) {
        std::swap(head, tail);
        next = std::find_if(rest, edges.end(), at_head);
        if (next == edges.end()) return false;
      }
      if (std::find_if(next + 1, edges.end(), at_head) != edges.end()) return false;
      head = (*next)[0] == head ? (*next)[1] : (*next)[0];
      std::swap(*rest, *next);
    }
    return true;
  }

  // A connected graph whose nodes all have one or two edges is a path or a cycle.
  static bool is_path_or_cycle(std::span<const VertexPair> edges) {
    std::vector<VertexId> ends;
    for (const VertexPair& edge : edges) ends.insert(ends.end(), edge.begin(), edge.end());
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 2; k < ends.size(); ++k) {
      if (ends[k] == ends[k - 2]) return false;
    }
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto node = [&ends](VertexId v) {
      return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), v) - ends.begin());
    };
    ParitySets connected(ends.size());
    for (const VertexPair& edge : edges) connected.join(node(edge[0]), node(edge[1]), 0);
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
    std::vector<MeshComponent*> at_vertex;
    for_each_link([&](std::span<const LinkEdge> link) {
      at_vertex.clear();
      for (const LinkEdge& edge : link) {
        MeshComponent* const component = &component_of(edge.triangle);
        if (at_vertex.empty() || at_vertex.back() != component) at_vertex.push_back(component);
      }
      std::sort(at_vertex.begin(), at_vertex.end());
      at_vertex.erase(std::unique(at_vertex.begin(), at_vertex.end()), at_vertex.end());
      for (MeshComponent* const component : at_vertex) {
        ++component->vertices;
        if (pinched_[link[0].vertex] != 0) component->manifold = false;
      }
    });
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
      joined_all += all.unite(a.index(), b.index());
      if (end - begin != 1) return;
      on_boundary[a.index()] = on_boundary[b.index()] = 1;
      joined_open += open.unite(a.index(), b.index());
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
  std::vector<LinkEdge> links_;       // of all proper triangles, sorted by vertex
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
