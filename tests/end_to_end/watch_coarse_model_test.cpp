#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/mesh_file.h"
#include "tests/end_to_end/scanned_gear.h"
#include "tests/end_to_end/watched_folder.h"
#include "tests/run_program.h"

namespace cocoon::test {
namespace {

using Json = nlohmann::json;

struct WatchedGear : Watched {
  std::string report = folder.file("report.json");

  WatchedGear() {
    arguments[1] = folder.write("part.off", gear());
    arguments.insert(arguments.end(), {"--json", report});
  }
  ProgramRun run_once() const {
    const ProgramRun run = run_program(once());
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return run;
  }
};

TEST(WatchCoarseModel, IsMadeDenseForTheFirstCloud) {
  const WatchedGear watched;
  watched.put("knob.xyz", knob());
  const ProgramRun run = watched.run_once();
  EXPECT_NE(run.out.find("was made dense first"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("is not kept"), std::string::npos) << run.out;
  const Json report = Json::parse(content_of(watched.report));
  EXPECT_EQ(report["update"]["coarse_model"]["made_dense"], true);
  EXPECT_EQ(content_of(watched.mesh), watched.expected({knob()}));
  // It goes on with the dense model, of which it has nothing more to say.
  EXPECT_EQ(watched.run_once().out.find("made dense"), std::string::npos);
  EXPECT_EQ(content_of(watched.mesh), watched.expected({knob()}));
}

// Also in a later run, and after a cloud that could not be applied.
TEST(WatchCoarseModel, IsMadeDenseForTheFirstCloudThatFits) {
  const WatchedGear watched;
  watched.run_once();
  EXPECT_EQ(read_mesh(watched.mesh).points.size(), 42U);
  watched.put("away.xyz", knob(9));
  EXPECT_NE(watched.run_once().out.find("away.xyz: not applied"), std::string::npos);
  EXPECT_EQ(read_mesh(watched.mesh).points.size(), 42U);
  watched.put("knob.xyz", knob());
  EXPECT_NE(watched.run_once().out.find("was made dense first"), std::string::npos);
  EXPECT_EQ(content_of(watched.mesh), watched.expected({knob()}));
}

TEST(WatchCoarseModel, StaysSoIfItIsToBeKept) {
  WatchedGear watched;
  watched.arguments.emplace_back("--keep-coarse");
  watched.put("knob.xyz", knob());
  const ProgramRun run = watched.run_once();
  EXPECT_NE(run.out.find("% of the surface of"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("--densify SPACING"), std::string::npos) << run.out;
  const std::string updated = watched.folder.file("updated.ply");
  const std::string cloud = watched.folder.write("knob.xyz", knob());
  EXPECT_EQ(run_program({"update", watched.arguments[1], cloud, "-o", updated, "--keep-coarse"})
                .exit_code,
            0);
  EXPECT_EQ(content_of(watched.mesh), content_of(updated));
}

}  // namespace
}  // namespace cocoon::test
