#include "cocone/surface_doubts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include "geom/box.h"
#include "geom/mesh_adjacency.h"
#include "geom/nearest_point.h"

namespace cocoon {
namespace {

// Reorders the values.
double median(std::span<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The points in lexicographic order, equal ones once.
std::vector<Point> distinct(Points points) {
  std::vector<Point> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

// Sets of ids 0 .. count - 1 that `join` has put together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::size_t> parent_;
};

void keep_worst(std::vector<DoubtfulSpot>& spots, std::size_t count,
                const std::function<bool(const DoubtfulSpot&, const DoubtfulSpot&)>& worse) {
  std::sort(spots.begin(), spots.end(), [&](const DoubtfulSpot& a, const DoubtfulSpot& b) {
    if (worse(a, b) || worse(b, a)) return worse(a, b);
    return a.at < b.at;
  });
  if (spots.size() > count) spots.resize(count);
}

bool larger(const DoubtfulSpot& a, const DoubtfulSpot& b) { return a.size > b.size; }
bool more(const DoubtfulSpot& a, const DoubtfulSpot& b) { return a.count > b.count; }

class Doubts {
 public:
  Doubts(const ReconstructResult& result, Points points, const SurfaceDoubtOptions& options)
      : result_(result),
        mesh_(result.mesh),
        points_(points),
        options_(options),
        adjacency_(mesh_adjacency(result.mesh)) {}

  SurfaceDoubts run() {
    measure_edges();
    measure_roughness();
    find_sparse_samples();
    find_fragments();
    find_unused_points();
    find_contacts();
    return std::move(doubts_);
  }

 private:
  void measure_edges() {
    // The lengths of the edges at vertex v: lengths[begin[v], begin[v + 1]).
    std::vector<std::size_t> begin(mesh_.points.size() + 2, 0);
    for (const auto& [a, b] : adjacency_.edges) {
      ++begin[a.index() + 2];
      ++begin[b.index() + 2];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<double> lengths(2 * adjacency_.edges.size());
    for (const auto& [a, b] : adjacency_.edges) {
      const double length = distance(mesh_.points[a], mesh_.points[b]);
      lengths[begin[a.index() + 1]++] = length;
      lengths[begin[b.index() + 1]++] = length;
    }
    longest_ = IdVector<VertexId, double>(mesh_.points.size(), 0);
    sparse_ = IdVector<VertexId, std::uint8_t>(mesh_.points.size(), 0);
    for (const VertexId v : mesh_.points.ids()) {
      find_gap(
          v, std::span(lengths).subspan(begin[v.index()], begin[v.index() + 1] - begin[v.index()]));
    }
    doubts_.spacing = median(lengths);  // each edge is there twice
  }

  void find_gap(VertexId v, std::span<double> lengths) {
    if (!lengths.empty()) longest_[v] = *std::max_element(lengths.begin(), lengths.end());
    const bool gap = longest_[v] > options_.gap_ratio * median(lengths);
    const bool boundary =
        v.index() < result_.boundary_sample.size() && result_.boundary_sample[v] != 0;
    doubts_.gap_samples += gap && !boundary ? 1U : 0U;
    doubts_.boundary_samples += boundary ? 1U : 0U;
    sparse_[v] = gap || boundary ? 1 : 0;
  }

  void measure_roughness() {
    IdVector<VertexId, Vec3> normal(mesh_.points.size());
    IdVector<VertexId, Vec3> arms(mesh_.points.size());
    IdVector<VertexId, double> lengths(mesh_.points.size(), 0);
    std::vector<double> deviations;
    for (const auto& [a, b, c] : mesh_.triangles) {
      const Vec3 n = cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]);
      for (const VertexId v : {a, b, c}) normal[v] = normal[v] + n;
    }
    for (const auto& [a, b] : adjacency_.edges) {
      const Vec3 arm = mesh_.points[b] - mesh_.points[a];
      arms[a] = arms[a] + arm;
      arms[b] = arms[b] - arm;
      lengths[a] += norm(arm);
      lengths[b] += norm(arm);
    }
    for (const VertexId v : mesh_.points.ids()) {
      if (lengths[v] > 0)
        deviations.push_back(std::abs(dot(arms[v], unit(normal[v]))) / lengths[v]);
    }
    doubts_.roughness = median(deviations);
  }

  void find_sparse_samples() {
    Groups groups(mesh_.points.size());
    for (const auto& [a, b] : adjacency_.edges) {
      if (sparse_[a] != 0 && sparse_[b] != 0) groups.join(a.index(), b.index());
    }
    std::vector<DoubtfulSpot> spot_of(mesh_.points.size());
    for (const VertexId v : mesh_.points.ids()) {
      if (sparse_[v] == 0) continue;
      DoubtfulSpot& spot = spot_of[groups.find(v.index())];
      const Point& p = mesh_.points[v];
      if (spot.count == 0 || longest_[v] > spot.size || (longest_[v] == spot.size && p < spot.at)) {
        spot.at = p;
        spot.size = longest_[v];
      }
      ++spot.count;
    }
    for (const DoubtfulSpot& spot : spot_of) {
      if (spot.count > 0) doubts_.sparse.push_back(spot);
    }
    keep_worst(doubts_.sparse, options_.max_spots, larger);
  }

  void find_fragments() {
    Groups groups(mesh_.triangles.size());
    for (const EdgeId e : adjacency_.edges.ids()) {
      const auto sides = adjacency_.halfedges_at(e);
      for (const HalfedgeId side : sides) {
        groups.join(triangle_of(side).index(), triangle_of(sides.front()).index());
      }
    }
    std::vector<Box> boxes(mesh_.triangles.size());
    std::vector<std::size_t> counts(mesh_.triangles.size(), 0);
    for (const TriangleId t : mesh_.triangles.ids()) {
      const std::size_t group = groups.find(t.index());
      for (const VertexId v : mesh_.triangles[t]) boxes[group].include(mesh_.points[v]);
      ++counts[group];
    }
    const std::size_t largest =
        counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
    for (std::size_t g = 0; g < counts.size(); ++g) {
      const bool is_dust =
          static_cast<double>(counts[g]) < options_.fragment_share * static_cast<double>(largest);
      if (counts[g] == 0 || !is_dust) continue;
      ++doubts_.fragments;
      doubts_.dust.push_back({boxes[g].center(), counts[g], norm(boxes[g].size())});
    }
    keep_worst(doubts_.dust, options_.max_spots, more);
  }

  void find_unused_points() {
    doubts_.unused_points = result_.unused_points;
    if (result_.unused_points == 0 || mesh_.points.empty()) return;
    const std::vector<Point> all = distinct(points_);
    const std::vector<Point> used = distinct(mesh_.points.span());
    std::vector<Point> unused;
    std::set_difference(all.begin(), all.end(), used.begin(), used.end(),
                        std::back_inserter(unused));
    const NearestPointTree tree(used);
    for (const Point& p : unused) {
      doubts_.unused.push_back({p, 1, std::sqrt(tree.nearest(p).squared_distance)});
    }
    keep_worst(doubts_.unused, options_.max_spots, larger);
  }

  void find_contacts() {
    doubts_.certificate = mesh_check(mesh_);
    const MeshReport& report = doubts_.certificate;
    doubts_.bad_edges = report.overfull_edges;
    doubts_.pinched_vertices = report.pinched_vertices;
    for (const auto& [a, b] : report.examples.overfull_edges) {
      doubts_.contacts.push_back({std::min(mesh_.points[a], mesh_.points[b]), 1, 0});
    }
    for (const VertexId v : report.examples.pinched_vertices) {
      doubts_.contacts.push_back({mesh_.points[v], 1, 0});
    }
    keep_worst(doubts_.contacts, options_.max_spots, larger);
  }

  const ReconstructResult& result_;
  const TriangleMesh& mesh_;
  Points points_;
  const SurfaceDoubtOptions& options_;
  MeshAdjacency adjacency_;
  IdVector<VertexId, double> longest_;       // edge at each vertex
  IdVector<VertexId, std::uint8_t> sparse_;  // 1 = boundary sample, or at a gap
  SurfaceDoubts doubts_;
};

}  // namespace

SurfaceDoubts surface_doubts(const ReconstructResult& result, Points points,
                             const SurfaceDoubtOptions& options) {
  return Doubts(result, points, options).run();
}

}  // namespace cocoon
