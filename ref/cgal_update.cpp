#include "ref/cgal_update.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "ref/cgal_surface.h"

namespace cocoon::ref {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr std::uint32_t no_region = std::numeric_limits<std::uint32_t>::max();

Kernel::Point_3 to_cgal(const Point& p) { return {p.x, p.y, p.z}; }

// An edge of the rim: its ends, and the third corner of its triangle.
struct RimEdge {
  Point from;
  Point to;
  Point apex;
};
using Loop = std::vector<RimEdge>;

// The edges with one triangle, chained; the longest chain.
Loop longest_loop(const std::vector<Point>& cloud, const CgalSurface& surface) {
  std::map<std::pair<PointId, PointId>, std::pair<int, PointId>> edges;  // triangles, apex
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ends = std::minmax(t[k], t[(k + 1) % 3]);
      auto& [count, apex] = edges[{ends.first, ends.second}];
      ++count;
      apex = t[(k + 2) % 3];
    }
  }
  std::map<PointId, std::vector<std::pair<PointId, PointId>>> next;  // neighbor on the rim, apex
  for (const auto& [ends, entry] : edges) {
    if (entry.first != 1) continue;
    next[ends.first].emplace_back(ends.second, entry.second);
    next[ends.second].emplace_back(ends.first, entry.second);
  }
  Loop longest;
  for (auto& [start, unused] : next) {
    Loop loop;
    for (PointId at = start; !next[at].empty();) {
      const auto [to, apex] = next[at].back();
      next[at].pop_back();
      std::erase_if(next[to], [&](const auto& entry) { return entry.first == at; });
      loop.push_back({cloud[at.index()], cloud[to.index()], cloud[apex.index()]});
      at = to;
    }
    if (loop.size() > longest.size()) longest = std::move(loop);
  }
  return longest;
}

class PlainUpdate {
 public:
  PlainUpdate(const TriangleMesh& model, const std::vector<std::vector<Point>>& clouds)
      : model_(model), clouds_(clouds) {}

  CgalUpdate run() {
    timed(0, [&] { detect_boundaries(); });
    timed(1, [&] { find_overlapping_facets(); });
    timed(2, [&] { segment_and_choose(); });
    timed(3, [&] { reconstruct(); });
    for (const auto& [a, b, c] : updated_.triangles) {
      result_.mesh.triangles.push_back({VertexId(a.value), VertexId(b.value), VertexId(c.value)});
    }
    result_.mesh.points = IdVector<VertexId, Point>(std::move(updated_points_));
    return std::move(result_);
  }

 private:
  template <class Body>
  void timed(std::size_t column, Body body) {
    const std::clock_t begin = std::clock();
    body();
    result_.seconds[column] = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }

  void detect_boundaries() {
    for (const auto& cloud : clouds_) {
      const CgalSurface surface =
          cgal_open_surface(cloud, {.rho = 0.3, .tangent_plane_radius = false});
      result_.cloud_delaunay_seconds += surface.delaunay_seconds;
      loops_.push_back(longest_loop(cloud, surface));
      result_.rim_points += loops_.back().size();
    }
  }

  std::vector<TriangleId> neighbors_of(TriangleId t) const {
    std::vector<TriangleId> neighbors;
    const Triangle& triangle = model_.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = facet_of_side_.find({triangle[(k + 1) % 3], triangle[k]});
      if (found != facet_of_side_.end()) neighbors.push_back(found->second);
    }
    return neighbors;
  }

  // The facets on a shortest way over neighboring facets.
  std::vector<TriangleId> way(TriangleId from, TriangleId to) const {
    std::map<TriangleId, TriangleId> came_from = {{from, from}};
    std::vector<TriangleId> queue = {from};
    for (std::size_t i = 0; i < queue.size() && came_from.count(to) == 0; ++i) {
      for (const TriangleId n : neighbors_of(queue[i])) {
        if (came_from.emplace(n, queue[i]).second) queue.push_back(n);
      }
    }
    std::vector<TriangleId> facets = {to};
    while (came_from.count(to) != 0 && facets.back() != from) {
      facets.push_back(came_from[facets.back()]);
    }
    return facets;
  }

  void find_overlapping_facets() {
    Triangles triangles;
    for (const TriangleId t : model_.triangles.ids()) {
      const Triangle& corners = model_.triangles[t];
      triangles.emplace_back(to_cgal(model_.points[corners[0]]), to_cgal(model_.points[corners[1]]),
                             to_cgal(model_.points[corners[2]]));
      for (std::size_t k = 0; k < 3; ++k) {
        facet_of_side_[{corners[k], corners[(k + 1) % 3]}] = t;
      }
    }
    Tree tree(triangles.begin(), triangles.end());
    tree.accelerate_distance_queries();
    for (const Loop& loop : loops_) {
      std::vector<TriangleId> under;
      for (const RimEdge& edge : loop) {
        const auto closest = tree.closest_point_and_primitive(to_cgal(edge.from));
        under.emplace_back(static_cast<std::size_t>(closest.second - triangles.cbegin()));
      }
      overlapping_.insert(under.begin(), under.end());
      facets_of_edge_.emplace_back();
      for (std::size_t i = 0; i < under.size(); ++i) {
        facets_of_edge_.back().push_back(way(under[i], under[(i + 1) % under.size()]));
        border_.insert(facets_of_edge_.back().back().begin(), facets_of_edge_.back().back().end());
      }
    }
    result_.overlapping_facets.assign(overlapping_.begin(), overlapping_.end());
  }

  void grow_regions() {
    region_of_.assign(model_.triangles.size(), no_region);
    for (const TriangleId seed : model_.triangles.ids()) {
      if (border_.count(seed) != 0 || region_of_[seed.index()] != no_region) continue;
      const auto region = static_cast<std::uint32_t>(result_.regions++);
      std::vector<TriangleId> stack = {seed};
      region_of_[seed.index()] = region;
      while (!stack.empty()) {
        const TriangleId t = stack.back();
        stack.pop_back();
        for (const TriangleId n : neighbors_of(t)) {
          if (border_.count(n) != 0 || region_of_[n.index()] != no_region) continue;
          region_of_[n.index()] = region;
          stack.push_back(n);
        }
      }
    }
    regions_of_vertex_.resize(model_.points.size());
    for (const TriangleId t : model_.triangles.ids()) {
      if (region_of_[t.index()] == no_region) continue;
      for (const VertexId v : model_.triangles[t]) {
        regions_of_vertex_[v.index()].insert(region_of_[t.index()]);
      }
    }
  }

  static double wedge(const RimEdge& edge, const Point& p) {
    const Vec3 along = unit(edge.to - edge.from);
    const auto across = [&](const Point& q) {
      const Vec3 v = q - edge.from;
      return v - dot(v, along) * along;
    };
    const Vec3 u = across(edge.apex);
    const Vec3 v = across(p);
    return std::atan2(norm(cross(u, v)), dot(u, v));
  }

  // For each region the angle at the vertex of it nearest to the middle of the edge.
  void add_angles(const RimEdge& edge, const std::vector<TriangleId>& facets,
                  std::map<std::uint32_t, std::pair<double, int>>& sums) const {
    const Point middle = edge.from + 0.5 * (edge.to - edge.from);
    std::map<std::uint32_t, VertexId> nearest;
    for (const TriangleId t : facets) {
      for (const VertexId v : model_.triangles[t]) {
        for (const std::uint32_t region : regions_of_vertex_[v.index()]) {
          const auto [entry, fresh] = nearest.emplace(region, v);
          if (!fresh && squared_distance(model_.points[v], middle) <
                            squared_distance(model_.points[entry->second], middle)) {
            entry->second = v;
          }
        }
      }
    }
    for (const auto& [region, v] : nearest) {
      sums[region].first += wedge(edge, model_.points[v]);
      ++sums[region].second;
    }
  }

  void segment_and_choose() {
    grow_regions();
    for (std::size_t c = 0; c < loops_.size(); ++c) {
      std::map<std::uint32_t, std::pair<double, int>> sums;
      for (std::size_t i = 0; i < loops_[c].size(); ++i) {
        add_angles(loops_[c][i], facets_of_edge_[c][i], sums);
      }
      std::uint32_t chosen = no_region;
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [region, sum] : sums) {
        const double mean = sum.first / sum.second;
        if (10 * static_cast<std::size_t>(sum.second) < loops_[c].size() || mean >= least) continue;
        chosen = region;
        least = mean;
      }
      if (chosen != no_region && sums.size() > 1) replaced_.insert(chosen);
    }
  }

  void reconstruct() {
    std::set<Point> points;
    for (const VertexId v : model_.points.ids()) {
      const std::set<std::uint32_t>& regions = regions_of_vertex_[v.index()];
      if (regions.size() == 1 && replaced_.count(*regions.begin()) != 0) {
        result_.replaced.push_back(v);
      } else {
        points.insert(model_.points[v]);
      }
    }
    for (const auto& cloud : clouds_) points.insert(cloud.begin(), cloud.end());
    updated_points_.assign(points.begin(), points.end());
    updated_ = cgal_tight_surface(updated_points_);
    result_.model_delaunay_seconds = updated_.delaunay_seconds;
  }

  const TriangleMesh& model_;
  const std::vector<std::vector<Point>>& clouds_;
  CgalUpdate result_;
  std::vector<Loop> loops_;
  std::map<std::pair<VertexId, VertexId>, TriangleId> facet_of_side_;
  std::set<TriangleId> overlapping_;
  std::set<TriangleId> border_;
  std::vector<std::vector<std::vector<TriangleId>>> facets_of_edge_;  // by loop and rim edge
  std::vector<std::uint32_t> region_of_;
  std::vector<std::set<std::uint32_t>> regions_of_vertex_;
  std::set<std::uint32_t> replaced_;
  std::vector<Point> updated_points_;
  CgalSurface updated_;
};

}  // namespace

CgalUpdate cgal_update(const TriangleMesh& model, const std::vector<std::vector<Point>>& clouds) {
  return PlainUpdate(model, clouds).run();
}

}  // namespace cocoon::ref
