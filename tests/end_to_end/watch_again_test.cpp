// What `watch` does with a file that it has looked at before: after a restart, and when somebody
// puts it into the folder again.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "tests/end_to_end/watched_folder.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace {

using namespace std::chrono_literals;
using cocoon::test::content_of;
using cocoon::test::count;
using cocoon::test::far_from_origin;
using cocoon::test::north;
using cocoon::test::ProgramRun;
using cocoon::test::run_program;
using cocoon::test::south;
using cocoon::test::sphere_cap;
using cocoon::test::wait_for;
using cocoon::test::Watched;
using cocoon::test::Watching;
using cocoon::test::whole_sphere;

// The top of a high bump: far from the sphere, but not from the bump.
const std::string bump = sphere_cap(4000, 0.8, 0.8);
const std::string top_of_bump = sphere_cap(3000, 0.2, 0.8);

// The model must not go back to an older scan, and not depend on how the program ended.
TEST(WatchAgain, ARefusedCloudIsNotTriedAfterARestart) {
  for (const int signal : {SIGTERM, SIGKILL}) {
    const Watched watched;
    const Watching before(watched.arguments);
    watched.put("1.xyz", top_of_bump);
    ASSERT_TRUE(before.has_said("1.xyz: not applied: "));
    watched.put("2.xyz", bump);
    ASSERT_TRUE(before.has_said("2.xyz: "));
    before.end(signal);
    for (int start = 0; start < 2; ++start) {
      const ProgramRun run = run_program(watched.once());
      ASSERT_EQ(run.exit_code, 0) << run.error;
      EXPECT_EQ(count(run.out, "1.xyz"), 0U) << run.out;
      EXPECT_EQ(
          count(run.out, "resumed with 1 cloud applied, 1 refused that will not be tried again\n"),
          1U)
          << run.out;
      EXPECT_EQ(count(run.out, "0 clouds applied, 0 refused, 2 known from before"), 1U) << run.out;
      EXPECT_EQ(content_of(watched.mesh), watched.expected({bump}));
    }
  }
}

TEST(WatchAgain, ARefusedCloudIsNotedBeforeTheNextIsApplied) {
  const Watched watched;
  const Watching before(watched.arguments);
  watched.put("1.xyz", top_of_bump);
  const std::string note = watched.mesh + ".session.cloud-1";
  EXPECT_TRUE(wait_for([&] { return std::filesystem::exists(note); }));
  before.end(SIGKILL);
  watched.put("2.xyz", bump);
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(note));
  EXPECT_EQ(content_of(watched.mesh), watched.expected({bump}));
}

TEST(WatchAgain, ARefusedCloudThatComesAgainIsTried) {
  const Watched watched;
  watched.put("1.xyz", top_of_bump);
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  watched.put("2.xyz", bump);
  const Watching again(watched.arguments);
  ASSERT_TRUE(again.has_said("2.xyz: "));
  watched.put("1.xyz", top_of_bump);
  ASSERT_TRUE(again.has_said("1.xyz: "));
  EXPECT_EQ(count(again.end(SIGTERM), "2 clouds applied, 0 refused, 1 known"), 1U);
  EXPECT_EQ(content_of(watched.mesh), watched.expected({bump, top_of_bump}));
}

// It may have been the reading that failed, and the model is as it was either way.
TEST(WatchAgain, AFileThatCannotBeReadIsTriedAgain) {
  const Watched watched;
  watched.put("bad.xyz", "1 2 3\nfour five six\n");
  for (int start = 0; start < 2; ++start) {
    const std::string out = run_program(watched.once()).out;
    EXPECT_EQ(count(out, "bad.xyz: not applied: "), 1U) << out;
    EXPECT_EQ(count(out, "0 clouds applied, 1 refused, 0 known"), 1U) << out;
  }
}

// An old scan takes a change back.
TEST(WatchAgain, ACloudThatComesAgainIsAppliedAgain) {
  const Watched watched;
  const std::string flat = sphere_cap(4000, 0.8);
  const Watching first(watched.arguments);
  std::vector<std::string> clouds;
  for (const std::string& cloud : {flat, north, flat, flat}) {
    clouds.push_back(cloud);
    watched.put("scan.xyz", cloud);
    ASSERT_TRUE(first.has_said("scan.xyz: ", clouds.size()));
  }
  // Also if it is the same file as ever.
  const std::string elsewhere = watched.folder.file("elsewhere");
  std::filesystem::rename(watched.drop + "/scan.xyz", elsewhere);
  watched.put("other.xyz", south);
  ASSERT_TRUE(first.has_said("other.xyz: "));
  std::filesystem::rename(elsewhere, watched.drop + "/scan.xyz");
  ASSERT_TRUE(first.has_said("scan.xyz: ", 5));
  first.end(SIGKILL);
  clouds.insert(clouds.end(), {south, flat});
  const std::string expected = watched.expected(clouds);
  EXPECT_EQ(content_of(watched.mesh), expected);
  for (int start = 0; start < 2; ++start) {
    const std::string out = run_program(watched.once()).out;
    EXPECT_EQ(count(out, "resumed with 6 clouds applied\n"), 1U) << out;
    EXPECT_EQ(count(out, "0 clouds applied, 0 refused, 2 known from before"), 1U) << out;
    EXPECT_EQ(content_of(watched.mesh), expected);
  }
}

// Then its time tells whether it came again.
TEST(WatchAgain, ACloudThatComesAgainWhileTheProgramIsDown) {
  const Watched watched;
  const std::string scan = watched.drop + "/scan.xyz";
  watched.put("scan.xyz", north);
  const auto time = std::filesystem::last_write_time(scan);
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  watched.put("scan.xyz", north);
  std::filesystem::last_write_time(scan, time);
  std::string out = run_program(watched.once()).out;
  EXPECT_EQ(count(out, "0 clouds applied, 0 refused, 1 known from before"), 1U) << out;
  std::filesystem::last_write_time(scan, time + 1s);
  out = run_program(watched.once()).out;
  EXPECT_EQ(count(out, "1 cloud applied, 0 refused, 0 known from before"), 1U) << out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north, north}));
  // After another one under its name it is a new one with its old time, too.
  watched.put("scan.xyz", sphere_cap(4000, 0.8));
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  watched.put("scan.xyz", north);
  std::filesystem::last_write_time(scan, time + 1s);
  out = run_program(watched.once()).out;
  EXPECT_EQ(count(out, "1 cloud applied, 0 refused, 0 known from before"), 1U) << out;
}

// The mesh is written after each cloud.
TEST(WatchAgain, AMeshThatFloatsCannotKeepIsToldOnce) {
  Watched watched;
  watched.arguments[1] = watched.folder.write("far.xyz", far_from_origin(whole_sphere(1500)));
  watched.arguments[4] = watched.folder.file("out.stl");
  watched.put("1.xyz", far_from_origin(north));
  watched.put("2.xyz", far_from_origin(south));
  const ProgramRun run = run_program(watched.once());
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(count(run.out, "2 clouds applied"), 1U) << run.out;
  EXPECT_EQ(count(run.out, "in the floats of binary STL vertices move"), 1U) << run.out;
}

}  // namespace
