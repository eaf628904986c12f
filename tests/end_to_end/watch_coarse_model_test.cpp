#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/mesh_file.h"
#include "tests/end_to_end/scanned_gear.h"
#include "tests/run_program.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

struct WatchedGear {
  TemporaryFolder folder;
  TemporaryFolder drop;
  std::string part = folder.write("part.off", gear());
  std::string mesh = folder.file("watched.ply");
  std::string report = folder.file("report.json");

  ProgramRun run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"watch",  part,     drop.file(""), "-o",
                                          mesh,     "--once", "--settle",    "0",
                                          "--poll", "0.01",   "--json",      report};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return run;
  }
  // What `update` makes of the part.
  std::string expected(const std::vector<std::string>& more = {}) const {
    const std::string updated = folder.file("updated.ply");
    std::vector<std::string> arguments = {"update", part, folder.write("knob.xyz", knob()), "-o",
                                          updated};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_program(arguments).exit_code, 0);
    return content_of(updated);
  }
};

TEST(WatchCoarseModel, IsMadeDenseForTheFirstCloud) {
  const WatchedGear watched;
  watched.drop.write("knob.xyz", knob());
  const ProgramRun run = watched.run();
  EXPECT_NE(run.out.find("was made dense first"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("is not kept"), std::string::npos) << run.out;
  const Json report = Json::parse(content_of(watched.report));
  EXPECT_EQ(report["update"]["coarse_model"]["made_dense"], true);
  EXPECT_EQ(content_of(watched.mesh), watched.expected());
  // It goes on with the dense model, of which it has nothing more to say.
  EXPECT_EQ(watched.run().out.find("made dense"), std::string::npos);
  EXPECT_EQ(content_of(watched.mesh), watched.expected());
}

// Also in a later run, and after a cloud that could not be applied.
TEST(WatchCoarseModel, IsMadeDenseForTheFirstCloudThatFits) {
  const WatchedGear watched;
  watched.run();
  EXPECT_EQ(read_mesh(watched.mesh).points.size(), 42U);
  watched.drop.write("away.xyz", knob(9));
  EXPECT_NE(watched.run().out.find("away.xyz: not applied"), std::string::npos);
  EXPECT_EQ(read_mesh(watched.mesh).points.size(), 42U);
  watched.drop.write("knob.xyz", knob());
  EXPECT_NE(watched.run().out.find("was made dense first"), std::string::npos);
  EXPECT_EQ(content_of(watched.mesh), watched.expected());
}

TEST(WatchCoarseModel, StaysSoIfItIsToBeKept) {
  const WatchedGear watched;
  watched.drop.write("knob.xyz", knob());
  const ProgramRun run = watched.run({"--keep-coarse"});
  EXPECT_NE(run.out.find("% of the surface of"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("--densify SPACING"), std::string::npos) << run.out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({"--keep-coarse"}));
}

}  // namespace
}  // namespace cocoon::test
