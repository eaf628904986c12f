#include "cocone/poles.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "cocone/cell_arms.h"
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
  FarthestCells(const Triangulation& triangulation, const Dual& dual, const Execution& execution)
      : triangulation_(triangulation),
        dual_(dual),
        words_(triangulation.num_vertices()),
        alone_(thread_count(execution) == 1) {}

  // Would the arm of this length at corner p be the farthest known, or nearly so?
  bool may_win(VertexId p, double squared_length) const {
    return words_[p.index()].load(std::memory_order_relaxed) >> 32 <= rounded(squared_length);
  }

  // Of the arm of cell c at its corner p.
  void offer(CellId c, VertexId p, double squared_length) {
    std::atomic<std::uint64_t>& word = words_[p.index()];
    const std::uint64_t upper = rounded(squared_length);
    const std::uint64_t offered = upper << 32 | c.value;
    std::uint64_t known = word.load(std::memory_order_relaxed);
    while (known >> 32 <= upper) {
      if (known >> 32 == upper && !arm_of(triangulation_, dual_, c, p)
                                       .precedes(arm_of(triangulation_, dual_, unpack(known), p))) {
        return;
      }
      if (alone_) return word.store(offered, std::memory_order_relaxed);  // see shared_maxima.h
      if (word.compare_exchange_weak(known, offered, std::memory_order_relaxed)) return;
    }
  }

  Arm farthest(VertexId p) const {
    return arm_of(triangulation_, dual_, unpack(words_[p.index()].load(std::memory_order_relaxed)),
                  p);
  }

 private:
  // Not below 0, so floats are ordered as their bits; + 1: above a word without a cell.
  static std::uint64_t rounded(double squared_length) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(static_cast<float>(squared_length))} + 1;
  }
  static CellId unpack(std::uint64_t word) { return CellId(static_cast<std::uint32_t>(word)); }

  const Triangulation& triangulation_;
  const Dual& dual_;
  std::vector<std::atomic<std::uint64_t>> words_;
  bool alone_;
};

// Calls visit(first, count) for runs of the finite cells, of at most max_arm_cells.
template <class Visit>
void for_each_run(const Triangulation& triangulation, const Execution& execution, Visit visit) {
  static_assert(cells_per_chunk % max_arm_cells == 0);
  parallel_chunks(execution, triangulation.num_finite_cells(), cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t c = begin; c < end; c += max_arm_cells) {
                      visit(CellId(c), std::min(max_arm_cells, end - c));
                    }
                  });
}

// n_p of all samples.
void find_normals(const Triangulation& triangulation, const Dual& dual, Poles& poles,
                  const Execution& execution) {
  FarthestCells poles_of(triangulation, dual, execution);
  for_each_run(triangulation, execution, [&](CellId first, std::size_t count) {
    SquaredArms arms;
    squared_arms(triangulation, dual, first, count, arms);
    for (std::size_t k = 0; k < count; ++k) {
      const CellId c(first.index() + k);
      const Cell& cell = triangulation.cell(c);
      // One branch for four corners: which of them win cannot be foreseen.
      unsigned winners = 0;
      for (unsigned j = 0; j < 4; ++j) {
        const bool wins = poles_of.may_win(cell.vertices[j], arms.lengths[4 * k + j]);
        winners |= static_cast<unsigned>(wins) << j;
      }
      for (; winners != 0; winners &= winners - 1) {
        const auto j = static_cast<unsigned>(std::countr_zero(winners));
        poles_of.offer(c, cell.vertices[j], arms.lengths[4 * k + j]);
      }
    }
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

// h_p of all samples, from their normals, and the sides of finite cells to the double cones of
// sides->cosine if they are wanted.
void find_heights(const Triangulation& triangulation, const Dual& dual, Poles& poles,
                  ConeSides* sides, const Execution& execution) {
  const std::size_t count = triangulation.num_vertices();
  const double squared_cosine = sides != nullptr ? sides->cosine * sides->cosine : 0;
  // Calls visit(cell, squared lengths, which) for arms below the tangent planes; those of extreme
  // lengths are left to visit_unsafe(c, p).
  const auto for_each_lower_arm = [&](auto visit, auto visit_unsafe) {
    for_each_run(triangulation, execution, [&](CellId first, std::size_t size) {
      ArmSides arms;
      arm_sides(triangulation, dual, poles.normals, squared_cosine, first, size, arms);
      if (sides != nullptr) {
        take_cone_sides(triangulation, dual, poles.normals, arms, first, size, *sides);
      }
      for (std::size_t k = 0; k < size; ++k) {
        const CellId c(first.index() + k);
        const Cell& cell = triangulation.cell(c);
        visit(cell, &arms.squared.lengths[4 * k], arms.negative[k] & ~arms.unsafe[k] & 15U);
        for (unsigned rest = arms.unsafe[k]; rest != 0; rest &= rest - 1) {
          visit_unsafe(c, cell.vertices[static_cast<std::size_t>(std::countr_zero(rest))]);
        }
      }
    });
  };
  const auto is_lower = [&](VertexId p, const Arm& arm) {
    return dot(arm.safe(), poles.normals[p]) < 0;
  };
  SharedMaxima squared(count, execution);
  std::atomic<bool> any_far = false;
  const auto raise_all = [&](const Cell& cell, const double* lengths, unsigned which) {
    // One branch for four corners, as above.
    unsigned higher = 0;
    for (unsigned j = 0; j < 4; ++j) {
      higher |= static_cast<unsigned>(squared[cell.vertices[j]] < lengths[j]) << j;
    }
    for (higher &= which; higher != 0; higher &= higher - 1) {
      const auto j = static_cast<unsigned>(std::countr_zero(higher));
      squared.raise(cell.vertices[j], lengths[j]);
    }
  };
  for_each_lower_arm(raise_all, [&](CellId c, VertexId p) {
    const Arm arm = arm_of(triangulation, dual, c, p);
    if (!is_lower(p, arm)) return;
    squared.raise(p, arm.squared_length);
    if (arm.is_far()) any_far = true;
  });
  SharedMaxima far(any_far ? count : 0, execution);
  if (any_far) {
    for_each_lower_arm([](const Cell&, const double*, unsigned) {},
                       [&](CellId c, VertexId p) {
                         const Arm arm = arm_of(triangulation, dual, c, p);
                         if (arm.is_far() && is_lower(p, arm)) {
                           far.raise(p, norm(arm.safe()) / shrink);
                         }
                       });
  }
  for (const VertexId p : poles.heights.ids()) {
    const double height = std::sqrt(squared[p]);
    poles.heights[p] = std::isfinite(height) ? height : far[p];
  }
}

Poles find_poles(const Triangulation& triangulation, const Dual& dual, ConeSides* sides,
                 const Execution& execution) {
  report_progress(execution, "compute_poles", 0);
  const std::size_t count = triangulation.num_vertices();
  Poles poles{IdVector<VertexId, Vec3>(count), IdVector<VertexId, double>(count),
              VertexSet(count, 0), 0, 0};
  find_normals(triangulation, dual, poles, execution);
  report_progress(execution, "compute_poles", 0.5);
  find_heights(triangulation, dual, poles, sides, execution);
  report_progress(execution, "compute_poles", 1);
  return poles;
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
  return find_poles(triangulation, dual, nullptr, execution);
}

Poles compute_poles(const Triangulation& triangulation, const Dual& dual, double cosine,
                    ConeSides& sides, const Execution& execution) {
  sides = {cosine, IdVector<CellId, CornerSides>(triangulation.num_cells())};
  Poles poles = find_poles(triangulation, dual, &sides, execution);
  for (const CellId c : triangulation.infinite_cells()) {
    sides.of_cells[c] = cone_sides_of_cell(triangulation, dual, poles.normals, cosine * cosine, c);
  }
  return poles;
}

}  // namespace cocoon
