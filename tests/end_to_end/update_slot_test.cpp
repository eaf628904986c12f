// A slot or a pocket is cut into a block, and scanned from above: its walls are not seen, so that
// the surface of its floor has no loop on the model.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>

#include "geom/mesh_check.h"
#include "geom/random/random.h"
#include "tests/end_to_end/local_update.h"
#include "tests/update/hand_made_models.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

// What is cut out of a block of 30 x 12 x 12, whose vertices are 1 apart.
struct CutOut {
  double x0, x1, y0, y1, depth;
  double slope = 0;  // of the floor, which is deeper where y is larger

  bool is_over(const Point& p, double margin) const {
    return p.x > x0 + margin && p.x < x1 - margin && p.y > y0 + margin && p.y < y1 - margin;
  }

  testing::Clouds scan(std::uint64_t seed) const {
    constexpr double apart = 0.7;
    Random random(seed);
    testing::Clouds clouds(1);
    for (double x = 2; x < 28; x += apart) {
      for (double y = 0.3; y < 11.8; y += apart) {
        Point p{x + random.uniform(-0.15, 0.15), y + random.uniform(-0.15, 0.15), 12};
        if (is_over(p, 0)) p.z -= depth + slope * (p.y - y0);
        clouds[0].push_back(p);
      }
    }
    return clouds;
  }

  bool is_former_top(const Point& p) const { return p.z == 12 && is_over(p, 0.5); }
};

// How many of these vertices of the model stay.
std::size_t num_that_stay(const TriangleMesh& model, const UpdateResult& result,
                          const testing::Predicate& is_one) {
  std::size_t count = 0;
  for (const VertexId v : model.points.ids()) {
    count += is_one(model.points[v]) && !result.vertex_map[v].is_none() ? 1U : 0U;
  }
  return count;
}

class UpdateOfACutOut : public ::testing::TestWithParam<std::uint64_t> {};

// Across the whole block, and open at one end.
TEST_P(UpdateOfACutOut, TheTopOfASlotGoes) {
  const TriangleMesh model = testing::block(30, 12, 12);
  for (const CutOut& slot : {CutOut{11, 19, -1, 13, 5}, CutOut{11, 19, 3, 13, 5}}) {
    const testing::Clouds clouds = slot.scan(GetParam());
    const UpdateResult result = update_model(model, clouds);
    const auto is_elsewhere = [&](const Point& p) {
      return p.z < 12 - slot.depth - 1 || (p.z < 12 && !slot.is_over(p, -0.5));
    };
    const auto is_gone = [&](const Point& p) { return slot.is_former_top(p); };
    testing::expect_local_update(model, clouds, result, is_gone, is_elsewhere);
    EXPECT_EQ(mesh_check(result.mesh).euler, 2);
    EXPECT_EQ(result.unscanned.vertices, 0U);

    UpdateOptions blind;
    blind.outward.min_agreement = 2;
    EXPECT_GT(num_that_stay(model, update_model(model, clouds, blind), is_gone), 20U);
  }
}

// The floor does not look through the wall, which is two spacings thick, not even if it faces it.
TEST_P(UpdateOfACutOut, TheSideBesideAPocketStays) {
  const TriangleMesh model = testing::block(30, 12, 12);
  const auto is_below = [](const Point& p) { return p.z < 12; };
  const auto all_below =
      static_cast<std::size_t>(std::count_if(model.points.begin(), model.points.end(), is_below));
  UpdateOptions wide;
  wide.cut.disproved.min_presumed_cosine = wide.cut.disproved.min_cosine;
  wide.unchanged.reach = 0;
  for (const CutOut& pocket : {CutOut{10, 20, 2, 10, 8}, CutOut{10, 20, 2, 10, 3, 0.3}}) {
    const testing::Clouds clouds = pocket.scan(GetParam());
    const UpdateResult result = update_model(model, clouds);
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    EXPECT_LE(num_that_stay(model, result, [&](const Point& p) { return pocket.is_former_top(p); }),
              1U);
    EXPECT_EQ(num_that_stay(model, result, is_below), all_below);
    EXPECT_EQ(mesh_check(result.mesh).euler, 2);
    EXPECT_LT(num_that_stay(model, update_model(model, clouds, wide), is_below), all_below);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, UpdateOfACutOut, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace cocoon
