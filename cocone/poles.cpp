#include "cocone/poles.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>
#include <vector>

#include "cocone/double_cone.h"

namespace cocoon {
namespace {

constexpr std::size_t vertices_per_chunk = 4096;
// A shorter sum of k unit normals than this times k means that they cancel (spec: thresholds from
// 1e-8 to 0.3 gave the same labels on eleven test sets up to one sample).
constexpr double cancelling_sum = 0.1;

Vec3 principal_direction(std::span<const Vec3> directions) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Vec3& d : directions) {
    const Eigen::Vector3d v(d.x, d.y, d.z);
    sum += v * v.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  const Vec3 direction = unit({axis.x(), axis.y(), axis.z()});
  return direction < Vec3{} ? -direction : direction;
}

// The Voronoi vertices of one Voronoi cell relative to its sample, times a power of two.
struct VoronoiCell {
  const Triangulation& triangulation;
  const Dual& dual;
  std::span<const CellId> star;
  Point sample;
  double scale = 1;

  bool is_finite(CellId c) const { return !triangulation.is_infinite(c); }
  Vec3 relative(CellId c) const { return scale * (dual.centers[c] - sample); }
};

struct FarthestVertex {
  double squared_distance = -1;
  Vec3 position;  // relative
};

FarthestVertex farthest_voronoi_vertex(const VoronoiCell& cell) {
  double farthest = -1;
  Vec3 pole;
  for (const CellId c : cell.star) {
    const Vec3 x = cell.relative(c);
    const double squared = squared_norm(x);
    if (squared > farthest || (squared == farthest && x < pole)) {
      farthest = squared;
      pole = x;
    }
  }
  return {farthest, pole};
}

double squared_height(const VoronoiCell& cell, const Vec3& normal) {
  double farthest = 0;
  for (const CellId c : cell.star) {
    if (!cell.is_finite(c)) break;  // stars are sorted: infinite cells come last
    const Vec3 x = cell.relative(c);
    if (dot(x, normal) < 0) farthest = std::max(farthest, squared_norm(x));
  }
  return farthest;
}

double largest_coordinate(const VoronoiCell& cell) {
  double largest = 0;
  for (const CellId c : cell.star) {
    const Vec3 x = cell.relative(c);
    largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  }
  return largest;
}

struct PoleOfVertex {
  Vec3 normal;
  double height = 0;
  bool on_hull = false;
  bool degenerate = false;
};

PoleOfVertex pole_of(VoronoiCell cell, std::vector<Vec3>& hull_directions) {
  FarthestVertex farthest = farthest_voronoi_vertex(cell);
  // A sliver's circumcenter may be so far that squares overflow: then measure in larger units.
  if (farthest.squared_distance >= largest_safe_length * largest_safe_length &&
      largest_coordinate(cell) > largest_safe_length) {
    cell.scale = shrink;
    farthest = farthest_voronoi_vertex(cell);
  }
  PoleOfVertex pole;
  pole.on_hull = !cell.is_finite(cell.star.back());
  if (pole.on_hull) {
    hull_directions.clear();
    for (auto c = cell.star.rbegin(); c != cell.star.rend() && !cell.is_finite(*c); ++c) {
      hull_directions.push_back(cell.dual.centers[*c]);
    }
    const HullNormal hull = hull_normal(hull_directions);
    pole.normal = hull.normal;
    pole.degenerate = hull.degenerate;
  } else {
    pole.normal = unit(farthest.position);
  }
  pole.height = std::sqrt(squared_height(cell, pole.normal)) / cell.scale;
  return pole;
}

}  // namespace

HullNormal hull_normal(std::span<Vec3> directions) {
  std::sort(directions.begin(), directions.end());
  Vec3 sum;
  for (const Vec3& d : directions) sum = sum + d;
  if (norm(sum) < cancelling_sum * static_cast<double>(directions.size())) {
    return {principal_direction(directions), true};
  }
  return {unit(sum), false};
}

Poles compute_poles(const Triangulation& triangulation, const Dual& dual, const VertexStars& stars,
                    const Execution& execution) {
  report_progress(execution, "compute_poles", 0);
  const std::size_t count = triangulation.num_vertices();
  Poles poles{IdVector<VertexId, Vec3>(count), IdVector<VertexId, double>(count),
              VertexSet(count, 0), 0, 0};
  std::atomic<std::size_t> hull_vertices = 0;
  std::atomic<std::size_t> degenerate_vertices = 0;
  parallel_chunks(execution, count, vertices_per_chunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Vec3> hull_directions;
    std::size_t on_hull = 0;
    std::size_t degenerate = 0;
    for (VertexId p(begin); p.index() < end; ++p) {
      // Centers lie here and there in memory: ask for those of the next stars.
      constexpr std::size_t ahead = 2;
      if (p.index() + ahead < end) {
        for (const CellId c : stars.star(VertexId(p.index() + ahead))) {
          __builtin_prefetch(&dual.centers[c]);
        }
      }
      const PoleOfVertex pole =
          pole_of({triangulation, dual, stars.star(p), triangulation.point(p)}, hull_directions);
      poles.normals[p] = pole.normal;
      poles.heights[p] = pole.height;
      poles.degenerate[p] = pole.degenerate;
      on_hull += pole.on_hull;
      degenerate += pole.degenerate;
    }
    hull_vertices += on_hull;
    degenerate_vertices += degenerate;
  });
  poles.hull_vertices = hull_vertices;
  poles.degenerate_vertices = degenerate_vertices;
  report_progress(execution, "compute_poles", 1);
  return poles;
}

}  // namespace cocoon
