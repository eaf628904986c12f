#include "geom/mesh_check.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "geom/errors.h"
#include "geom/orient3d.h"
#include "geom/side_links.h"

namespace cocoon {
namespace {

// Disjoint sets of 0 .. count - 1. Sets are joined under the smaller root, so a root is the
// smallest member of its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  // Halves the path.
  std::uint32_t root(std::uint32_t member) {
    while (parent_[member] != member) {
      member = parent_[member] = parent_[parent_[member]];
    }
    return member;
  }
  // True if they were in different sets.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// How many of the points are different from all before them, by an open hash table.
std::size_t count_distinct(std::span<const Point> points) {
  std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size() + 1), 0);  // place + 1
  const auto mixed = [](std::uint64_t word) {
    word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9U;
    word = (word ^ (word >> 27)) * 0x94D049BB133111EBU;
    return word ^ (word >> 31);
  };
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };  // -0 is 0
  std::size_t distinct = 0;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    const Point& p = points[k];
    std::size_t slot = mixed(bits(p.x) + mixed(bits(p.y) + mixed(bits(p.z))));
    for (;; ++slot) {
      slot &= table.size() - 1;
      if (table[slot] == 0) {
        table[slot] = k + 1;
        ++distinct;
        break;
      }
      if (points[table[slot] - 1] == p) break;
    }
  }
  return distinct;
}

bool repeats_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Triangles that hang together by edges with exactly two triangles. A component consists of one or
// more: over edges with more triangles nothing follows for the orientation.
struct Patch {
  std::uint32_t first_triangle = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t vertices = 0;
  bool closed = true;
  bool manifold = true;
  bool orientable = true;
};

class Checker {
 public:
  Checker(const TriangleMesh& mesh, const MeshCheckOptions& options)
      : mesh_(mesh), options_(options) {}

  MeshReport check() {
    require_indices();
    check_vertices();
    check_triangles();
    links_ = side_links(triangles_, mesh_.points.size());
    find_patches();
    check_edges();
    join_patches();
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
    std::vector<Point> finite;
    std::span<const Point> points = mesh_.points.span();
    for (const VertexId v : mesh_.points.ids()) {
      if (is_finite(mesh_.points[v])) continue;
      ++report_.non_finite_vertices;
      add_example(report_.examples.non_finite_vertices, v);
    }
    if (report_.non_finite_vertices > 0) {
      std::copy_if(points.begin(), points.end(), std::back_inserter(finite), is_finite);
      points = finite;
    }
    report_.coincident_vertices = points.size() - count_distinct(points);

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
    for (const TriangleId t : mesh_.triangles.ids()) {
      const Triangle& triangle = mesh_.triangles[t];
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
    }
    triangles_ = mesh_.triangles.span();
    if (report_.repeated_vertex_triangles == 0) return;
    for (const TriangleId t : mesh_.triangles.ids()) {
      if (repeats_vertex(mesh_.triangles[t])) continue;
      proper_.push_back(mesh_.triangles[t]);
      ids_of_proper_.push_back(t);
    }
    triangles_ = proper_;
  }

  TriangleId id_of(std::uint32_t triangle) const {
    return ids_of_proper_.empty() ? TriangleId(triangle) : ids_of_proper_[triangle];
  }
  VertexId from(SideId side) const {
    return triangles_[triangle_of_side(side)][next_corner(corner_of_side(side))];
  }
  VertexId to(SideId side) const {
    return triangles_[triangle_of_side(side)][previous_corner(corner_of_side(side))];
  }
  VertexPair edge_of(SideId side) const {
    return {std::min(from(side), to(side)), std::max(from(side), to(side))};
  }
  // Exactly two triangles at the edge of the side.
  bool is_two_sided(SideId side) const {
    return links_[side] != side && links_[links_[side]] == side;
  }

  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  // Patches are found from their smallest triangles, so they are numbered in their order.
  void find_patches() {
    patch_.assign(triangles_.size(), none);
    turned_.assign(triangles_.size(), 0);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (patch_[t] != none) continue;
      patches_.push_back({.first_triangle = t});
      patch_[t] = static_cast<std::uint32_t>(patches_.size() - 1);
      stack.push_back(t);
      while (!stack.empty()) {
        const std::uint32_t next = stack.back();
        stack.pop_back();
        ++patches_.back().triangles;
        for (SideId side = 3 * next; side < 3 * next + 3; ++side) {
          if (is_two_sided(side) && !spread_patch(side, stack)) patches_.back().orientable = false;
        }
      }
    }
  }

  // Over an edge with two triangles: one orientation follows from the other. False if it
  // contradicts what is known.
  bool spread_patch(SideId side, std::vector<std::uint32_t>& stack) {
    const std::uint32_t here = triangle_of_side(side);
    const std::uint32_t there = triangle_of_side(links_[side]);
    const bool conflict = from(side) == from(links_[side]);
    const auto turned = static_cast<char>(turned_[here] ^ (conflict ? 1 : 0));
    if (patch_[there] != none) return turned_[there] == turned;
    patch_[there] = patch_[here];
    turned_[there] = turned;
    stack.push_back(there);
    return true;
  }

  void check_edges() {
    at_overfull_ = IdVector<VertexId, char>(mesh_.points.size(), 0);
    std::vector<SideId> ring;
    for (SideId side = 0; side < links_.size(); ++side) {
      SideId other = links_[side];
      while (other > side) other = links_[other];
      if (other < side) continue;  // told by the first side of the edge
      ++report_.edges;
      Patch& patch = patches_[patch_[triangle_of_side(side)]];
      ++patch.edges;
      if (is_two_sided(side) && from(side) == to(links_[side]) &&
          apex(side) != apex(links_[side])) {
        continue;
      }
      ring.clear();
      do {
        ring.push_back(other);
        other = links_[other];
      } while (other != side);
      if (ring.size() != 2) patch.closed = false;
      if (ring.size() > 2) {
        patch.manifold = false;
        at_overfull_[from(side)] = at_overfull_[to(side)] = 1;
        overfull_.push_back(side);
      }
      check_irregular_edge(ring);
    }
    sort_examples(report_.examples.open_edges);
    sort_examples(report_.examples.overfull_edges);
    sort_examples(report_.examples.orientation_conflicts);
    std::sort(duplicates_.begin(), duplicates_.end());
    report_.duplicate_triangles = duplicates_.size();
    for (const std::uint32_t t : duplicates_) {
      add_example(report_.examples.duplicate_triangles, id_of(t));
    }
  }

  VertexId apex(SideId side) const {
    return triangles_[triangle_of_side(side)][corner_of_side(side)];
  }

  void check_irregular_edge(std::span<const SideId> ring) {
    const VertexPair edge = edge_of(ring[0]);
    const auto forward = static_cast<std::size_t>(std::count_if(
        ring.begin(), ring.end(), [&](SideId side) { return from(side) == edge[0]; }));
    if (ring.size() == 1) {
      ++report_.open_edges;
      report_.examples.open_edges.push_back(edge);
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
    find_duplicates(edge[0], ring);
  }

  // Triangles with the same three vertices lie together on every edge, with the same vertex
  // opposite; told at the edge that is opposite the smallest.
  void find_duplicates(VertexId smaller_end, std::span<const SideId> ring) {
    std::vector<std::pair<VertexId, std::uint32_t>> opposite;
    for (const SideId side : ring) {
      if (apex(side) < smaller_end) opposite.emplace_back(apex(side), triangle_of_side(side));
    }
    std::sort(opposite.begin(), opposite.end());
    for (std::size_t k = 1; k < opposite.size(); ++k) {
      if (opposite[k].first == opposite[k - 1].first) duplicates_.push_back(opposite[k].second);
    }
  }

  void sort_examples(std::vector<VertexPair>& list) const {
    const std::size_t kept = std::min(list.size(), options_.max_examples);
    std::partial_sort(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(kept), list.end());
    list.resize(kept);
    list.shrink_to_fit();
  }

  // Patches that meet at edges with more than two triangles make one component.
  void join_patches() {
    DisjointSets sets(patches_.size());
    for (const SideId side : overfull_) {
      for (SideId other = links_[side]; other != side; other = links_[other]) {
        sets.join(patch_[triangle_of_side(side)], patch_[triangle_of_side(other)]);
      }
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
      component.triangles += patches_[k].triangles;
      component.edges += patches_[k].edges;
      component.closed = component.closed && patches_[k].closed;
      component.manifold = component.manifold && patches_[k].manifold;
      component.orientable = component.orientable && patches_[k].orientable;
    }
  }

  std::uint32_t component_of(std::uint32_t triangle) const {
    return component_of_patch_[patch_[triangle]];
  }

  // What meets at a vertex: its triangles, and a component beyond the first.
  struct Corners {
    std::uint32_t count = 0;
    SideId one = 0;  // the side opposite the vertex in one of the triangles
    std::uint32_t component = none;
  };
  using FurtherComponent = std::pair<VertexId, std::uint32_t>;

  // A vertex is pinched iff its link, the graph of the edges opposite to it in its triangles, is
  // not one single path or cycle: if a spoke has more than two triangles, or if a walk around the
  // vertex does not meet all of them.
  void check_links() {
    IdVector<VertexId, Corners> corners(mesh_.points.size());
    std::vector<FurtherComponent> further;
    for (SideId side = 0; side < links_.size(); ++side) {
      const std::uint32_t component = component_of(triangle_of_side(side));
      Corners& at = corners[apex(side)];
      ++at.count;
      at.one = side;
      if (at.component == none) {
        at.component = component;
        ++components_[component].vertices;
      } else if (at.component != component) {
        further.emplace_back(apex(side), component);
      }
    }
    std::sort(further.begin(), further.end());
    further.erase(std::unique(further.begin(), further.end()), further.end());
    for (const auto& [v, component] : further) ++components_[component].vertices;
    for (const VertexId v : corners.ids()) {
      if (corners[v].count == 0) continue;
      ++vertices_with_edges_;
      if (at_overfull_[v] == 0 && walks_around(v, corners[v])) continue;
      ++report_.pinched_vertices;
      add_example(report_.examples.pinched_vertices, v);
      components_[corners[v].component].manifold = false;
      auto also = std::lower_bound(further.begin(), further.end(), FurtherComponent{v, 0});
      for (; also != further.end() && also->first == v; ++also) {
        components_[also->second].manifold = false;
      }
    }
    count_vertex_components(corners, further);
  }

  // Precondition: no spoke of v has more than two triangles.
  bool walks_around(VertexId v, const Corners& corners) const {
    std::uint32_t met = 1;
    const std::size_t opposite = corner_of_side(corners.one);
    for (const std::size_t arrived : {next_corner(opposite), previous_corner(opposite)}) {
      SideId corner = corners.one;
      std::size_t spoke = 3 - opposite - arrived;
      for (;;) {
        const SideId crossed = 3 * triangle_of_side(corner) + static_cast<SideId>(spoke);
        const SideId across = links_[crossed];
        if (across == crossed) break;  // an open edge; the other way remains
        const std::size_t entered = corner_of_side(across);
        const Triangle& triangle = triangles_[triangle_of_side(across)];
        const std::size_t at =
            triangle[next_corner(entered)] == v ? next_corner(entered) : previous_corner(entered);
        corner = 3 * triangle_of_side(across) + static_cast<SideId>(at);
        spoke = 3 - entered - at;
        if (corner == corners.one) return met == corners.count;
        ++met;
      }
    }
    return met == corners.count;
  }

  // Components that share vertices, and curves of open edges.
  void count_vertex_components(const IdVector<VertexId, Corners>& corners,
                               const std::vector<FurtherComponent>& further) {
    DisjointSets sets(components_.size());
    report_.vertex_components = components_.size();
    for (const auto& [v, component] : further) {
      report_.vertex_components -= sets.join(corners[v].component, component) ? 1U : 0U;
    }
    std::vector<VertexId> ends;
    for (const VertexPair& edge : open_) ends.insert(ends.end(), edge.begin(), edge.end());
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
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
    for (const Patch& patch : components_) {
      MeshComponent component;
      component.first_triangle = id_of(patch.first_triangle);
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

  const TriangleMesh& mesh_;
  const MeshCheckOptions& options_;
  MeshReport report_;
  std::span<const Triangle> triangles_;    // the proper ones
  std::vector<Triangle> proper_;           // if not all are
  std::vector<TriangleId> ids_of_proper_;  // their ids then
  std::vector<SideId> links_;
  std::vector<std::uint32_t> patch_;  // per triangle
  std::vector<char> turned_;          // per triangle: against the first one of its patch
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> component_of_patch_;
  std::vector<Patch> components_;
  std::vector<SideId> overfull_;           // a side of each edge with more than two
  IdVector<VertexId, char> at_overfull_;   // ends of such edges
  std::vector<VertexPair> open_;           // edges
  std::vector<std::uint32_t> duplicates_;  // triangles
  std::size_t vertices_with_edges_ = 0;
  std::size_t unbalanced_overfull_edges_ = 0;
};

}  // namespace

MeshReport mesh_check(const TriangleMesh& mesh, const MeshCheckOptions& options) {
  return Checker(mesh, options).check();
}

}  // namespace cocoon
