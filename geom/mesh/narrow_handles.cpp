#include "geom/mesh/narrow_handles.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "geom/arrays/disjoint_sets.h"
#include "geom/errors.h"
#include "geom/id_vector.h"
#include "geom/point.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// Shortest paths from the lexicographically smallest vertex of each component, and the edges that
// are left when the triangles are joined across all others, those of long cycles first.
class TreeAndCotree {
 public:
  explicit TreeAndCotree(const LinkedMesh& mesh)
      : mesh_(mesh),
        scale_(working_scale(mesh.points.span())),
        distance_(mesh.points.size(), std::numeric_limits<double>::infinity()),
        turn_(mesh.points.size(), 0),
        parent_(mesh.points.size()) {
    rank_vertices();
    for (const VertexId v : by_rank_) {
      if (parent_[v].is_none()) grow(v);
    }
    find_heavy_paths();
  }

  struct Cycle {
    double length = 0;
    std::uint32_t smaller = 0;  // ranks of the ends of its edge
    std::uint32_t larger = 0;
    Halfedge halfedge = 0;

    friend bool operator>(const Cycle& a, const Cycle& b) {
      return std::tie(a.length, a.smaller, a.larger) > std::tie(b.length, b.smaller, b.larger);
    }
  };

  // Those of the edges of neither tree, the shortest first.
  std::vector<Cycle> cycles() const {
    std::vector<Cycle> edges;
    for (Halfedge halfedge = 0; halfedge < mesh_.links.size(); ++halfedge) {
      if (!mesh_.is_last(halfedge) || is_in_tree(halfedge)) continue;
      edges.push_back(cycle_of(mesh_.links[halfedge]));
    }
    std::sort(edges.begin(), edges.end(), std::greater<>());
    DisjointSets joined(mesh_.triangles.size());
    std::erase_if(edges, [&](const Cycle& edge) {
      return joined.join(triangle_of_halfedge(edge.halfedge),
                         triangle_of_halfedge(mesh_.links[edge.halfedge]));
    });
    std::reverse(edges.begin(), edges.end());
    return edges;
  }

  std::vector<VertexId> path_of(Halfedge halfedge) const {
    VertexId a = mesh_.from(halfedge);
    VertexId b = mesh_.to(halfedge);
    if (rank_[b] < rank_[a]) std::swap(a, b);
    std::vector<VertexId> path{a};
    std::vector<VertexId> back{b};
    while (a != b) {
      if (is_farther(a, b)) {
        path.push_back(a = parent_[a]);
      } else {
        back.push_back(b = parent_[b]);
      }
    }
    back.pop_back();  // where they meet is in both
    path.insert(path.end(), back.rbegin(), back.rend());
    return path;
  }

 private:
  // Equal places, as at parted sheets, by what the vertices are called.
  void rank_vertices() {
    by_rank_.reserve(mesh_.points.size());
    for (const VertexId v : mesh_.points.ids()) by_rank_.push_back(v);
    std::sort(by_rank_.begin(), by_rank_.end(), [&](VertexId a, VertexId b) {
      const Point& p = mesh_.points[a];
      const Point& q = mesh_.points[b];
      return p == q ? mesh_.vertex_of[a] < mesh_.vertex_of[b] : p < q;
    });
    rank_.resize(by_rank_.size());
    for (std::uint32_t k = 0; k < by_rank_.size(); ++k) rank_[by_rank_[k]] = k;
  }

  // Times the scale: sums of all must be in the range of double.
  double length(VertexId a, VertexId b) const {
    return norm(scale_ * mesh_.points[b] - scale_ * mesh_.points[a]);
  }

  void grow(VertexId root) {
    using Entry = std::pair<double, std::uint32_t>;  // distance, rank
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    parent_[root] = root;
    distance_[root] = 0;
    queue.emplace(0, rank_[root]);
    while (!queue.empty()) {
      const Entry nearest = queue.top();
      queue.pop();
      const VertexId v = by_rank_[nearest.second];
      if (turn_[v] != 0) continue;
      by_turn_.push_back(v);
      turn_[v] = static_cast<std::uint32_t>(by_turn_.size());
      // Edges may be too short to add to the distance: who had a turn keeps its parent.
      const auto reach = [&](VertexId w) {
        if (turn_[w] != 0) return;
        const double reached = nearest.first + length(v, w);
        if (reached < distance_[w]) {
          distance_[w] = reached;
          parent_[w] = v;
          queue.emplace(reached, rank_[w]);
        } else if (reached == distance_[w] && nearest.second < rank_[parent_[w]]) {
          parent_[w] = v;
        }
      };
      // Each neighbor twice, once if the triangles agree.
      for (const Halfedge corner : mesh_.corners_at(v)) {
        reach(mesh_.from(corner));
        reach(mesh_.to(corner));
      }
    }
  }

  bool is_in_tree(Halfedge halfedge) const {
    const VertexId a = mesh_.from(halfedge);
    const VertexId b = mesh_.to(halfedge);
    return parent_[a] == b || parent_[b] == a;
  }

  // Which of the two paths to the root goes on, until they are one: parents had earlier turns.
  bool is_farther(VertexId a, VertexId b) const { return turn_[a] > turn_[b]; }

  // Each vertex and its child with the most descendants are on one of these paths: from anywhere
  // there are at most log n of them to the root.
  void find_heavy_paths() {
    IdVector<VertexId, std::uint32_t> descendants(mesh_.points.size(), 1);
    IdVector<VertexId, VertexId> heavy(mesh_.points.size());
    for (auto v = by_turn_.rbegin(); v != by_turn_.rend(); ++v) {
      const VertexId parent = parent_[*v];
      if (parent == *v) continue;
      descendants[parent] += descendants[*v];
      VertexId& heaviest = heavy[parent];
      if (heaviest.is_none() || descendants[*v] > descendants[heaviest]) heaviest = *v;
    }
    head_.resize(mesh_.points.size());
    for (const VertexId v : by_turn_) head_[v] = heavy[parent_[v]] == v ? head_[parent_[v]] : v;
  }

  // Where the paths to the root meet. O(log n).
  VertexId meeting_point(VertexId a, VertexId b) const {
    while (head_[a] != head_[b]) {
      VertexId& farther = is_farther(head_[a], head_[b]) ? a : b;
      farther = parent_[head_[farther]];
    }
    return is_farther(a, b) ? b : a;
  }

  Cycle cycle_of(Halfedge halfedge) const {
    const VertexId a = mesh_.from(halfedge);
    const VertexId b = mesh_.to(halfedge);
    const auto [smaller, larger] = std::minmax(rank_[a], rank_[b]);
    const double ends = distance_[a] + distance_[b] + length(a, b);
    return {(ends - 2 * distance_[meeting_point(a, b)]) / scale_, smaller, larger, halfedge};
  }

  const LinkedMesh& mesh_;
  double scale_;
  std::vector<VertexId> by_rank_;
  IdVector<VertexId, std::uint32_t> rank_;
  IdVector<VertexId, double> distance_;
  IdVector<VertexId, std::uint32_t> turn_;  // when the distance was known; 0: it is not
  std::vector<VertexId> by_turn_;
  IdVector<VertexId, VertexId> parent_;
  IdVector<VertexId, VertexId> head_;  // of the heavy path of each vertex
};

}  // namespace

std::vector<NarrowHandle> narrow_handles(const LinkedMesh& mesh, std::size_t max_count) {
  for (const Point& p : mesh.points) {
    if (!is_finite(p)) throw InputError("narrow_handles: a vertex is not finite; repair the mesh");
  }
  const TreeAndCotree trees(mesh);
  const auto cycles = trees.cycles();
  max_count = std::min(max_count, cycles.size() / 2);
  std::vector<NarrowHandle> narrow;
  IdVector<VertexId, std::uint8_t> taken(mesh.points.size(), 0);
  for (const auto& cycle : cycles) {
    if (narrow.size() == max_count) break;
    NarrowHandle handle{trees.path_of(cycle.halfedge), cycle.length};
    constexpr std::size_t most_shared = 3;  // one of so many vertices
    const auto shared = static_cast<std::size_t>(std::count_if(
        handle.path.begin(), handle.path.end(), [&](VertexId v) { return taken[v] != 0; }));
    if (shared * most_shared > handle.path.size()) continue;
    for (const VertexId v : handle.path) taken[v] = 1;
    narrow.push_back(std::move(handle));
  }
  return narrow;
}

}  // namespace cocoon
