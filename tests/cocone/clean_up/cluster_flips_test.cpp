#include "cocone/clean_up/cluster_flips.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "io/mesh_file.h"
#include "tests/cocone/peeled.h"

namespace cocoon {
namespace {

// A plate with five holes that only their rims tell of, all of it inside.
class FilledPlate : public testing::Test {
 protected:
  FilledPlate() {
    ChangingLabels& labels = peeled_.labels;
    for (const CellId c : labels.triangulation.finite_cells()) {
      if (labels.out[c] != 0) labels.flip(std::vector{c});
    }
    for (const VertexId v : labels.triangulation.vertices()) labels.energy.want(v);
  }
  static std::vector<Point> samples() {
    const TriangleMesh mesh = read_mesh(std::string(COCOON_TEST_DATA) + "/models/plate_holes.stl");
    return {mesh.points.begin(), mesh.points.end()};
  }

  Peeled peeled_{samples()};
  ClusterFlips flips_{peeled_.labels, peeled_.options, {}};
};

TEST_F(FilledPlate, OpensAtItsIdleSamples) {
  const std::vector<VertexId> idle = flips_.idle_samples();
  ASSERT_GT(idle.size(), 100U);
  EXPECT_TRUE(std::is_sorted(idle.begin(), idle.end(), [&](VertexId a, VertexId b) {
    return peeled_.labels.spacings.precedes(a, b);
  }));
  CleanUpCounters counters;
  EXPECT_TRUE(flips_.flip(idle, peeled_.options.deep_cosine, counters));
  EXPECT_GE(counters.clusters, 5U);
  EXPECT_LT(flips_.idle_samples().size(), idle.size());
}

TEST_F(FilledPlate, ClustersThatAreTooLargeAreCounted) {
  peeled_.options.most_cluster_cells = 0;
  const std::vector<VertexId> idle = flips_.idle_samples();
  CleanUpCounters counters;
  EXPECT_FALSE(flips_.flip(idle, peeled_.options.deep_cosine, counters));
  EXPECT_EQ(counters.clusters, 0U);
  EXPECT_EQ(counters.large_clusters, idle.size());
}

}  // namespace
}  // namespace cocoon
