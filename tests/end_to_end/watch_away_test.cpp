// What `watch` does when files, or the folder, cannot be looked at for a while, as those of a share
// that is unmounted.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

#include "tests/end_to_end/watched_folder.h"
#include "tests/file_permissions.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

namespace fs = std::filesystem;

void set_permissions(const std::string& path, unsigned mode) {
  fs::permissions(path, static_cast<fs::perms>(mode));
}

// Some polls.
void let_it_look() { std::this_thread::sleep_for(std::chrono::milliseconds(300)); }

TEST(WatchAway, FilesThatCannotBeLookedAtForAWhileAreNotNew) {
  if (!permissions_can_be_obeyed()) GTEST_SKIP() << "root cannot give up its rights here";
  const Watched watched;
  const Watching program(watched.arguments, obey_permissions);
  watched.put("1.xyz", north);
  ASSERT_TRUE(program.has_said("1.xyz: "));
  set_permissions(watched.drop, 0600);
  ASSERT_TRUE(program.has_said(
      watched.drop + ": 1 file cannot be looked at (Permission denied); waiting until that is"));
  let_it_look();
  set_permissions(watched.drop, 0700);
  let_it_look();
  watched.put("2.xyz", south);
  ASSERT_TRUE(program.has_said("2.xyz: "));
  const std::string out = program.end(SIGTERM);
  EXPECT_EQ(count(out, "1.xyz: "), 1U) << out;
  EXPECT_EQ(count(out, "cannot be looked at"), 1U) << out;
  EXPECT_EQ(count(out, "2 clouds applied, 0 refused"), 1U) << out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north, south}));
}

// Whether nothing is under its name meanwhile, or the empty folder at which it is mounted.
TEST(WatchAway, AFolderThatComesBackIsNotNew) {
  for (const bool leaves_a_folder : {false, true}) {
    const Watched watched;
    const Watching program(watched.arguments);
    watched.put("1.xyz", north);
    ASSERT_TRUE(program.has_said("1.xyz: "));
    const std::string away = watched.folder.file("away");
    fs::rename(watched.drop, away);
    if (leaves_a_folder) fs::create_directory(watched.drop);
    if (!leaves_a_folder) {
      ASSERT_TRUE(program.has_said(watched.drop + ": cannot read this folder: No such file or " +
                                   "directory; waiting until it can be read again\n"));
    }
    let_it_look();
    if (leaves_a_folder) fs::remove(watched.drop);
    fs::rename(away, watched.drop);
    let_it_look();
    watched.put("2.xyz", south);
    ASSERT_TRUE(program.has_said("2.xyz: "));
    const std::string out = program.end(SIGTERM);
    EXPECT_EQ(count(out, "1.xyz: "), 1U) << out;
    // (Between the two steps above the folder may have been missed once.)
    EXPECT_EQ(count(out, "can be read again\n"), 2 * count(out, "cannot read this folder")) << out;
    EXPECT_EQ(count(out, "2 clouds applied, 0 refused"), 1U) << out;
    EXPECT_EQ(content_of(watched.mesh), watched.expected({north, south}));
  }
}

// The program is up before the share: its clouds are known from the run before.
TEST(WatchAway, AFolderThatComesLateIsKnown) {
  const Watched watched;
  watched.put("1.xyz", north);
  ASSERT_EQ(run_program(watched.once()).exit_code, 0);
  const std::string away = watched.folder.file("away");
  fs::rename(watched.drop, away);
  fs::create_directory(watched.drop);
  const Watching program(watched.arguments);
  let_it_look();
  fs::remove(watched.drop);
  fs::rename(away, watched.drop);
  watched.put("2.xyz", south);
  ASSERT_TRUE(program.has_said("2.xyz: "));
  const std::string out = program.end(SIGTERM);
  EXPECT_EQ(count(out, "1 cloud applied, 0 refused, 1 known from before"), 1U) << out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north, south}));
}

// Nobody waits for what is done once.
TEST(WatchAway, AFolderThatCannotBeReadAtFirstIsAnError) {
  if (!permissions_can_be_obeyed()) GTEST_SKIP() << "root cannot give up its rights here";
  const Watched watched;
  set_permissions(watched.drop, 0300);
  for (const std::vector<std::string>& arguments : {watched.arguments, watched.once()}) {
    const ProgramRun run = run_program(arguments, obey_permissions);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.error,
              "cocoon: " + watched.drop + ": cannot read this folder: Permission " + "denied\n");
  }
  set_permissions(watched.drop, 0700);
}

TEST(WatchAway, AFileThatCannotBeReadIsAppliedWhenItCan) {
  if (!permissions_can_be_obeyed()) GTEST_SKIP() << "root cannot give up its rights here";
  const Watched watched;
  const std::string file = watched.drop + "/1.xyz";
  watched.put("1.xyz", north);
  set_permissions(file, 0);
  const ProgramRun once = run_program(watched.once(), obey_permissions);
  EXPECT_EQ(once.exit_code, 0) << once.error;
  EXPECT_EQ(count(once.out, "0 clouds applied, 1 refused"), 1U) << once.out;
  const Watching program(watched.arguments, obey_permissions);
  ASSERT_TRUE(program.has_said("1.xyz: not applied: " + file +
                               ": cannot be read (Permission denied); check the name and the "
                               "permissions; it is tried again until it can be read\n"));
  watched.put("2.xyz", south);
  ASSERT_TRUE(program.has_said("2.xyz: "));
  let_it_look();
  set_permissions(file, 0600);
  ASSERT_TRUE(program.has_said("\n1.xyz: ", 2));
  const std::string out = program.end(SIGTERM);
  EXPECT_EQ(count(out, "\n1.xyz: "), 2U) << out;
  EXPECT_EQ(count(out, "2 clouds applied, 0 refused"), 1U) << out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({south, north}));
}

}  // namespace
}  // namespace cocoon::test
