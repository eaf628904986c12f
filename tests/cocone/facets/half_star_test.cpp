#include "cocone/facets/half_star.h"

#include <gtest/gtest.h>
#include <set>

#include "cocone/candidate_triangles.h"
#include "delaunay/circulate.h"
#include "geom/arrays/disjoint_sets.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

// Against joining all pairs of cells of the star that have a facet at the vertex in common, on
// candidates that divide stars into any number of parts.
TEST(HalfStar, FindsThePartOfTheStarBesideItsFirstCell) {
  const Stages s(shapes::noisy_sphere(600, 0.05, 3));
  const Triangulation& t = s.triangulation;
  const FacetSet surface = candidate_triangles(t, s.cocones, s.labels().boundary);
  HalfStar half(t, surface);
  std::set<std::size_t> numbers_of_parts;
  for (const VertexId v : t.vertices()) {
    DisjointSets parts(t.num_cells());
    std::size_t count = s.stars.star(v).size();
    for_each_facet_around_vertex(t, s.stars, v, [&](FacetId f) {
      if (surface.contains(f)) return;
      count -= parts.join(cell_of(f).value, cell_of(t.mirror(f)).value) ? 1U : 0U;
    });
    numbers_of_parts.insert(count);
    for (const CellId first : s.stars.star(v)) {
      const std::span<const CellId> found = half.flood(v, first);
      EXPECT_EQ(found.front(), first);
      std::size_t expected = 0;
      for (const CellId c : s.stars.star(v)) {
        const bool beside = parts.root(c.value) == parts.root(first.value);
        expected += beside ? 1U : 0U;
        ASSERT_EQ(half.contains(c), beside);
      }
      ASSERT_EQ(found.size(), expected);
    }
  }
  EXPECT_TRUE(numbers_of_parts.count(1) == 1 && numbers_of_parts.count(2) == 1);
  EXPECT_GT(numbers_of_parts.size(), 2U);
}

}  // namespace
}  // namespace cocoon
