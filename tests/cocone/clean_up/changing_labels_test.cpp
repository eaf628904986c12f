#include "cocone/clean_up/changing_labels.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"
#include "tests/cocone/peeled.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

std::vector<VertexId> sorted(std::vector<VertexId> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

TEST(ChangingLabels, FlawsFollowFlips) {
  Peeled peeled(shapes::noisy_sphere(600, 0.05, 3));
  ChangingLabels& labels = peeled.labels;
  ASSERT_GT(labels.region.undecided.size(), 100U);
  Random random(1);
  std::size_t flawed = 0;
  for (int k = 0; k < 60; ++k) {
    const std::vector<CellId>& cells = labels.region.undecided;
    labels.flip(std::vector{cells[random.below(cells.size())]});
    const SurfaceFlaws& flaws = labels.flaws();
    const SurfaceFlaws anew = find_surface_flaws(labels.triangulation, labels.region, labels.out);
    EXPECT_EQ(sorted(flaws.unused), sorted(anew.unused));
    EXPECT_EQ(sorted(flaws.pinched), sorted(anew.pinched));
    flawed = std::max(flawed, flaws.pinched.size());
  }
  EXPECT_GT(flawed, 10U);
}

TEST(ChangingLabels, ByHandTheRegionTakesInWhatWasTouched) {
  Peeled peeled(shapes::noisy_sphere(600, 0.05, 3));
  ChangingLabels& labels = peeled.labels;
  CellId far;
  for (const CellId c : labels.triangulation.finite_cells()) {
    if (!labels.region.contains(labels.triangulation.cell(c).vertices[0])) far = c;
  }
  ASSERT_FALSE(far.is_none());
  labels.touch(far);
  labels.find_flaws({});
  for (const VertexId v : labels.triangulation.cell(far).vertices) {
    EXPECT_TRUE(labels.region.contains(v));
  }
}

TEST(ChangingLabels, SamplesThatAreNotWantedAreNoFlaws) {
  Peeled peeled(shapes::noisy_sphere(600, 0.05, 3));
  ChangingLabels& labels = peeled.labels;
  const std::vector<VertexId> unused = labels.flaws().unused;
  ASSERT_FALSE(unused.empty());
  for (const VertexId v : unused) labels.energy.want(v);
  EXPECT_EQ(labels.flawed_vertices().size(), labels.flaws().pinched.size() + unused.size());
  for (const VertexId v : unused) labels.energy.leave_out(v);
  EXPECT_EQ(labels.flawed_vertices().size(), labels.flaws().pinched.size());
}

}  // namespace
}  // namespace cocoon
