#include "cocone/poles.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "cocone/inputs/stage_inputs.h"
#include "cocone/samples/cell_arms.h"
#include "cocone/samples/double_cone.h"
#include "cocone/samples/farthest_cells.h"
#include "cocone/samples/hull_normal.h"
#include "cocone/samples/vertex_maxima.h"
#include "delaunay/vertex_stars.h"
#include "geom/parallel/parallel_fold.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 4096;
constexpr std::size_t vertices_per_chunk = 2048;

// Calls visit(first, count) for runs of the cells begin ... end - 1, of at most max_block_cells.
template <class Visit>
void for_each_run(std::size_t begin, std::size_t end, Visit visit) {
  for (std::size_t c = begin; c < end; c += max_block_cells) {
    visit(CellId(c), std::min(max_block_cells, end - c));
  }
}

// From the arms of all finite cells, which load(first, count, block, soon) puts into blocks.
template <class Load>
FarthestCells find_farthest(const Triangulation& triangulation, const Dual& dual,
                            const Execution& execution, Load load) {
  const auto offer_cells = [&](FarthestCells& farthest, std::size_t begin, std::size_t end) {
    const ReadSoon soon{nullptr, farthest.words()};
    CellBlock block;
    ArmWords words;
    for_each_run(begin, end, [&](CellId first, std::size_t count) {
      load(first, count, block, soon);
      arm_words(first, block, words);
      farthest.offer(first, block, words);
    });
  };
  return parallel_fold(
      execution, triangulation.num_finite_cells(), cells_per_chunk,
      [&] { return FarthestCells(triangulation, dual); }, offer_cells,
      [&](FarthestCells& all, const FarthestCells& others) { all.join(others, execution); });
}

// n_p of all samples.
void find_normals(const Triangulation& triangulation, const Dual& dual, FarthestCells farthest,
                  Poles& poles, const Execution& execution) {
  const VertexStars hull = hull_stars(triangulation, execution);
  std::atomic<std::size_t> on_hull = 0;
  std::atomic<std::size_t> degenerate = 0;
  const auto from_hull = [&](VertexId p, std::vector<Vec3>& directions) {
    directions.clear();
    for (const CellId c : hull.star(p)) directions.push_back(center_of(triangulation, dual, c));
    const HullNormal sum = hull_normal(directions);
    poles.normals[p] = sum.normal;
    poles.degenerate[p] = sum.degenerate;
    return sum.degenerate;
  };
  parallel_chunks(execution, triangulation.num_vertices(), vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    std::vector<Vec3> directions;
                    std::size_t on_hull_here = 0;
                    std::size_t degenerate_here = 0;
                    CellBlock block;
                    std::array<VertexId, max_block_cells> inner;
                    std::array<CellId, max_block_cells> cells;
                    for (VertexId p(begin); p.index() < end;) {
                      std::size_t count = 0;
                      for (; count < max_block_cells && p.index() < end; ++p) {
                        if (hull.star(p).empty()) {
                          inner[count] = p;
                          cells[count++] = farthest.farthest(p);
                        } else {
                          ++on_hull_here;
                          degenerate_here += from_hull(p, directions);
                        }
                      }
                      if (count == 0) continue;
                      load_cells(triangulation, dual, std::span(cells).first(count), block);
                      for (std::size_t k = 0; k < count; ++k) {
                        const Arm arm(block.center(k) - triangulation.point(inner[k]));
                        poles.normals[inner[k]] = unit(arm.safe());
                      }
                    }
                    on_hull += on_hull_here;
                    degenerate += degenerate_here;
                  });
  poles.hull_vertices = on_hull;
  poles.degenerate_vertices = degenerate;
}

// Maxima over lower arms that are found cell by cell: take(maxima, begin, end).
template <class Take>
VertexMaxima find_maxima(const Triangulation& triangulation, const Execution& execution,
                         Take take) {
  return parallel_fold(
      execution, triangulation.num_finite_cells(), cells_per_chunk,
      [&] { return VertexMaxima(triangulation.num_vertices()); }, take,
      [&](VertexMaxima& all, const VertexMaxima& others) { all.join(others, execution); });
}

// The arms of finite cells below the tangent planes of their corners.
class LowerArms {
 public:
  // `sides`: gets the sides of the cells, too, if not null.
  LowerArms(const Triangulation& triangulation, const Dual& dual,
            const IdVector<VertexId, Vec3>& normals, ConeSides* sides)
      : triangulation_(triangulation), dual_(dual), normals_(normals), sides_(sides) {}

  // Calls visit(cells, lower arms) for blocks of the cells begin ... end - 1; corners with arms of
  // extreme lengths that are lower are left to visit_unsafe(arm, p). `maxima`: will be looked at.
  template <class Visit, class VisitUnsafe>
  void for_each(std::size_t begin, std::size_t end, const VertexMaxima& maxima, Visit visit,
                VisitUnsafe visit_unsafe) const {
    const double squared_cosine = sides_ != nullptr ? sides_->cosine * sides_->cosine : 0;
    const ReadSoon soon{normals_.raw().data(), maxima.values()};
    CellBlock block;
    ArmSides arms;
    for_each_run(begin, end, [&](CellId first, std::size_t size) {
      load_run(triangulation_, dual_, first, size, block, soon);
      arm_sides(triangulation_, normals_, squared_cosine, first, block, arms);
      if (sides_ != nullptr) {
        take_cone_sides(triangulation_, dual_, normals_, arms, first, size, *sides_);
      }
      const auto cells = triangulation_.cell_records().span().subspan(first.index(), size);
      visit(cells, arms.lower);
      for (std::size_t k = 0; k < size; ++k) {
        for (unsigned rest = arms.unsafe[k]; rest != 0; rest &= rest - 1) {
          const VertexId p = cells[k].vertices[static_cast<std::size_t>(std::countr_zero(rest))];
          const Arm arm = arm_of(triangulation_, dual_, CellId(first.index() + k), p);
          if (dot(arm.safe(), normals_[p]) < 0) visit_unsafe(arm, p);
        }
      }
    });
  }

 private:
  const Triangulation& triangulation_;
  const Dual& dual_;
  const IdVector<VertexId, Vec3>& normals_;
  ConeSides* sides_;
};

// h_p of all samples, from their normals, and the sides of finite cells to the double cones of
// sides->cosine if they are wanted.
void find_heights(const Triangulation& triangulation, const Dual& dual, Poles& poles,
                  ConeSides* sides, const Execution& execution) {
  const LowerArms arms(triangulation, dual, poles.normals, sides);
  std::atomic<bool> any_far = false;
  const auto take_squares = [&](VertexMaxima& squared, std::size_t begin, std::size_t end) {
    arms.for_each(
        begin, end, squared,
        [&](std::span<const Cell> cells, const SquaredArms& lower) {
          squared.raise_corners(cells,
                                [&](std::size_t k, std::size_t j) { return lower.at(k, j); });
        },
        [&](const Arm& arm, VertexId p) {
          squared.raise(p, arm.squared_length);
          if (arm.is_far()) any_far = true;
        });
  };
  poles.heights = find_maxima(triangulation, execution, take_squares).take();
  parallel_chunks(execution, poles.heights.size(), vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (VertexId p(begin); p.index() < end; ++p) {
                      poles.heights[p] = std::sqrt(poles.heights[p]);
                    }
                  });
  if (!any_far) return;
  const auto take_far = [&](VertexMaxima& far, std::size_t begin, std::size_t end) {
    arms.for_each(
        begin, end, far, [](std::span<const Cell>, const SquaredArms&) {},
        [&](const Arm& arm, VertexId p) {
          if (arm.is_far()) far.raise(p, norm(arm.safe()) / shrink);
        });
  };
  const VertexMaxima far = find_maxima(triangulation, execution, take_far);
  for (const VertexId p : poles.heights.ids()) {
    if (!std::isfinite(poles.heights[p])) poles.heights[p] = far[p];
  }
}

// All that follows the search for the farthest Voronoi vertices.
Poles finish_poles(const Triangulation& triangulation, const Dual& dual, FarthestCells farthest,
                   ConeSides* sides, const Execution& execution) {
  const std::size_t count = triangulation.num_vertices();
  Poles poles{IdVector<VertexId, Vec3>(count), {}, VertexSet(count, 0), 0, 0};
  find_normals(triangulation, dual, std::move(farthest), poles, execution);
  report_progress(execution, "compute_poles", 0.5);
  if (sides != nullptr) sides->of_cells.resize(triangulation.num_cells());
  find_heights(triangulation, dual, poles, sides, execution);
  if (sides != nullptr) take_ray_sides(triangulation, dual, poles.normals, *sides, execution);
  report_progress(execution, "compute_poles", 1);
  return poles;
}

// Of a triangulation whose dual is known.
Poles find_poles(const Triangulation& triangulation, const Dual& dual, ConeSides* sides,
                 const Execution& execution) {
  report_progress(execution, "compute_poles", 0);
  FarthestCells farthest =
      find_farthest(triangulation, dual, execution,
                    [&](CellId first, std::size_t count, CellBlock& block, const ReadSoon& soon) {
                      load_run(triangulation, dual, first, count, block, soon);
                    });
  return finish_poles(triangulation, dual, std::move(farthest), sides, execution);
}

}  // namespace

Poles compute_poles(const Triangulation& triangulation, const Dual& dual,
                    const Execution& execution) {
  require_dual("compute_poles", triangulation, dual);
  return find_poles(triangulation, dual, nullptr, execution);
}

PolesAndSides poles_and_sides(const Triangulation& triangulation, const Dual& dual, double cosine,
                              const Execution& execution) {
  require_options("poles_and_sides", CoconeOptions{cosine});
  require_dual("poles_and_sides", triangulation, dual);
  PolesAndSides both{{}, {cosine, {}}};
  both.poles = find_poles(triangulation, dual, &both.sides, execution);
  return both;
}

DualAndPoles dual_and_poles(const Triangulation& triangulation, double cosine,
                            const Execution& execution) {
  require_options("dual_and_poles", CoconeOptions{cosine});
  report_progress(execution, "compute_poles", 0);
  DualAndPoles all{{}, {}, {cosine, {}}};
  std::vector<HardCenters> hard(triangulation.num_finite_cells() / cells_per_chunk + 1);
  FarthestCells farthest =
      find_farthest(triangulation, all.dual, execution,
                    [&](CellId first, std::size_t count, CellBlock& block, const ReadSoon& soon) {
                      load_new_run(triangulation, first, count, block,
                                   hard[first.index() / cells_per_chunk], soon);
                    });
  all.dual = lean_dual(triangulation, hard, execution);
  all.poles = finish_poles(triangulation, all.dual, std::move(farthest), &all.sides, execution);
  return all;
}

}  // namespace cocoon
