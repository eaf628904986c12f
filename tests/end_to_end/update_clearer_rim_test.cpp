// Scans whose best-looking rim leaves a doubt on the model, and another trial's does not.
#include <array>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "geom/mesh_check.h"
#include "io/point_file.h"
#include "tests/end_to_end/boxy_part.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

constexpr std::array<std::array<int, 2>, 8> holes = {
    {{4, 26}, {4, 32}, {13, 20}, {13, 32}, {22, 5}, {22, 25}, {31, 5}, {31, 28}}};

bool is_drilled(int x, int y) {
  for (const auto& [left, front] : holes) {
    if (x >= left && x < left + 2 && y >= front && y < front + 2) return true;
  }
  return false;
}

// A pocket around one of the holes of a plate, seen from above. With rho 0.83 the rim leaves a gap
// at its edge, and eight vertices of the old top would stay over it.
TEST(UpdateClearerRim, PocketAmongHoles) {
  const std::array<int, 3> size = {44, 44, 13};
  const testing::BoxyPart before{size, [](int x, int y, int) { return !is_drilled(x, y); }};
  const testing::BoxyPart after{size, [](int x, int y, int z) {
                                  const bool in_pocket =
                                      x >= 17 && x < 25 && y >= 21 && y < 29 && z >= 11;
                                  return !in_pocket && !is_drilled(x, y);
                                }};
  const TriangleMesh model = testing::surface_of(before);
  const TriangleMesh truth = testing::surface_of(after);
  const std::set<Point> right(truth.points.begin(), truth.points.end());
  const std::vector<std::vector<Point>> clouds = {
      read_points(std::string(COCOON_TEST_DATA) + "/points/pocket_among_holes.xyz").points};

  const auto left_over = [&](const UpdateOptions& options) {
    const UpdateResult result = update_model(model, clouds, options);
    EXPECT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold());
    std::size_t count = 0;
    for (const VertexId v : model.points.ids()) {
      const bool stays = !result.replacement.point_of_vertex[v].is_none();
      count += stays && !right.contains(model.points[v]) ? 1U : 0U;
    }
    return count;
  };
  EXPECT_EQ(left_over({}), 0U);
  UpdateOptions by_rim;
  by_rim.cut.moved.reach = 0;
  EXPECT_EQ(left_over(by_rim), 0U);
  by_rim.cut.clearer_rim = 0;
  EXPECT_GT(left_over(by_rim), 4U);
  UpdateOptions by_samples;  // the cut moves into the gap
  by_samples.cut.clearer_rim = 0;
  EXPECT_EQ(left_over(by_samples), 0U);
}

}  // namespace
}  // namespace cocoon
