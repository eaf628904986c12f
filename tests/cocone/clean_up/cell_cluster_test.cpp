#include "cocone/clean_up/cell_cluster.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "tests/cocone/random_labeling.h"

namespace cocoon {
namespace {

struct Clusters {
  explicit Clusters(Labeling& of)
      : labeling(of),
        known(of.stages.triangulation.num_cells()),
        scratch(of.stages.triangulation.num_cells()) {}

  CellCluster at(CellId c, double cosine, std::size_t most_cells) {
    CellCluster cluster = cell_cluster(labeling.stages.triangulation, labeling.cosines,
                                       labeling.out, c, cosine, most_cells, known, scratch);
    std::sort(cluster.cells.begin(), cluster.cells.end());
    return cluster;
  }

  Labeling& labeling;
  ZeroedArray<CellId, ClusterSize> known;
  ZeroedArray<CellId, std::uint8_t> scratch;
};

// What was found before ends searches early, and changes no answer.
TEST(CellCluster, WhatIsKnownChangesNothing) {
  std::size_t small = 0;
  std::size_t large = 0;
  for (const double bias : {0.2, 0.9}) {
    Labeling labeling(shapes::sphere(300, 5), 7, bias);
    Clusters together(labeling);
    for (const CellId c : labeling.stages.triangulation.finite_cells()) {
      const CellCluster alone = Clusters(labeling).at(c, 0.9, 12);
      const CellCluster after = together.at(c, 0.9, 12);
      EXPECT_EQ(after.too_large, alone.too_large);
      EXPECT_TRUE(alone.too_large || after.cells == alone.cells);
      EXPECT_EQ(together.known[c], alone.too_large ? ClusterSize::too_large : ClusterSize::small);
      (alone.too_large ? large : small) += 1;
    }
  }
  EXPECT_GT(small, 100U);
  EXPECT_GT(large, 100U);
}

// One labeling, one cosine: it is asked from each of its cells but the slivers.
TEST(CellCluster, IsTheSameFromEachOfItsCells) {
  Labeling labeling(shapes::sphere(200, 6), 3, 0.5);
  std::size_t others = 0;
  for (const CellId c : labeling.stages.triangulation.finite_cells()) {
    Clusters clusters(labeling);
    const CellCluster cluster =
        cell_cluster(labeling.stages.triangulation, labeling.cosines, labeling.out, c, 0.8, 1000,
                     clusters.known, clusters.scratch);
    CellCluster sorted = cluster;
    std::sort(sorted.cells.begin(), sorted.cells.end());
    for (const CellId other : cluster.cells) {
      if (clusters.known[other] == ClusterSize::unknown) continue;
      EXPECT_EQ(Clusters(labeling).at(other, 0.8, 1000).cells, sorted.cells);
      others += other == c ? 0U : 1U;
    }
  }
  EXPECT_GT(others, 100U);
}

}  // namespace
}  // namespace cocoon
