#include "tests/cocone/renumbered.h"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/noise_filter.h"
#include "cocone/reconstruct.h"
#include "delaunay/check_delaunay.h"
#include "delaunay/delaunay.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

TEST(RenumberedTriangulations, AreTriangulations) {
  const std::vector<Point> points = gallery::uniform_cube(200, 1);
  const Triangulation triangulation = delaunay(points).triangulation;
  const Triangulation other = renumbered(triangulation, 1);
  EXPECT_TRUE(check_delaunay(other).ok());
  EXPECT_FALSE(other.points() == triangulation.points());
}

TEST(RenumberedTriangulations, GiveTheSameSurface) {
  CleanUpCounters all;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const std::vector<Point> points = shapes::noisy_sphere(700, 0.1, seed);
    const ReconstructResult expected = reconstruct_tight(points);
    const Triangulation triangulation = delaunay(points).triangulation;
    for (const std::uint64_t numbers : {1U, 2U}) {
      const ReconstructResult other = reconstruct_tight(renumbered(triangulation, numbers), points);
      EXPECT_EQ(other.mesh, expected.mesh) << seed;
      EXPECT_EQ(other.contradicted, expected.contradicted) << seed;
    }
    all.moves += expected.counters.clean_up.moves;
    all.compound_moves += expected.counters.clean_up.compound_moves;
  }
  EXPECT_GT(all.moves, 500U);
  EXPECT_GT(all.compound_moves, 10U);
}

// Where lengths, circles and energies are equal, coordinates decide.
TEST(RenumberedTriangulations, GiveTheSameSurfaceOfLattices) {
  CleanUpCounters all;
  for (int side = 4; side <= 7; ++side) {
    const std::vector<Point> points = gallery::integer_grid(side);
    for (const double handle_cost : {32.0, 0.0}) {
      ReconstructOptions options;
      options.clean_up.handle_cost = handle_cost;
      const ReconstructResult expected = reconstruct_tight(points, options);
      const Triangulation triangulation = delaunay(points).triangulation;
      for (const std::uint64_t numbers : {1U, 2U, 3U}) {
        const ReconstructResult other =
            reconstruct_tight(renumbered(triangulation, numbers), points, options);
        EXPECT_EQ(other.mesh, expected.mesh) << side << ", " << handle_cost;
        EXPECT_EQ(other.counters.clean_up.moves, expected.counters.clean_up.moves);
      }
      all.moves += expected.counters.clean_up.moves;
    }
  }
  EXPECT_GT(all.moves, 100U);
}

// A lattice whose pitch is no power of two: radii that are equal but for rounding.
TEST(RenumberedTriangulations, HaveTheSameSkin) {
  const std::vector<Point> points = gallery::scaled(gallery::integer_grid(6), 0.1);
  const Triangulation triangulation = delaunay(points).triangulation;
  NoiseOptions options;
  options.large_ratio = std::sqrt(0.75);
  const auto skin = [&](const Triangulation& t) {
    const IdVector<VertexId, double> spacing = sample_spacing(t, vertex_stars(t), 3);
    return outer_skin(t, voronoi_dual(t), spacing, options);
  };
  const OuterSkin expected = skin(triangulation);
  EXPECT_GT(expected.large_cells, 0U);
  for (const std::uint64_t numbers : {1U, 2U, 3U}) {
    const OuterSkin other = skin(renumbered(triangulation, numbers));
    EXPECT_EQ(other.large_cells, expected.large_cells);
    EXPECT_EQ(other.outer_cells, expected.outer_cells);
  }
}

}  // namespace
}  // namespace cocoon
