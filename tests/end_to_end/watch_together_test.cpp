// `watch --together`: files that come together are views of one change.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "tests/end_to_end/watched_folder.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace {

using cocoon::test::content_of;
using cocoon::test::count;
using cocoon::test::north;
using cocoon::test::point_line;
using cocoon::test::ProgramRun;
using cocoon::test::run_program;
using cocoon::test::south;
using cocoon::test::wait_for;
using cocoon::test::Watched;
using cocoon::test::Watching;

// What a scanner sees of the bump from one side: of each point, how far along x it lies.
std::string view(double sign) {
  std::string text;
  std::istringstream lines(north);
  double x = 0;
  double y = 0;
  double z = 0;
  while (lines >> x >> y >> z) {
    if (sign * x > -0.25) text += point_line(x, y, z);
  }
  return text;
}

// Along x.
std::string moved(const std::string& cloud, double by) {
  std::string text;
  std::istringstream lines(cloud);
  for (double x = 0, y = 0, z = 0; lines >> x >> y >> z;) text += point_line(x + by, y, z);
  return text;
}

const std::string left = view(-1);
const std::string right = view(1);

struct WatchedTogether : Watched {
  // On a busy machine a while may pass between two files.
  WatchedTogether() {
    *(std::find(arguments.begin(), arguments.end(), "--settle") + 1) = "1";
    arguments.emplace_back("--together");
  }
};

TEST(WatchTogether, ViewsThatComeTogetherAreOneUpdate) {
  const WatchedTogether watched;
  watched.put("left.xyz", left);
  watched.put("right.xyz", right);
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(count(run.out, "left.xyz, right.xyz: "), 1U) << run.out;
  EXPECT_EQ(count(run.out, "2 clouds applied, 0 refused"), 1U) << run.out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected_of_updates({{left, right}}));
  EXPECT_NE(content_of(watched.mesh), watched.expected({left, right}));
}

TEST(WatchTogether, WhatComesLaterIsAnotherUpdate) {
  const WatchedTogether watched;
  const Watching program(watched.arguments);
  watched.put("south.xyz", south);
  ASSERT_TRUE(program.has_said("south.xyz: "));
  watched.put("left.xyz", left);
  watched.put("right.xyz", right);
  ASSERT_TRUE(program.has_said("left.xyz, right.xyz: "));
  program.end(SIGTERM);
  EXPECT_EQ(content_of(watched.mesh), watched.expected_of_updates({{south}, {left, right}}));
}

// Though the program sees them at once.
TEST(WatchTogether, APauseBetweenTheirTimesDividesUpdates) {
  const WatchedTogether watched;
  const auto now = std::filesystem::file_time_type::clock::now();
  const auto put = [&](const std::string& name, const std::string& cloud, int seconds_ago) {
    watched.put(name, cloud);
    std::filesystem::last_write_time(watched.drop + "/" + name,
                                     now - std::chrono::seconds(seconds_ago));
  };
  put("z.xyz", left, 100);
  put("y.xyz", right, 99);
  put("a.xyz", south, 90);
  const std::string out = run_program(watched.once()).out;
  EXPECT_EQ(count(out, "z.xyz, y.xyz: "), 1U) << out;
  EXPECT_EQ(count(out, "\na.xyz: "), 1U) << out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected_of_updates({{left, right}, {south}}));
}

TEST(WatchTogether, WithoutItEachIsAnUpdate) {
  const Watched watched;
  watched.put("left.xyz", left);
  watched.put("right.xyz", right);
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  EXPECT_EQ(content_of(watched.mesh), watched.expected({left, right}));
}

TEST(WatchTogether, AreKeptTogetherWhateverEndsTheProgram) {
  const WatchedTogether watched;
  {
    const Watching program(watched.arguments);
    watched.put("left.xyz", left);
    watched.put("right.xyz", right);
    ASSERT_TRUE(program.has_said("left.xyz, right.xyz: "));
    program.end(SIGKILL);
  }
  EXPECT_TRUE(std::filesystem::exists(watched.mesh + ".session.cloud-1"));
  std::filesystem::remove(watched.mesh);
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(count(run.out, "resumed with 2 clouds applied\n"), 1U) << run.out;
  EXPECT_EQ(count(run.out, "0 clouds applied, 0 refused, 2 known from before"), 1U) << run.out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected_of_updates({{left, right}}));
}

// A kill on the way must not bring those that are left together again.
TEST(WatchTogether, WhatIsTriedOneByOneStaysApartAfterAKill) {
  const WatchedTogether watched;
  {
    const Watching program(watched.arguments);
    watched.put("1.xyz", moved(north, 9));
    watched.put("2.xyz", left);
    watched.put("3.xyz", right);
    ASSERT_TRUE(program.has_said("each by itself:"));
    ASSERT_TRUE(wait_for(  // the note on that is kept after it is said
        [&] { return std::filesystem::exists(watched.mesh + ".session.cloud-1"); }));
    program.end(SIGKILL);
  }
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(count(run.out, ".xyz, "), 0U) << run.out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({left, right}));
}

// What is said of the filter is of the clouds in the line.
TEST(WatchTogether, StraysOfAllCloudsAreCounted) {
  const std::string strays = point_line(4, 0, 0) + point_line(0, 4, 0);
  WatchedTogether watched;
  watched.arguments.insert(watched.arguments.end(), {"--noise", "robust"});
  watched.put("left.xyz", left + strays);
  watched.put("right.xyz", right + strays);
  std::string out = run_program(watched.once()).out;
  EXPECT_EQ(count(out, "left.xyz, right.xyz: "), 1U) << out;
  EXPECT_EQ(count(out, "4 points in 2 small parts left out as noise"), 1U) << out;
  // Also if they were first tried with another one.
  watched.put("far.xyz", moved(north, 9));
  watched.put("right.xyz", right + strays);
  out = run_program(watched.once()).out;
  EXPECT_EQ(count(out, "each by itself"), 1U) << out;
  EXPECT_EQ(count(out, "2 points in 1 small part left out as noise"), 1U) << out;
}

TEST(WatchTogether, WhatIsRefusedTogetherIsTriedOneByOne) {
  const WatchedTogether watched;
  watched.put("bad.xyz", "1 2 3\nfour five six\n");
  watched.put("far.xyz", moved(north, 9));
  watched.put("left.xyz", left);
  const ProgramRun run = run_program(watched.once());
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(count(run.out, "bad.xyz: not applied: "), 1U) << run.out;
  EXPECT_EQ(count(run.out, "far.xyz, left.xyz: not applied together: "), 1U) << run.out;
  EXPECT_EQ(count(run.out, "far.xyz: not applied: "), 1U) << run.out;
  EXPECT_EQ(count(run.out, "1 cloud applied, 2 refused"), 1U) << run.out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({left}));
}

}  // namespace
