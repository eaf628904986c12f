#include "update/checks/bridged_gaps.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A plane of 20 x 20 unit squares; over it, at z = 2, samples half a unit apart that end at
// x = 10.5 and go on from x = 13.5 on, joined by two triangles.
struct BridgedPlane {
  TriangleMesh model = testing::grid_plane(20);
  ModelIndex index{model};
  std::vector<Point> samples = {{10.5, 5, 2}, {10.5, 5.5, 2}, {13.5, 5, 2}, {13.5, 5.5, 2}};
  std::vector<Point> vertices;
  std::vector<Triangle> triangles;

  BridgedPlane() {
    vertices.assign(model.points.begin(), model.points.end());
    const VertexId a = first_new();
    const auto at = [&](std::size_t k) { return VertexId(a.index() + k); };
    vertices.insert(vertices.end(), samples.begin(), samples.end());
    triangles.assign(model.triangles.begin(), model.triangles.end());
    triangles.push_back({at(0), at(2), at(1)});
    triangles.push_back({at(1), at(2), at(3)});
  }
  VertexId first_new() const { return VertexId(model.points.size()); }
  BridgedGaps gaps(double spacing, const GapOptions& options = {}) const {
    const std::vector<NearestPointTree> trees = {NearestPointTree(samples)};
    return bridged_gaps(index, vertices, triangles, first_new(), trees, {&spacing, 1}, options);
  }
};

TEST(BridgedGaps, AreLongTrianglesOffTheModel) {
  const BridgedPlane scene;
  const BridgedGaps found = scene.gaps(0.5);
  EXPECT_EQ(found.triangles, 2U);
  EXPECT_DOUBLE_EQ(found.longest, std::sqrt(9.25) / 0.5);
  EXPECT_EQ(found.at, (Point{12, 5.25, 2}));
  EXPECT_EQ(scene.gaps(1).triangles, 2U);
  EXPECT_EQ(scene.gaps(1.1).triangles, 0U);
  EXPECT_EQ(scene.gaps(1.1, {.reach = 2.5}).triangles, 2U);
}

// The sides of the plane's own triangles are no gaps: no sample is among their corners. Nor is what
// lies on the plane.
TEST(BridgedGaps, OnTheModelAreNone) {
  BridgedPlane scene;
  EXPECT_EQ(scene.gaps(0.5, {.off_model = 3.9}).triangles, 2U);
  EXPECT_EQ(scene.gaps(0.5, {.off_model = 4.1}).triangles, 0U);
  EXPECT_EQ(scene.gaps(0.1, {.reach = 1}).triangles, 2U);
}

// Each triangle by the samples at its corners.
TEST(BridgedGaps, BySpacingOfTheSamplesThere) {
  const BridgedPlane scene;
  const std::vector<Point> far = {{0, 0, 5}};
  const std::vector<NearestPointTree> trees = {NearestPointTree(far),
                                               NearestPointTree(scene.samples)};
  const auto count = [&](const std::vector<double>& spacings) {
    return bridged_gaps(scene.index, scene.vertices, scene.triangles, scene.first_new(), trees,
                        spacings)
        .triangles;
  };
  EXPECT_EQ(count({0.1, 2}), 0U);
  EXPECT_EQ(count({2, 0.1}), 2U);
  EXPECT_THROW(count({1}), InputError);
}

TEST(BridgedGaps, TheSpacingIsThatOfTheModelIfItIsCoarser) {
  const TriangleMesh model = testing::grid_plane(3);
  const ModelIndex index(model);
  const std::vector<TriangleId> facets = {TriangleId(0U), TriangleId(1U), TriangleId(2U)};
  EXPECT_EQ(spacing_at(index, {{}, 0.4}, facets), 1);
  EXPECT_EQ(spacing_at(index, {{}, 2.5}, facets), 2.5);
  EXPECT_EQ(spacing_at(index, {{}, 0.4}, {}), 0.4);
}

}  // namespace
}  // namespace cocoon
