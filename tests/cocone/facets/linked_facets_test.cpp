#include "cocone/facets/linked_facets.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/facets/facet_removal.h"
#include "delaunay/delaunay.h"
#include "geom/random/random.h"
#include "tests/cocone/facets/equal_links.h"
#include "tests/cocone/facets/random_facets.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

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
    ASSERT_TRUE(
        std::equal(linked.facets.begin(), linked.facets.end(), expected.begin(), expected.end()));
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
    expect_equal_links(several, one);
  }
}

TEST_F(LinkedFacetsTest, AreTheSameFromTheListOfFacets) {
  const FacetSet set = random_facets(triangulation, 0.3, 5);
  std::vector<FacetId> facets;
  std::vector<Triangle> corners;
  set.for_each(triangulation, [&](FacetId f) {
    facets.push_back(f);
    corners.push_back(triangulation.facet_vertices(f));
  });
  const LinkedFacets scanned = link_facets(triangulation, set);
  for (const int threads : {1, 2}) {
    const LinkedFacets listed =
        link_facets(triangulation, {set, facets, corners}, {.threads = threads});
    expect_equal_links(listed, scanned);
  }
}

// The edges, by all triangles at them, that are not two triangles at most this steep.
std::vector<Halfedge> expected_steep(const LinkedFacets& triangles, double largest_cosine) {
  std::vector<Halfedge> steep;
  for (Halfedge halfedge = 0; halfedge < triangles.links.size(); ++halfedge) {
    std::vector<Halfedge> ring;
    for_each_at_edge(triangles.links, halfedge, [&](Halfedge other) { ring.push_back(other); });
    if (*std::min_element(ring.begin(), ring.end()) != halfedge) continue;
    const bool flat =
        ring.size() == 2 && dihedral_cosine(triangles, ring[0], ring[1]) <= largest_cosine;
    if (!flat) steep.push_back(halfedge);
  }
  return steep;
}

TEST_F(LinkedFacetsTest, SteepEdgesAreThoseThatAreNotTwoFlatTriangles) {
  Random random(8);
  for (const double share : {0.0, 0.05, 0.3}) {
    LinkedFacets linked = link_facets(triangulation, random_facets(triangulation, share, 6));
    for (const double removed_share : {0.0, 0.001, 0.2, 0.9}) {
      std::vector<std::uint8_t> removed(linked.size());
      for (std::uint8_t& flag : removed) flag = random.uniform(0, 1) < removed_share ? 1 : 0;
      linked = without(triangulation, std::move(linked), removed);
      EXPECT_EQ(linked.steep, expected_steep(linked, LinkedFacets::steep_cosine));
      for (const double cosine : {-0.5, 0.0, 0.5}) {
        EXPECT_EQ(steep_edges(linked, cosine), expected_steep(linked, cosine));
      }
    }
  }
}

}  // namespace
}  // namespace cocoon
