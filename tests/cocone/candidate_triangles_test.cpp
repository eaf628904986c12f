#include "cocone/candidate_triangles.h"

#include <gtest/gtest.h>

#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

TEST(CandidateTriangles, TheListIsThatOfTheSet) {
  const Stages s(shapes::noisy_sphere(2000, 0.02, 1));
  const BoundarySamples labels = s.labels();
  ASSERT_GT(labels.count, 0U);
  const CandidateTriangles listed =
      list_candidate_triangles(s.triangulation, s.cocones, labels.boundary);
  EXPECT_EQ(listed.set, candidate_triangles(s.triangulation, s.cocones, labels.boundary));
  std::size_t k = 0;
  listed.set.for_each(s.triangulation, [&](FacetId f) {
    ASSERT_LT(k, listed.facets.size());
    EXPECT_EQ(listed.facets[k], f);
    EXPECT_EQ(listed.corners[k], s.triangulation.facet_vertices(f));
    ++k;
  });
  EXPECT_EQ(k, listed.facets.size());
  EXPECT_EQ(k, listed.corners.size());
}

TEST(CandidateTriangles, InteriorCornersVoteAndOneMust) {
  const Stages s(shapes::noisy_sphere(1000, 0.02, 2));
  const BoundarySamples labels = s.labels();
  const FacetSet candidates = candidate_triangles(s.triangulation, s.cocones, labels.boundary);
  int vetoed = 0;
  for (std::size_t k = 0; k < s.cocones.facets.size(); ++k) {
    int voters = 0;
    int votes = 0;
    for (unsigned i = 0; i < 3; ++i) {
      if (labels.boundary[s.cocones.corners[k][i]] != 0) continue;
      ++voters;
      votes += (s.cocones.met_corners(k) >> i & 1U) != 0 ? 1 : 0;
    }
    const bool expected = voters > 0 && votes == voters;
    EXPECT_EQ(candidates.contains(s.cocones.facets[k]), expected);
    EXPECT_EQ(candidates.contains(s.cocones.mirrors[k]), expected);
    vetoed += expected ? 0 : 1;
  }
  EXPECT_GT(vetoed, 10);
}

}  // namespace
}  // namespace cocoon
