// The update as near to the paper as options go: the same in the program and in the library.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

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

// The numbers in a file, one a line.
std::vector<long> numbers_of(const std::string& path) {
  std::istringstream text(content_of(path));
  return {std::istream_iterator<long>(text), {}};
}

class UpdatePaperModeOfSamples : public ::testing::TestWithParam<const char*> {};

// `cocoon sample` tells which points the change makes wrong, `--map` which have gone.
TEST_P(UpdatePaperModeOfSamples, ReplacesWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string name = GetParam();
  const auto made = run_program({"sample", name, "-o", folder.file(name), "--points", "5000",
                                 "--cloud-points", "6000", "--quiet"});
  ASSERT_EQ(made.exit_code, 0) << made.error;
  std::vector<std::string> update = {"update", folder.file(name + "/initial.xyz")};
  for (const auto& entry : std::filesystem::directory_iterator(folder / name)) {
    if (entry.path().filename().string().starts_with("cloud-")) update.push_back(entry.path());
  }
  const std::string map = folder.file("map.txt");
  update.insert(update.end(),
                {"-o", folder.file("updated.ply"), "--map", map, "--mode", "paper", "--quiet"});
  const auto run = run_program(update);
  ASSERT_EQ(run.exit_code, 0) << run.error;

  const std::vector<long> vertices = numbers_of(map);
  ASSERT_EQ(vertices.size(), 5000U);
  std::vector<long> gone;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i] < 0) gone.push_back(static_cast<long>(i));
  }
  std::vector<long> wrong = numbers_of(folder.file(name + "/replaced.txt"));
  std::sort(wrong.begin(), wrong.end());
  EXPECT_GT(wrong.size(), 30U);
  EXPECT_TRUE(std::includes(gone.begin(), gone.end(), wrong.begin(), wrong.end()));
  // Here they are even equal; vertices on the very rim may go either way.
  EXPECT_LE(gone.size(), wrong.size() + 2);
}

INSTANTIATE_TEST_SUITE_P(Models, UpdatePaperModeOfSamples,
                         ::testing::Values("block", "airbag", "golf-club"), [](const auto& named) {
                           const std::string name = named.param;
                           return name.substr(0, name.find('-'));
                         });

}  // namespace
}  // namespace cocoon
