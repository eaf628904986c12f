#include "cocone/poles.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "cocone/double_cone.h"
#include "cocone/shared_maxima.h"
#include "delaunay/vertex_stars.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 16384;
constexpr std::size_t vertices_per_chunk = 8192;
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

// A Voronoi vertex relative to a sample. Slivers have centers so far that squares overflow; then
// two of them are compared in larger units.
struct Arm {
  Vec3 vector;
  double squared_length;

  explicit Arm(const Vec3& v) : vector(v), squared_length(squared_norm(v)) {}
  bool is_far() const { return !(squared_length <= std::numeric_limits<double>::max()); }
  Vec3 safe() const { return is_far() ? shrink * vector : vector; }

  // Longer, or as long and lexicographically smaller.
  bool precedes(const Arm& other) const {
    if (squared_length != other.squared_length) return squared_length > other.squared_length;
    if (is_far()) {
      const double here = squared_norm(safe());
      const double there = squared_norm(other.safe());
      if (here != there) return here > there;
    }
    return vector < other.vector;
  }
};

Arm arm_of(const Triangulation& triangulation, const Dual& dual, CellId c, VertexId p) {
  return Arm(dual.centers[c] - triangulation.point(p));
}

// The farthest Voronoi vertex of every sample, by its cell: a maximum that many threads raise at
// once. One word each, the length rounded in the upper half, so that most questions end there; what
// rounds alike is compared exactly.
class FarthestCells {
 public:
  FarthestCells(const Triangulation& triangulation, const Dual& dual)
      : triangulation_(triangulation), dual_(dual), words_(triangulation.num_vertices()) {}

  void offer(CellId c, VertexId p, const Arm& arm) {
    std::atomic<std::uint64_t>& word = words_[p.index()];
    const std::uint64_t offered = pack(c, arm.squared_length);
    std::uint64_t known = word.load(std::memory_order_relaxed);
    while (known >> 32 <= offered >> 32) {
      if (known >> 32 == offered >> 32 &&
          !arm.precedes(arm_of(triangulation_, dual_, unpack(known), p))) {
        return;
      }
      if (word.compare_exchange_weak(known, offered, std::memory_order_relaxed)) return;
    }
  }

  Arm farthest(VertexId p) const {
    return arm_of(triangulation_, dual_, unpack(words_[p.index()].load(std::memory_order_relaxed)),
                  p);
  }

 private:
  // Not below 0, so floats are ordered as their bits; + 1: above a word without a cell.
  static std::uint64_t pack(CellId c, double squared_length) {
    const auto rounded = std::bit_cast<std::uint32_t>(static_cast<float>(squared_length));
    return std::uint64_t{rounded + 1} << 32 | c.value;
  }
  static CellId unpack(std::uint64_t word) { return CellId(static_cast<std::uint32_t>(word)); }

  const Triangulation& triangulation_;
  const Dual& dual_;
  std::vector<std::atomic<std::uint64_t>> words_;
};

// Calls visit(cell, vertex, arm) for the corners of the finite cells begin .. end.
template <class Visit>
void for_each_arm(const Triangulation& triangulation, const Dual& dual, std::size_t begin,
                  std::size_t end, Visit visit) {
  for (CellId c(begin); c.index() < end; ++c) {
    for (const VertexId p : triangulation.cell(c).vertices) {
      visit(c, p, arm_of(triangulation, dual, c, p));
    }
  }
}

// n_p of all samples.
void find_normals(const Triangulation& triangulation, const Dual& dual, Poles& poles,
                  const Execution& execution) {
  FarthestCells poles_of(triangulation, dual);
  parallel_chunks(execution, triangulation.num_finite_cells(), cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for_each_arm(
                        triangulation, dual, begin, end,
                        [&](CellId c, VertexId p, const Arm& arm) { poles_of.offer(c, p, arm); });
                  });
  const VertexStars hull = hull_stars(triangulation);
  std::atomic<std::size_t> on_hull = 0;
  std::atomic<std::size_t> degenerate = 0;
  parallel_chunks(execution, triangulation.num_vertices(), vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    std::vector<Vec3> directions;
                    std::size_t on_hull_here = 0;
                    std::size_t degenerate_here = 0;
                    for (VertexId p(begin); p.index() < end; ++p) {
                      if (hull.star(p).empty()) {
                        poles.normals[p] = unit(poles_of.farthest(p).safe());
                        continue;
                      }
                      directions.clear();
                      for (const CellId c : hull.star(p)) directions.push_back(dual.centers[c]);
                      const HullNormal sum = hull_normal(directions);
                      poles.normals[p] = sum.normal;
                      poles.degenerate[p] = sum.degenerate;
                      ++on_hull_here;
                      degenerate_here += sum.degenerate;
                    }
                    on_hull += on_hull_here;
                    degenerate += degenerate_here;
                  });
  poles.hull_vertices = on_hull;
  poles.degenerate_vertices = degenerate;
}

// h_p of all samples, from their normals.
void find_heights(const Triangulation& triangulation, const Dual& dual, Poles& poles,
                  const Execution& execution) {
  const std::size_t count = triangulation.num_vertices();
  const auto for_each_lower_arm = [&](auto visit) {
    parallel_chunks(execution, triangulation.num_finite_cells(), cells_per_chunk,
                    [&](std::size_t begin, std::size_t end) {
                      for_each_arm(triangulation, dual, begin, end,
                                   [&](CellId, VertexId p, const Arm& arm) {
                                     if (dot(arm.safe(), poles.normals[p]) < 0) visit(p, arm);
                                   });
                    });
  };
  SharedMaxima squared(count);
  std::atomic<bool> any_far = false;
  for_each_lower_arm([&](VertexId p, const Arm& arm) {
    squared.raise(p, arm.squared_length);
    if (arm.is_far()) any_far = true;
  });
  SharedMaxima far(any_far ? count : 0);
  if (any_far) {
    for_each_lower_arm([&](VertexId p, const Arm& arm) {
      if (arm.is_far()) far.raise(p, norm(arm.safe()) / shrink);
    });
  }
  for (const VertexId p : poles.heights.ids()) {
    const double height = std::sqrt(squared[p]);
    poles.heights[p] = std::isfinite(height) ? height : far[p];
  }
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

Poles compute_poles(const Triangulation& triangulation, const Dual& dual,
                    const Execution& execution) {
  report_progress(execution, "compute_poles", 0);
  const std::size_t count = triangulation.num_vertices();
  Poles poles{IdVector<VertexId, Vec3>(count), IdVector<VertexId, double>(count),
              VertexSet(count, 0), 0, 0};
  find_normals(triangulation, dual, poles, execution);
  report_progress(execution, "compute_poles", 0.5);
  find_heights(triangulation, dual, poles, execution);
  report_progress(execution, "compute_poles", 1);
  return poles;
}

}  // namespace cocoon
