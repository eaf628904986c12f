#include "delaunay/voronoi/cell_blocks.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <span>
#include <vector>

#include "ref/cgal_delaunay.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

TEST(CellBlocks, FiniteOnesOfSomeCells) {
  for (const std::vector<Point>& points :
       {gallery::uniform_cube(500, 7), gallery::ulp_pairs(200), gallery::even_sphere(800)}) {
    const Triangulation triangulation = ref::cgal_delaunay(points);
    const Dual dual = voronoi_dual(triangulation);
    // Every third cell, from the last one on: infinite ones first.
    std::vector<CellId> some;
    for (std::size_t c = triangulation.num_cells(); c >= 3; c -= 3) some.push_back(CellId(c - 1));
    std::vector<CellId> met;
    for_each_block(triangulation, some, [&](std::span<const CellId> cells, CellBlock& block) {
      for (std::size_t k = 0; k < cells.size(); ++k) {
        met.push_back(cells[k]);
        EXPECT_EQ(block.center(k), dual.centers[cells[k]]);
      }
    });
    std::erase_if(some, [&](CellId c) { return triangulation.is_infinite(c); });
    EXPECT_EQ(met, some);
  }
}

// Runs of all lengths, up to the last finite cell, with a dual and with a lean one.
TEST(CellBlocks, RunsOfCells) {
  for (const std::vector<Point>& points :
       {gallery::uniform_cube(300, 7), gallery::integer_grid(4), gallery::ulp_pairs(60)}) {
    const Triangulation triangulation = ref::cgal_delaunay(points);
    const Dual dual = voronoi_dual(triangulation);
    const std::size_t finite = triangulation.num_finite_cells();
    std::vector<HardCenters> hard(1);
    const IdVector<VertexId, double> numbers(triangulation.num_vertices());
    std::size_t count = 1;
    for (std::size_t first = 0; first < finite; first += count) {
      count = std::min(first == 0 ? 1 : count % max_block_cells + 1, finite - first);
      CellBlock noted, lean, full;
      load_new_run(triangulation, CellId(first), count, noted, hard[0]);
      const Dual known_so_far = lean_dual(triangulation, hard);
      load_run(triangulation, known_so_far, CellId(first), count, lean,
               {triangulation.points().raw().data(), numbers.raw().data()});
      load_run(triangulation, dual, CellId(first), count, full, {nullptr, numbers.raw().data()});
      for (const CellBlock* block : {&noted, &lean, &full}) {
        ASSERT_EQ(block->size, count);
        for (std::size_t k = 0; k < count; ++k) {
          const CellId c(first + k);
          EXPECT_EQ(block->center(k), dual.centers[c]);
          for (std::size_t j = 0; j < 4; ++j) {
            const Point& p = triangulation.point(triangulation.cell(c).vertices[j]);
            const BatchOfPoints& corners = block->batches[k / circumcenter_batch_size].corners[j];
            const std::size_t lane = k % circumcenter_batch_size;
            EXPECT_EQ((Point{corners[0][lane], corners[1][lane], corners[2][lane]}), p);
          }
        }
      }
    }
    EXPECT_EQ(lean_dual(triangulation, hard).not_in_doubles, dual.not_in_doubles);
  }
}

}  // namespace
}  // namespace cocoon
