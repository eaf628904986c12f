// Through-holes drilled into a ball and scanned: walls meet the model at sharp edges, where the
// surface of the scan is torn and umbrellas close over what they should not.
#include <gtest/gtest.h>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "tests/end_to_end/drilled_ball.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

class UpdateDrilledHoles : public ::testing::TestWithParam<testing::DrilledBall> {};

// Without webs across the mouths: many cells there are told both sides by their vertices.
TEST_P(UpdateDrilledHoles, AreOpenAtBothEnds) {
  const TriangleMesh model = reconstruct_tight(GetParam().ball()).mesh;
  const UpdateResult result = update_model(model, {{GetParam().scan()}});
  ASSERT_EQ(result.status, UpdateStatus::ok);
  EXPECT_EQ(result.unexplained_handles, 0U);
  const MeshReport report = mesh_check(result.mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.euler, 0);
}

INSTANTIATE_TEST_SUITE_P(Balls, UpdateDrilledHoles,
                         ::testing::Values(testing::DrilledBall{5000, 0.2, 4.5, 0.8},
                                           testing::DrilledBall{5000, 0.2, 4, 1},
                                           testing::DrilledBall{5000, 0.3, 4, 0.7},
                                           testing::DrilledBall{5000, 0.3, 5, 1},
                                           testing::DrilledBall{7000, 0.3, 5, 0.8},
                                           testing::DrilledBall{8000, 0.2, 3, 0.8},
                                           testing::DrilledBall{12000, 0.2, 4, 0.5}));

}  // namespace
}  // namespace cocoon
