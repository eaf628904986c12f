// The update as near to the paper as options go: the same in the program and in the library.
#include <gtest/gtest.h>
#include <string>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "io/sample_models.h"
#include "tests/run_program.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using test::run_program;
using test::TemporaryFolder;

TEST(UpdatePaperMode, OfTheProgramIsThatOfTheLibrary) {
  const SampleModel sample = sample_model("joystick-1", {.points = 5000, .cloud_points = 3000});
  const TriangleMesh model = reconstruct_tight(sample.initial).mesh;
  const UpdateResult result = update_model(model, sample.clouds, paper_update_options());
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_TRUE(mesh_check(result.mesh).watertight);
  EXPECT_EQ(result.reconstruction.counters.known_cells, 0U);
  EXPECT_EQ(result.reconstruction.counters.clean_up.undecided_cells, 0U);

  const TemporaryFolder folder;
  const std::string initial = folder.file("initial.ply");
  const std::string cloud = folder.file("cloud.ply");
  const std::string updated = folder.file("updated.ply");
  write_mesh(initial, model);
  write_points(cloud, sample.clouds[0]);
  const auto run =
      run_program({"update", initial, cloud, "-o", updated, "--mode", "paper", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(read_mesh(updated), result.mesh);
}

}  // namespace
}  // namespace cocoon
