#include "cocone/linked_facets.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"
#include "geom/random.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

FacetSet random_facets(const Triangulation& triangulation, double share, std::uint64_t seed) {
  Random random(seed);
  FacetSet facets(triangulation.num_cells());
  for (const CellId c : triangulation.finite_cells()) {
    for (int i = 0; i < 4; ++i) {
      if (random.uniform(0, 1) < share) facets.insert(triangulation, facet_id(c, i));
    }
  }
  return facets;
}

VertexId smallest(const Triangle& triangle) {
  return *std::min_element(triangle.begin(), triangle.end());
}

// Enough cells for several chunks.
class LinkedFacetsTest : public testing::Test {
 protected:
  const Triangulation triangulation = delaunay(gallery::bumpy_sphere(20000)).triangulation;
};

TEST_F(LinkedFacetsTest, AreThoseOfTheSetBySmallestVertexThenFacet) {
  for (const double share : {0.0, 0.002, 0.3}) {
    const FacetSet set = random_facets(triangulation, share, 3);
    const LinkedFacets linked = link_facets(triangulation, set);
    std::vector<FacetId> expected;
    set.for_each(triangulation, [&](FacetId f) { expected.push_back(f); });
    std::stable_sort(expected.begin(), expected.end(), [&](FacetId a, FacetId b) {
      return smallest(triangulation.facet_vertices(a)) < smallest(triangulation.facet_vertices(b));
    });
    ASSERT_EQ(linked.facets, expected);
    for (std::size_t t = 0; t < linked.size(); ++t) {
      EXPECT_EQ(linked.mirrors[t], triangulation.mirror(expected[t]));
      EXPECT_EQ(linked.corners[t], triangulation.facet_vertices(expected[t]));
    }
  }
}

TEST_F(LinkedFacetsTest, DoNotDependOnThreads) {
  const FacetSet set = random_facets(triangulation, 0.3, 5);
  const LinkedFacets one = link_facets(triangulation, set);
  for (const int threads : {2, 3, 7}) {
    const LinkedFacets several = link_facets(triangulation, set, {.threads = threads});
    EXPECT_EQ(several.facets, one.facets);
    EXPECT_EQ(several.mirrors, one.mirrors);
    EXPECT_EQ(several.corners, one.corners);
    EXPECT_EQ(several.links, one.links);
  }
}

}  // namespace
}  // namespace cocoon
