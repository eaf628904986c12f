#include "ref/cgal_update.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <utility>

#include "ref/cgal_surface.h"

namespace cocoon::ref {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr std::uint32_t no_region = std::numeric_limits<std::uint32_t>::max();

// Sum and number of the angles to a region.
using AngleSum = std::pair<double, int>;

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
  std::vector<std::array<PointId, 3>> sides;  // smaller end, larger end, apex
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ends = std::minmax(t[k], t[(k + 1) % 3]);
      sides.push_back({ends.first, ends.second, t[(k + 2) % 3]});
    }
  }
  std::sort(sides.begin(), sides.end());
  const auto same_edge = [&](std::size_t i, std::size_t j) {
    return sides[i][0] == sides[j][0] && sides[i][1] == sides[j][1];
  };
  // Of each point the neighbors on the rim, with the apex.
  std::vector<std::vector<std::pair<PointId, PointId>>> next(cloud.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0 && same_edge(i - 1, i)) continue;
    if (i + 1 < sides.size() && same_edge(i, i + 1)) continue;
    const auto [a, b, apex] = sides[i];
    next[a.index()].emplace_back(b, apex);
    next[b.index()].emplace_back(a, apex);
  }
  Loop longest;
  for (std::size_t start = 0; start < next.size(); ++start) {
    Loop loop;
    for (PointId at(start); !next[at.index()].empty();) {
      const auto [to, apex] = next[at.index()].back();
      next[at.index()].pop_back();
      std::erase_if(next[to.index()], [&](const auto& entry) { return entry.first == at; });
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

  // Across each side of each facet the facet with the opposite side, or none.
  void link_facets() {
    std::vector<std::vector<std::pair<VertexId, TriangleId>>> sides_from(model_.points.size());
    for (const TriangleId t : model_.triangles.ids()) {
      const Triangle& corners = model_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        sides_from[corners[k].index()].emplace_back(corners[(k + 1) % 3], t);
      }
    }
    neighbors_.resize(model_.triangles.size());
    for (const TriangleId t : model_.triangles.ids()) {
      const Triangle& corners = model_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        for (const auto& [to, facet] : sides_from[corners[(k + 1) % 3].index()]) {
          if (to == corners[k]) neighbors_[t.index()][k] = facet;
        }
      }
    }
  }

  // The facets on a shortest way over neighboring facets.
  std::vector<TriangleId> way(TriangleId from, TriangleId to) {
    came_from_[from.index()] = from;
    std::vector<TriangleId> queue = {from};
    for (std::size_t i = 0; i < queue.size() && came_from_[to.index()].is_none(); ++i) {
      for (const TriangleId n : neighbors_[queue[i].index()]) {
        if (n.is_none() || !came_from_[n.index()].is_none()) continue;
        came_from_[n.index()] = queue[i];
        queue.push_back(n);
      }
    }
    std::vector<TriangleId> facets = {to};
    while (!came_from_[to.index()].is_none() && facets.back() != from) {
      facets.push_back(came_from_[facets.back().index()]);
    }
    for (const TriangleId t : queue) came_from_[t.index()] = TriangleId();
    return facets;
  }

  void find_overlapping_facets() {
    Triangles triangles;
    for (const TriangleId t : model_.triangles.ids()) {
      const Triangle& corners = model_.triangles[t];
      triangles.emplace_back(to_cgal(model_.points[corners[0]]), to_cgal(model_.points[corners[1]]),
                             to_cgal(model_.points[corners[2]]));
    }
    link_facets();
    Tree tree(triangles.begin(), triangles.end());
    tree.accelerate_distance_queries();
    came_from_.assign(model_.triangles.size(), TriangleId());
    border_.assign(model_.triangles.size(), 0);
    std::vector<TriangleId>& overlapping = result_.overlapping_facets;
    for (const Loop& loop : loops_) {
      std::vector<TriangleId> under;
      for (const RimEdge& edge : loop) {
        const auto closest = tree.closest_point_and_primitive(to_cgal(edge.from));
        under.emplace_back(static_cast<std::size_t>(closest.second - triangles.cbegin()));
      }
      overlapping.insert(overlapping.end(), under.begin(), under.end());
      facets_of_edge_.emplace_back();
      for (std::size_t i = 0; i < under.size(); ++i) {
        facets_of_edge_.back().push_back(way(under[i], under[(i + 1) % under.size()]));
        for (const TriangleId t : facets_of_edge_.back().back()) border_[t.index()] = 1;
      }
    }
    std::sort(overlapping.begin(), overlapping.end());
    overlapping.erase(std::unique(overlapping.begin(), overlapping.end()), overlapping.end());
  }

  void grow_regions() {
    region_of_.assign(model_.triangles.size(), no_region);
    for (const TriangleId seed : model_.triangles.ids()) {
      if (border_[seed.index()] != 0 || region_of_[seed.index()] != no_region) continue;
      const auto region = static_cast<std::uint32_t>(result_.regions++);
      std::vector<TriangleId> stack = {seed};
      region_of_[seed.index()] = region;
      while (!stack.empty()) {
        const TriangleId t = stack.back();
        stack.pop_back();
        for (const TriangleId n : neighbors_[t.index()]) {
          if (n.is_none() || border_[n.index()] != 0 || region_of_[n.index()] != no_region)
            continue;
          region_of_[n.index()] = region;
          stack.push_back(n);
        }
      }
    }
    regions_of_vertex_.resize(model_.points.size());
    for (const TriangleId t : model_.triangles.ids()) {
      const std::uint32_t region = region_of_[t.index()];
      if (region == no_region) continue;
      for (const VertexId v : model_.triangles[t]) {
        std::vector<std::uint32_t>& regions = regions_of_vertex_[v.index()];
        if (std::find(regions.begin(), regions.end(), region) == regions.end()) {
          regions.push_back(region);
        }
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
                  std::vector<AngleSum>& sums) const {
    const Point middle = edge.from + 0.5 * (edge.to - edge.from);
    std::vector<std::pair<std::uint32_t, VertexId>> nearest;  // of few regions
    for (const TriangleId t : facets) {
      for (const VertexId v : model_.triangles[t]) {
        for (const std::uint32_t region : regions_of_vertex_[v.index()]) {
          const auto entry = std::find_if(nearest.begin(), nearest.end(),
                                          [&](const auto& e) { return e.first == region; });
          if (entry == nearest.end()) {
            nearest.emplace_back(region, v);
          } else if (squared_distance(model_.points[v], middle) <
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
    replaced_.assign(result_.regions, 0);
    for (std::size_t c = 0; c < loops_.size(); ++c) {
      std::vector<AngleSum> sums(result_.regions);
      for (std::size_t i = 0; i < loops_[c].size(); ++i) {
        add_angles(loops_[c][i], facets_of_edge_[c][i], sums);
      }
      std::size_t chosen = result_.regions;
      double least = std::numeric_limits<double>::infinity();
      std::size_t seen = 0;
      for (std::size_t region = 0; region < sums.size(); ++region) {
        const auto [sum, count] = sums[region];
        if (count == 0) continue;
        ++seen;
        const double mean = sum / count;
        if (10 * static_cast<std::size_t>(count) < loops_[c].size() || mean >= least) continue;
        chosen = region;
        least = mean;
      }
      if (chosen != result_.regions && seen > 1) replaced_[chosen] = 1;
    }
  }

  void reconstruct() {
    std::vector<Point>& points = updated_points_;
    for (const VertexId v : model_.points.ids()) {
      const std::vector<std::uint32_t>& regions = regions_of_vertex_[v.index()];
      if (regions.size() == 1 && replaced_[regions.front()] != 0) {
        result_.replaced.push_back(v);
      } else {
        points.push_back(model_.points[v]);
      }
    }
    for (const auto& cloud : clouds_) points.insert(points.end(), cloud.begin(), cloud.end());
    std::stable_sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    updated_ = cgal_tight_surface(points);
    result_.model_delaunay_seconds = updated_.delaunay_seconds;
  }

  const TriangleMesh& model_;
  const std::vector<std::vector<Point>>& clouds_;
  CgalUpdate result_;
  std::vector<Loop> loops_;
  std::vector<std::array<TriangleId, 3>> neighbors_;  // of each facet, across side k, k + 1
  std::vector<TriangleId> came_from_;                 // none but during a search
  std::vector<char> border_;                          // by facet
  std::vector<std::vector<std::vector<TriangleId>>> facets_of_edge_;  // by loop and rim edge
  std::vector<std::uint32_t> region_of_;
  std::vector<std::vector<std::uint32_t>> regions_of_vertex_;
  std::vector<char> replaced_;  // by region
  std::vector<Point> updated_points_;
  CgalSurface updated_;
};

}  // namespace

CgalUpdate cgal_update(const TriangleMesh& model, const std::vector<std::vector<Point>>& clouds) {
  return PlainUpdate(model, clouds).run();
}

}  // namespace cocoon::ref
