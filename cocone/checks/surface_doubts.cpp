#include "cocone/checks/surface_doubts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/median.h"
#include "geom/box.h"
#include "geom/mesh/linked_mesh.h"
#include "geom/mesh/narrow_handles.h"
#include "geom/messages/require_number.h"
#include "geom/messages/require_size.h"
#include "geom/search/nearest_point.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

constexpr std::size_t vertices_per_chunk = 2048;

// Those with the largest of a member, ties by place.
template <class Member>
void keep_first(std::vector<DoubtfulSpot>& spots, std::size_t count, Member member) {
  const auto end = spots.begin() + static_cast<std::ptrdiff_t>(std::min(count, spots.size()));
  std::partial_sort(spots.begin(), end, spots.end(),
                    [&](const DoubtfulSpot& a, const DoubtfulSpot& b) {
                      return a.*member != b.*member ? a.*member > b.*member : a.at < b.at;
                    });
  spots.erase(end, spots.end());
}

class Doubts {
 public:
  Doubts(const ReconstructResult& result, Points points, const SurfaceDoubtOptions& options,
         const Execution& execution)
      : result_(result),
        points_(points),
        options_(options),
        execution_(execution),
        mesh_(link_mesh(result.mesh, execution)) {}

  SurfaceDoubts run() {
    measure_edges();
    find_sparse_samples();
    find_contradicted_samples();
    // All examples: the first ones by id say nothing of the surface.
    constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
    doubts_.certificate = mesh_check(mesh_, {.max_examples = all}, execution_);
    find_fragments();
    find_unused_points();
    find_contacts();
    ask_stages();
    find_handles();
    return std::move(doubts_);
  }

 private:
  // What is measured at a range of vertices.
  struct Measured {
    std::vector<double> lengths;     // of the edges, told at one of their ends
    std::vector<double> deviations;  // from the mean of the neighbors, see roughness
    std::size_t boundary = 0;
    std::size_t gaps = 0;
  };

  void measure_edges() {
    const std::size_t count = mesh_.points.size();
    longest_ = IdVector<VertexId, double>(count, 0);
    sparse_ = IdVector<VertexId, std::uint8_t>(count, 0);
    for (const VertexId v : mesh_.points.ids()) {
      const VertexId given = mesh_.vertex_of[v];
      if (given.index() < result_.boundary_sample.size())
        sparse_[v] = result_.boundary_sample[given];
    }
    irregular_ = IdVector<VertexId, std::uint8_t>(count, 0);
    for (const Halfedge halfedge : mesh_.irregular) {
      irregular_[mesh_.from(halfedge)] = irregular_[mesh_.to(halfedge)] = 1;
    }
    std::vector<Measured> parts((count + vertices_per_chunk - 1) / vertices_per_chunk);
    parallel_chunks(execution_, count, vertices_per_chunk, [&](std::size_t begin, std::size_t end) {
      std::vector<double> lengths;
      Measured& part = parts[begin / vertices_per_chunk];
      part.lengths.reserve(4 * (end - begin));  // three edges for each vertex, as a rule
      part.deviations.reserve(end - begin);
      for (VertexId v(begin); v.index() < end; ++v) {
        measure_at(v, lengths, part);
      }
    });
    std::vector<double> lengths;
    std::vector<double> deviations;
    lengths.reserve(mesh_.links.size() / 2 + mesh_.irregular.size());
    deviations.reserve(count);
    for (const Measured& part : parts) {
      lengths.insert(lengths.end(), part.lengths.begin(), part.lengths.end());
      deviations.insert(deviations.end(), part.deviations.begin(), part.deviations.end());
      doubts_.boundary_samples += part.boundary;
      doubts_.gap_samples += part.gaps;
    }
    doubts_.spacing = quantile_in_place(lengths, 0.5);
    doubts_.roughness = quantile_in_place(deviations, 0.5);
  }

  void measure_at(VertexId v, std::vector<double>& lengths, Measured& measured) {
    lengths.clear();
    Vec3 normal;
    Vec3 arms;
    double sum = 0;
    const auto measure_edge_to = [&](VertexId other) {
      const Vec3 arm = mesh_.points[other] - mesh_.points[v];
      arms = arms + arm;
      lengths.push_back(norm(arm));
      sum += lengths.back();
      if (v < other) measured.lengths.push_back(lengths.back());
    };
    for (const Halfedge corner : mesh_.corners_at(v)) {
      const VertexId from = mesh_.from(corner);
      const VertexId to = mesh_.to(corner);
      normal =
          normal + cross(mesh_.points[from] - mesh_.points[v], mesh_.points[to] - mesh_.points[v]);
      if (irregular_[v] == 0) {
        measure_edge_to(from);  // of the two triangles at that edge this one begins with it
        continue;
      }
      const auto at = static_cast<Halfedge>(corner_of_halfedge(corner));
      // The spoke to one end lies opposite the other.
      const Halfedge first = corner - at;
      if (mesh_.is_last(first + static_cast<Halfedge>(previous_corner(at)))) measure_edge_to(from);
      if (mesh_.is_last(first + static_cast<Halfedge>(next_corner(at)))) measure_edge_to(to);
    }
    if (sum > 0) measured.deviations.push_back(std::abs(dot(arms, unit(normal))) / sum);
    find_gap(v, lengths, measured);
  }

  void find_gap(VertexId v, std::span<double> lengths, Measured& measured) {
    bool gap = false;
    if (!lengths.empty()) {
      const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
      longest_[v] = *longest;
      // The median is not below the shortest.
      gap = *longest > options_.gap_ratio * *shortest &&
            longest_[v] > options_.gap_ratio * quantile_in_place(lengths, 0.5);
    }
    const bool boundary = sparse_[v] != 0;
    measured.gaps += gap && !boundary ? 1U : 0U;
    measured.boundary += boundary ? 1U : 0U;
    sparse_[v] = gap || boundary ? 1 : 0;
  }

  void find_sparse_samples() {
    doubts_.sparse = groups_of(sparse_);
    keep_largest(doubts_.sparse, options_.max_spots);
  }

  void find_contradicted_samples() {
    const std::vector<PointId>& points = result_.contradicted;
    if (points.empty()) return;
    IdVector<VertexId, std::uint8_t> contradicted(mesh_.points.size(), 0);
    for (const VertexId v : mesh_.points.ids()) {
      const PointId p = result_.point_of_vertex[mesh_.vertex_of[v]];
      contradicted[v] = std::binary_search(points.begin(), points.end(), p) ? 1 : 0;
    }
    doubts_.contradicted = groups_of(contradicted);
    keep_first(doubts_.contradicted, options_.max_spots, &DoubtfulSpot::count);
  }

  // Vertices that have a flag, as far as edges join them, each at the one with the longest edge.
  std::vector<DoubtfulSpot> groups_of(const IdVector<VertexId, std::uint8_t>& flag) const {
    DisjointSets groups(mesh_.points.size());
    for (Halfedge halfedge = 0; halfedge < mesh_.links.size(); ++halfedge) {
      const VertexId a = mesh_.from(halfedge);
      const VertexId b = mesh_.to(halfedge);
      if (flag[a] != 0 && flag[b] != 0) groups.join(a.value, b.value);
    }
    std::vector<DoubtfulSpot> spots;
    IdVector<VertexId, std::uint32_t> spot_of(mesh_.points.size(), 0);  // place + 1
    for (const VertexId v : mesh_.points.ids()) {
      if (flag[v] == 0) continue;
      std::uint32_t& place = spot_of[VertexId(std::size_t{groups.root(v.value)})];
      if (place == 0) {
        spots.push_back({mesh_.points[v], 0, longest_[v]});
        place = static_cast<std::uint32_t>(spots.size());
      }
      DoubtfulSpot& spot = spots[place - 1];
      const Point& p = mesh_.points[v];
      if (longest_[v] > spot.size || (longest_[v] == spot.size && p < spot.at)) {
        spot.at = p;
        spot.size = longest_[v];
      }
      ++spot.count;
    }
    return spots;
  }

  void find_fragments() {
    std::size_t largest = 0;
    for (const MeshComponent& component : doubts_.certificate.component_reports) {
      largest = std::max(largest, component.triangles);
    }
    const auto is_dust = [&](const MeshComponent& component) {
      return static_cast<double>(component.triangles) <
             options_.fragment_share * static_cast<double>(largest);
    };
    IdVector<TriangleId, std::uint8_t> seeds(result_.mesh.triangles.size(), 0);
    for (const MeshComponent& component : doubts_.certificate.component_reports) {
      if (!is_dust(component)) continue;
      seeds[component.first_triangle] = 1;
      ++doubts_.fragments;
    }
    if (doubts_.fragments == 0) return;
    std::vector<std::uint8_t> seen(mesh_.triangles.size(), 0);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (seeds[mesh_.triangle_of[t]] != 0) doubts_.dust.push_back(fragment_of(t, seen));
    }
    keep_first(doubts_.dust, options_.max_spots, &DoubtfulSpot::count);
  }

  // The component of a triangle.
  DoubtfulSpot fragment_of(std::uint32_t first, std::vector<std::uint8_t>& seen) const {
    Box box;
    std::vector<std::uint32_t> found{first};
    seen[first] = 1;
    for (std::size_t next = 0; next < found.size(); ++next) {
      for (const VertexId v : mesh_.triangles[found[next]]) box.include(mesh_.points[v]);
      for (Halfedge halfedge = 3 * found[next]; halfedge < 3 * found[next] + 3; ++halfedge) {
        for (Halfedge other = mesh_.links[halfedge]; other != halfedge;
             other = mesh_.links[other]) {
          if (seen[triangle_of_halfedge(other)] != 0) continue;
          seen[triangle_of_halfedge(other)] = 1;
          found.push_back(triangle_of_halfedge(other));
        }
      }
    }
    return {box.center(), found.size(), norm(box.size())};
  }

  void find_unused_points() {
    doubts_.unused_points = result_.unused_points;
    if (result_.unused_points == 0 || mesh_.points.empty()) return;
    const std::vector<Point> unused = unused_points();
    // A tree of a million vertices takes as long to build as some 150 looks at each of them.
    constexpr std::size_t few = 128;
    std::optional<NearestPointTree> tree;
    if (unused.size() > few) tree.emplace(mesh_.points.span(), execution_);
    for (const Point& p : unused) {
      const double squared = tree ? tree->nearest(p).squared_distance : nearest_vertex(p);
      doubts_.unused.push_back({p, 1, std::sqrt(squared)});
    }
    keep_largest(doubts_.unused, options_.max_spots);
  }

  // Different ones, in lexicographic order.
  std::vector<Point> unused_points() const {
    std::vector<std::uint8_t> has_vertex(points_.size(), 0);
    for (const PointId p : result_.point_of_vertex) has_vertex[p.index()] = 1;
    std::vector<Point> unused;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (has_vertex[i] == 0) unused.push_back(points_[i]);
    }
    std::sort(unused.begin(), unused.end());
    unused.erase(std::unique(unused.begin(), unused.end()), unused.end());
    if (result_.duplicates == 0) return unused;
    // A vertex stands for the first of equal points; the others are not unused.
    std::vector<Point> used(mesh_.points.begin(), mesh_.points.end());
    std::sort(used.begin(), used.end());
    std::erase_if(unused,
                  [&](const Point& p) { return std::binary_search(used.begin(), used.end(), p); });
    return unused;
  }

  double nearest_vertex(const Point& p) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& q : mesh_.points) nearest = std::min(nearest, squared_distance(p, q));
    return nearest;
  }

  void find_contacts() {
    const MeshReport& report = doubts_.certificate;
    doubts_.bad_edges = report.overfull_edges;
    doubts_.pinched_vertices = report.pinched_vertices;
    for (const auto& [a, b] : report.examples.overfull_edges) {
      doubts_.contacts.push_back({std::min(result_.mesh.points[a], result_.mesh.points[b]), 1, 0});
    }
    for (const VertexId v : report.examples.pinched_vertices) {
      doubts_.contacts.push_back({result_.mesh.points[v], 1, 0});
    }
    const auto before = [](const DoubtfulSpot& a, const DoubtfulSpot& b) { return a.at < b.at; };
    std::sort(doubts_.contacts.begin(), doubts_.contacts.end(), before);
    const auto repeated = std::unique(doubts_.contacts.begin(), doubts_.contacts.end());
    doubts_.contacts.erase(repeated, doubts_.contacts.end());
    keep_largest(doubts_.contacts, options_.max_spots);
  }

  void ask_stages() {
    const ReconstructCounters& counters = result_.counters;
    doubts_.samples = result_.vertices;
    // Those at the rim of an open surface have no umbrella, and no peel or clean-up has guessed.
    if (doubts_.certificate.watertight) {
      doubts_.unsurrounded_samples =
          result_.vertices - std::min(counters.umbrellas, result_.vertices);
    }
    doubts_.conflicts = counters.marking_conflicts;
  }

  // Where all samples are surrounded handles are what the samples say.
  void find_handles() {
    const bool any = doubts_.certificate.genus.value_or(0) > 0 && doubts_.unsurrounded_samples > 0;
    if (!any || !options_.place_handles) return;
    for (const NarrowHandle& handle : narrow_handles(mesh_, options_.max_spots)) {
      doubts_.handles.push_back(
          {mesh_.points[handle.path.front()], handle.path.size(), handle.length});
    }
  }

  const ReconstructResult& result_;
  Points points_;
  const SurfaceDoubtOptions& options_;
  const Execution& execution_;
  LinkedMesh mesh_;                             // ids of vertices below are its own
  IdVector<VertexId, double> longest_;          // edge at each vertex
  IdVector<VertexId, std::uint8_t> irregular_;  // 1 = an edge there is
  IdVector<VertexId, std::uint8_t> sparse_;     // 1 = boundary sample, or at a gap
  SurfaceDoubts doubts_;
};

// On a copy that has been multiplied by `scale`, a power of two: squares of lengths are in the
// range of double there.
SurfaceDoubts scaled_doubts(ReconstructResult result, Points points, double scale,
                            const SurfaceDoubtOptions& options, const Execution& execution) {
  const std::vector<Point> copy = scaled(points, scale);
  result.mesh = scaled(std::move(result.mesh), scale);
  SurfaceDoubts doubts = Doubts(result, copy, options, execution).run();
  doubts.spacing /= scale;
  for (std::vector<DoubtfulSpot>* spots :
       {&doubts.sparse, &doubts.dust, &doubts.unused, &doubts.contacts, &doubts.handles,
        &doubts.contradicted}) {
    for (DoubtfulSpot& spot : *spots) {
      spot.at = (1 / scale) * spot.at;
      spot.size /= scale;
    }
  }
  return doubts;
}

}  // namespace

void keep_largest(std::vector<DoubtfulSpot>& spots, std::size_t count) {
  keep_first(spots, count, &DoubtfulSpot::size);
}

SurfaceDoubts surface_doubts(const ReconstructResult& result, Points points,
                             const SurfaceDoubtOptions& options, const Execution& execution) {
  require_amounts("surface_doubts", {{"gap_ratio", options.gap_ratio}});
  require_shares("surface_doubts", {{"fragment_share", options.fragment_share}});
  for (const PointId p : result.point_of_vertex) {
    require_index("surface_doubts", "point", p.index(), points.size());
  }
  const double scale = working_scale(points, execution);
  if (scale != 1) return scaled_doubts(result, points, scale, options, execution);
  return Doubts(result, points, options, execution).run();
}

}  // namespace cocoon
