// A sheet less than two samples thick, of which a piece is cut off or out: the new edge is one or
// two rows of samples high, and the surface of the scan is torn along it.
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <gtest/gtest.h>
#include <ostream>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "tests/end_to_end/boxy_part.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::BoxyPart;

constexpr std::array<int, 3> size = {30, 20, 1};

struct Cut {
  std::string name;
  std::array<double, 4> gone;  // x and y, from and to
  std::ptrdiff_t euler = 2;

  // How deep inside of what was cut off, below 0 outside.
  double depth(const Point& p) const {
    return std::min({p.x - gone[0], gone[1] - p.x, p.y - gone[2], gone[3] - p.y});
  }
  friend void PrintTo(const Cut& cut, std::ostream* out) { *out << cut.name; }
};

class UpdateThinPlate : public ::testing::TestWithParam<Cut> {};

TEST_P(UpdateThinPlate, LosesWhatWasCutOff) {
  const Cut& cut = GetParam();
  const auto is_gone = [&cut](int x, int y) { return cut.depth({x + 0.5, y + 0.5, 0}) > 0; };
  const TriangleMesh before =
      testing::surface_of(BoxyPart{size, [](int, int, int) { return true; }});
  const TriangleMesh after =
      testing::surface_of(BoxyPart{size, [&](int x, int y, int) { return !is_gone(x, y); }});
  for (const double thickness : {1.8, 2.0}) {
    const double least = 1 / thickness;
    Random random(1);
    const auto all = [](TriangleId) { return true; };
    const TriangleMesh model =
        reconstruct_tight(testing::scan_of_mesh(before, least, random, all)).mesh;
    ASSERT_EQ(mesh_check(model).euler, 2);
    const std::vector<Point> scan = testing::scan_of_mesh(after, least, random, [&](TriangleId t) {
      const auto& [a, b, c] = after.triangles[t];
      return cut.depth((after.points[a] + after.points[b] + after.points[c]) / 3) > -4;
    });
    const UpdateResult result = update_model(model, {{scan}});
    ASSERT_EQ(result.status, UpdateStatus::ok) << thickness << result.message;
    const MeshReport report = mesh_check(result.mesh);
    EXPECT_TRUE(report.is_closed_manifold()) << thickness;
    EXPECT_EQ(report.euler, cut.euler) << thickness;
    for (const VertexId v : model.points.ids()) {
      const double depth = cut.depth(model.points[v]);
      if (depth > 0.01) {
        EXPECT_TRUE(result.vertex_map[v].is_none()) << model.points[v].x;
      } else if (depth < -5) {
        EXPECT_FALSE(result.vertex_map[v].is_none()) << model.points[v].x;
      }
    }
    EXPECT_GT(result.clouds[0].surface.rim.wall_edges, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Cuts, UpdateThinPlate,
                         ::testing::Values(Cut{"Corner", {22, 31, 13, 21}},
                                           Cut{"Notch", {11, 19, 13, 21}},
                                           Cut{"Hole", {12, 18, 7, 13}, 0}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace cocoon
