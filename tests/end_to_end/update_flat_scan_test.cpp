// The update by scans that lie in one plane, exactly.
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "geom/surface_distance.h"
#include "tests/end_to_end/boxy_part.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::BoxyPart;
using testing::scan_of_mesh;

TEST(UpdateFlatScan, ABossTakenOffLeavesAFlatScan) {
  const auto part = [](bool with_boss) {
    return BoxyPart{{6, 6, 3}, [=](int x, int y, int z) {
                      const bool boss = x >= 2 && x < 4 && y >= 2 && y < 4;
                      return z < 2 || (with_boss && boss);
                    }};
  };
  const TriangleMesh before = surface_of(part(true));
  const TriangleMesh after = surface_of(part(false));
  Random random(3);
  const auto all = [](TriangleId) { return true; };
  const auto on_top = [&](TriangleId t) {
    const auto corners = corners_of(after, t);
    return std::all_of(corners.begin(), corners.end(), [](const Point& p) {
      return p.z == 2 && std::min(p.x, p.y) >= 1 && std::max(p.x, p.y) <= 5;
    });
  };
  constexpr double least = 0.12;
  const ReconstructResult model = reconstruct_tight(scan_of_mesh(before, least, random, all));
  ASSERT_EQ(model.status, SurfaceStatus::ok);
  const std::vector<Point> cloud = scan_of_mesh(after, least, random, on_top);
  ASSERT_TRUE(std::all_of(cloud.begin(), cloud.end(), [](const Point& p) { return p.z == 2; }));

  const UpdateResult result = update_model(model.mesh, std::vector<std::vector<Point>>{cloud});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(mesh_check(result.mesh).genus, 0U);
  EXPECT_LT(surface_distance(result.mesh, after, {.samples = 20000}).max, least);
}

}  // namespace
}  // namespace cocoon
