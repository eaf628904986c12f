#include "update/regions/scanned_again.h"

#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A plane with samples above all of its vertices.
struct PlaneUnderSamples {
  TriangleMesh mesh = testing::grid_plane(6);
  ModelIndex model{mesh};
  std::vector<VertexId> vertices;
  std::vector<Point> samples;

  PlaneUnderSamples() {
    for (const VertexId v : mesh.points.ids()) {
      vertices.push_back(v);
      samples.push_back(mesh.points[v] + Vec3{0, 0, 0.1});
    }
  }
  // With the samples once for each of these normals.
  std::vector<VertexId> again(const std::vector<Vec3>& normals) const {
    const std::vector<NearestPointTree> trees(normals.size(), NearestPointTree(samples));
    return scanned_again(model, vertices, trees, [&](std::size_t c) {
      return std::vector<Outward>(samples.size(), Outward{normals[c]});
    });
  }
};

TEST(ScannedAgain, UnlessTheCloudFacesTheOtherWay) {
  const PlaneUnderSamples plane;
  EXPECT_EQ(plane.again({{0, 0, 1}}), plane.vertices);
  EXPECT_EQ(plane.again({{0, 0, 0}}), plane.vertices);  // not known
  EXPECT_TRUE(plane.again({{0, 0, -1}}).empty());
}

// Of clouds that have the same samples neither is the first.
TEST(ScannedAgain, TheOrderOfTheCloudsDoesNotCount) {
  const PlaneUnderSamples plane;
  EXPECT_EQ(plane.again({{0, 0, 1}, {0, 0, -1}}), plane.vertices);
  EXPECT_EQ(plane.again({{0, 0, -1}, {0, 0, 1}}), plane.vertices);
  EXPECT_TRUE(plane.again({{0, 0, -1}, {0.1, 0, -1}}).empty());
}

TEST(ScannedAgain, AllSamplesNeedANormal) {
  const PlaneUnderSamples plane;
  const std::vector<NearestPointTree> trees(1, NearestPointTree(plane.samples));
  EXPECT_THROW(scanned_again(plane.model, plane.vertices, trees,
                             [](std::size_t) { return std::vector<Outward>(3); }),
               InputError);
}

}  // namespace
}  // namespace cocoon
