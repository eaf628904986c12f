// The update of a model with a hollow that no point outside sees.
#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "tests/end_to_end/local_update.h"
#include "tests/gallery.h"
#include "tests/mesh_gallery.h"
#include "tests/update/session_checks.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::Clouds;
using testing::expect_local_update;

double polar_angle(const Point& p) { return testing::polar_angle(p, {0, 0, 1}); }

// A ball with a hollow, and a hill on top.
struct HollowBall {
  TriangleMesh model = reconstruct_tight(gallery::even_sphere(3000)).mesh;
  Clouds clouds = {{}};
  std::size_t inner = 0;  // vertices of the hollow

  HollowBall() {
    TriangleMesh cavity = reconstruct_tight(gallery::even_sphere(1000)).mesh;
    inner = cavity.points.size();
    for (Point& p : cavity.points) p = 0.4 * p;
    model = gallery::join(model, gallery::flipped(cavity));
    for (const Point& p : gallery::even_sphere(12001)) {
      const double angle = polar_angle(p);
      if (angle <= 0.6) clouds[0].push_back((1 + 0.25 * testing::hill(angle, 0.4)) * p);
    }
  }
};

TEST(UpdateHollow, IsKept) {
  const HollowBall ball;
  const UpdateResult result = update_model(ball.model, ball.clouds);
  expect_local_update(
      ball.model, ball.clouds, result,
      [](const Point& p) { return norm(p) > 0.5 && polar_angle(p) < 0.52; },
      [](const Point& p) { return norm(p) < 0.5 || polar_angle(p) > 0.62; });
  EXPECT_EQ(mesh_check(result.mesh).components, 2U);
  EXPECT_EQ(result.reconstruction.unused_points, 0U);
  EXPECT_EQ(result.unscanned.vertices, 0U);
}

// Whatever the session did before: also one that goes on from the snapshot of another one.
TEST(UpdateHollow, IsKeptBySessions) {
  const HollowBall ball;
  Random random(3);
  const auto next = [&](const UpdateSession& session) {
    const double edge = mean_edge(session.model());
    const VertexId top(random.below(ball.model.points.size() / 2));
    return Clouds{scan_of(session.model(), top, 6 * edge, 0.2 * edge, 0.15 * edge, random)};
  };
  UpdateSession session(ball.model);
  EXPECT_TRUE(apply_and_compare(session, ball.clouds));
  EXPECT_TRUE(apply_and_compare(session, next(session)));
  EXPECT_EQ(mesh_check(session.model()).components, 2U);
  session.undo();
  EXPECT_TRUE(apply_and_compare(session, next(session)));
  UpdateSession again(session.snapshot());
  EXPECT_TRUE(apply_and_compare(again, next(again)));
  EXPECT_EQ(mesh_check(again.model()).components, 2U);
}

// Tight Cocone as published fills it. Its vertices are counted, named in a warning, and gone from
// the map.
TEST(UpdateHollow, IsFilledAndReportedInPaperMode) {
  const HollowBall ball;
  const UpdateResult result = update_model(ball.model, ball.clouds, paper_update_options());
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(mesh_check(result.mesh).components, 1U);
  EXPECT_GE(result.unscanned.vertices, ball.inner);
  EXPECT_TRUE(std::any_of(result.warnings.begin(), result.warnings.end(), [](const std::string& w) {
    return w.find(" vertices of the model are gone though nothing was") != std::string::npos;
  }));
}

}  // namespace
}  // namespace cocoon
