// A pocket with sharp edges in a slab, scanned by two clouds that overlap each other in it. The
// surface of each is torn along the edges, and ends in the midst of the other one.
#include <gtest/gtest.h>
#include <vector>

#include "cocone/reconstruct.h"
#include "tests/end_to_end/boxy_part.h"
#include "tests/end_to_end/local_update.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::BoxyPart;
using testing::Clouds;

constexpr double least = 0.5;  // between samples

struct SlabWithPocket {
  TriangleMesh model;
  Clouds clouds = Clouds(2);

  explicit SlabWithPocket(std::uint64_t seed) {
    const auto is_pocket = [](int x, int y, int z) {
      return 8 <= x && x < 17 && 5 <= y && y < 13 && z >= 4;
    };
    const TriangleMesh before =
        testing::surface_of(BoxyPart{{25, 18, 9}, [](int, int, int) { return true; }});
    const TriangleMesh after = testing::surface_of(
        BoxyPart{{25, 18, 9}, [&](int x, int y, int z) { return !is_pocket(x, y, z); }});
    Random random(seed);
    const auto all = [](TriangleId) { return true; };
    model = reconstruct_tight(testing::scan_of_mesh(before, least, random, all)).mesh;
    const auto in_view = [&](TriangleId t) {
      const Point& p = after.points[after.triangles[t][0]];
      return p.z > 3.5 && p.x > 4 && p.x < 21 && p.y > 1 && p.y < 17;
    };
    for (std::vector<Point>& cloud : clouds) {
      const bool left = &cloud == &clouds[0];
      for (const Point& p : testing::scan_of_mesh(after, least, random, in_view)) {
        if (left ? p.x < 14 : p.x > 11) cloud.push_back(p);
      }
    }
  }

  static bool in_pocket(const Point& p) {
    return p.z > 8.9 && p.x > 8.5 && p.x < 16.5 && p.y > 5.5 && p.y < 12.5;
  }
  static bool is_far(const Point& p) {
    return p.z < 7 || p.x < 2.5 || p.x > 22.5 || p.y == 0 || p.y == 18;
  }
  std::size_t left_over(const UpdateResult& result) const {
    std::size_t count = 0;
    for (const VertexId v : model.points.ids()) {
      count += in_pocket(model.points[v]) && !result.vertex_map[v].is_none() ? 1U : 0U;
    }
    return count;
  }
};

class UpdateOverlappingClouds : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(UpdateOverlappingClouds, AreOneSurface) {
  const SlabWithPocket part(GetParam());
  const UpdateResult result = update_model(part.model, part.clouds);
  testing::expect_local_update(part.model, part.clouds, result, SlabWithPocket::in_pocket,
                               SlabWithPocket::is_far);
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  EXPECT_EQ(result.clouds[1].joined_with, 0U);
}

TEST_P(UpdateOverlappingClouds, EndWhereAllOfThemEnd) {
  const SlabWithPocket part(GetParam());
  UpdateOptions apart;
  apart.join.reach = 0;
  const UpdateResult result = update_model(part.model, part.clouds, apart);
  testing::expect_local_update(part.model, part.clouds, result, SlabWithPocket::in_pocket,
                               SlabWithPocket::is_far);
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  EXPECT_GT(result.clouds[1].surface.rim.seam_edges, 0U);  // torn
  for (const CloudReport& cloud : result.clouds) EXPECT_GT(cloud.surface.rim.shared_edges, 5U);

  // Each by itself is cut across by the shortest way, and leaves old vertices over the pocket.
  UpdateOptions alone = apart;
  alone.shared.reach = 0;
  EXPECT_GT(part.left_over(update_model(part.model, part.clouds, alone)), 2U);
}

INSTANTIATE_TEST_SUITE_P(Scans, UpdateOverlappingClouds, ::testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace cocoon
