#include "cocone/facets/facet_removal.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "geom/random/random.h"
#include "tests/cocone/facets/equal_links.h"
#include "tests/cocone/facets/random_facets.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

const Triangulation& cells() {
  static const Triangulation triangulation = delaunay(gallery::bumpy_sphere(3000)).triangulation;
  return triangulation;
}

std::vector<std::uint8_t> random_flags(std::size_t count, double share, Random& random) {
  std::vector<std::uint8_t> flags(count);
  for (std::uint8_t& flag : flags) flag = random.uniform(0, 1) < share ? 1 : 0;
  return flags;
}

TEST(FacetRemoval, TheLastTrianglesMoveIntoTheGaps) {
  const auto moves = moves_into_places({1, 0, 1, 1, 0, 0, 1});
  ASSERT_EQ(moves.size(), 2U);
  EXPECT_EQ(std::pair(moves[0].from, moves[0].to), std::pair(5U, 0U));
  EXPECT_EQ(std::pair(moves[1].from, moves[1].to), std::pair(4U, 2U));
}

// Of rings with many triangles, where several of one ring go, from one triangle to all.
TEST(FacetRemoval, WhatIsPutBackIsAsItWas) {
  Random random(8);
  for (const double share : {0.01, 0.3, 0.8}) {
    const LinkedFacets all = link_facets(cells(), random_facets(cells(), share, 6));
    for (const double removed : {0.0, 0.001, 0.2, 0.9, 1.0}) {
      RemovedFacets gone;
      LinkedFacets left = without(cells(), all, random_flags(all.size(), removed, random), &gone);
      EXPECT_EQ(left.size() + gone.triangles.size(), all.size());
      expect_equal_links(put_back(std::move(left), std::move(gone)), all);
    }
  }
}

// Also of links that do not ascend, since triangles have moved before.
TEST(FacetRemoval, AfterAnotherRemoval) {
  Random random(9);
  LinkedFacets all = link_facets(cells(), random_facets(cells(), 0.5, 7));
  for (int step = 0; step < 5; ++step) {
    all = without(cells(), std::move(all), random_flags(all.size(), 0.1, random));
    RemovedFacets gone;
    LinkedFacets left = without(cells(), all, random_flags(all.size(), 0.3, random), &gone);
    expect_equal_links(put_back(std::move(left), std::move(gone)), all);
  }
}

}  // namespace
}  // namespace cocoon
