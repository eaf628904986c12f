// The update of a block by the scan of a narrow crack.
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "tests/end_to_end/boxy_part.h"
#include "tests/mesh_gallery.h"
#include "update/update_session.h"

namespace cocoon {
namespace {

// A crack in the top of a block, as narrow as a blade at its end: 1.2 wide, 10 long, 4 deep.
struct CrackedBlock {
  Random random;
  TriangleMesh model;
  std::vector<Point> scan;

  // Samples in the crack and around it are 0.15 apart, with errors of the given share of that.
  CrackedBlock(double error, std::uint64_t seed) : random(seed) {
    constexpr double least = 0.15;
    const auto all = [](TriangleId) { return true; };
    const TriangleMesh block =
        testing::surface_of({{17, 20, 9}, [](int, int, int) { return true; }});
    model = reconstruct_tight(testing::scan_of_mesh(block, 0.7, random, all)).mesh;
    scan = testing::scan_of_mesh(crack(), least, random, all);
    for (Point& p : scan) p = p + (error * least) * random.on_unit_sphere();
  }

  static TriangleMesh crack() {
    return gallery::make_mesh({{4, 2, 9},
                               {13, 2, 9},
                               {13, 18, 9},
                               {4, 18, 9},
                               {8.5, 5, 9},
                               {9.1, 10, 9},
                               {8.5, 15, 9},
                               {7.9, 10, 9},
                               {8.5, 10, 5}},
                              {{0, 1, 4},
                               {1, 5, 4},
                               {1, 2, 5},
                               {2, 6, 5},
                               {2, 3, 6},
                               {3, 7, 6},
                               {3, 0, 7},
                               {0, 4, 7},
                               {4, 5, 8},
                               {5, 6, 8},
                               {6, 7, 8},
                               {7, 4, 8}});
  }
};

std::vector<std::string> told(const UpdateResult& result) {
  std::vector<std::string> found;
  for (const std::string& warning : result.warnings) {
    if (warning.find("contradict each other") != std::string::npos) found.push_back(warning);
  }
  return found;
}

UpdateOptions first_look() {
  UpdateOptions options;
  options.reconstruct.second_look.enabled = false;
  return options;
}

// Where walls are closer than the samples are dense, they are guessed.
TEST(UpdateCrack, ContradictionsAreTold) {
  const CrackedBlock block(0.2, 5);
  const UpdateResult result = update_model(block.model, {{block.scan}}, first_look());
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  const ContradictedSamples& found = result.clouds[0].contradicted;
  EXPECT_GT(found.count, 100U);
  EXPECT_EQ(found.of, block.scan.size());
  EXPECT_NEAR(found.at.x, 8.5, 0.7);
  EXPECT_LT(found.at.z, 8.9);
  EXPECT_EQ(told(result).size(), 1U);

  UpdateSession session(block.model, first_look());
  EXPECT_EQ(session.apply({{block.scan}}).result.warnings, result.warnings);
  // Now without looking at the whole.
  session.undo();
  EXPECT_EQ(session.apply({{block.scan}}).result.warnings, result.warnings);
}

// Of a volume of 8, of which the second look opens what the first leaves closed.
TEST(UpdateCrack, ASecondLookOpensIt) {
  const CrackedBlock block(0.2, 5);
  const double volume = mesh_measure(block.model).signed_volume;
  const auto opened = [&](const UpdateOptions& options) {
    const UpdateResult result = update_model(block.model, {{block.scan}}, options);
    EXPECT_EQ(result.status, UpdateStatus::ok) << result.message;
    return volume - mesh_measure(result.mesh).signed_volume;
  };
  EXPECT_LT(opened(first_look()), 6.5);
  EXPECT_GT(opened({}), 7.2);

  const UpdateResult result = update_model(block.model, {{block.scan}});
  EXPECT_EQ(result.reconstruction.counters.second_look, 1U);
  UpdateSession session(block.model);
  for (int i = 0; i < 2; ++i) {  // from nothing, and from what is kept
    EXPECT_EQ(session.apply({{block.scan}}).result.reconstruction.counters.second_look, 1U);
    EXPECT_EQ(session.model(), result.mesh);
    session.undo();
  }
}

// Sharp edges have always some.
TEST(UpdateCrack, AFewContradictionsAreNot) {
  const CrackedBlock block(0, 2);
  const UpdateResult first = update_model(block.model, {{block.scan}}, first_look());
  ASSERT_EQ(first.status, UpdateStatus::ok) << first.message;
  EXPECT_GT(first.clouds[0].contradicted.count, 5U);
  EXPECT_TRUE(told(first).empty());
  const UpdateResult result = update_model(block.model, {{block.scan}});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  // So narrow a crack tears the surface of the scan, and the rim among few samples looks better.
  // But that of all leaves no more doubt on the model.
  EXPECT_FALSE(result.clouds[0].surface.is_layered);
  EXPECT_TRUE(told(result).empty());
  // Beside the crack a dent comes in, a model's spacing and a half deep: that is told.
  EXPECT_EQ(result.warnings.size(), 1U);
  EXPECT_GT(result.gaps.triangles, 0U);
  EXPECT_EQ(mesh_check(result.mesh).genus, 0U);
}

}  // namespace
}  // namespace cocoon
