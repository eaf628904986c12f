// What `watch` does when files, or the folder, cannot be looked at for a while, as those of a share
// that is unmounted, and when a file changes while it is read.
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "tests/end_to_end/watched_folder.h"
#include "tests/file_permissions.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

namespace fs = std::filesystem;

const std::string flat = sphere_cap(4000, 0.8);

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

// With --once nobody waits for a file that can be looked at later, nor says so.
TEST(WatchAway, OnceDoesNotWaitForALoopOfLinks) {
  const Watched watched;
  std::filesystem::create_symlink("loop.xyz", watched.drop + "/loop.xyz");
  const ProgramRun run = run_program(watched.once());
  EXPECT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(count(run.out, "(Too many levels of symbolic links); --once does not wait for that\n"),
            1U)
      << run.out;
  EXPECT_EQ(count(run.out, "waiting"), 0U) << run.out;
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
  std::ofstream(watched.mesh) << "of before";
  for (const std::vector<std::string>& arguments : {watched.arguments, watched.once()}) {
    const ProgramRun run = run_program(arguments, obey_permissions);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.error, "cocoon: " + watched.drop +
                             ": cannot read this folder: Permission denied; check its "
                             "permissions\n");
    EXPECT_EQ(content_of(watched.mesh), "of before");
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

// A file that is changed as soon as somebody opens it to read: that one waits until it has changed.
class ChangedWhenOpened {
 public:
  ChangedWhenOpened(const std::string& path, const std::string& content)
      : file_(open(path.c_str(), O_RDWR | O_CLOEXEC)) {
    std::signal(SIGIO, SIG_IGN);
    EXPECT_EQ(write(file_, content.data(), content.size()), static_cast<ssize_t>(content.size()));
    is_held_ = fcntl(file_, F_SETLEASE, F_WRLCK) == 0;
  }
  ~ChangedWhenOpened() { close(file_); }
  ChangedWhenOpened(const ChangedWhenOpened&) = delete;
  ChangedWhenOpened& operator=(const ChangedWhenOpened&) = delete;

  bool is_held() const { return is_held_; }
  // Adds `more` and, so that only the length has changed, sets the time that it had.
  void change(const std::string& more) const {
    EXPECT_TRUE(wait_for([&] { return fcntl(file_, F_GETLEASE) != F_WRLCK; }));
    struct stat status = {};
    EXPECT_EQ(fstat(file_, &status), 0);
    EXPECT_EQ(write(file_, more.data(), more.size()), static_cast<ssize_t>(more.size()));
    const timespec times[2] = {status.st_atim, status.st_mtim};
    EXPECT_EQ(futimens(file_, times), 0);
    EXPECT_EQ(fcntl(file_, F_SETLEASE, F_UNLCK), 0);
  }

 private:
  int file_;
  bool is_held_ = false;
};

TEST(WatchAway, WhatChangesWhileItIsReadIsReadAgain) {
  const Watched watched;
  const std::size_t half = north.find('\n', north.size() / 2) + 1;
  const std::string part = watched.folder.write("part", "");
  const ChangedWhenOpened file(part, north.substr(0, half));
  if (!file.is_held()) GTEST_SKIP() << "this file system has no leases";
  fs::rename(part, watched.drop + "/1.xyz");
  const RunningProgram program(watched.folder, watched.once());
  file.change(north.substr(half));
  const ProgramRun run = program.wait();
  EXPECT_EQ(count(run.out, "1.xyz: "), 1U) << run.out;
  EXPECT_EQ(count(run.out, "1 cloud applied, 0 refused"), 1U) << run.out;
  EXPECT_EQ(content_of(watched.mesh), watched.expected({north}));
}

// What makes no sense may be the half of something.
TEST(WatchAway, WhatChangesWhileItIsReadIsNotRefused) {
  const Watched watched;
  const std::string part = watched.folder.write("part", "");
  const ChangedWhenOpened file(part, "1 2 3\n4 5");
  if (!file.is_held()) GTEST_SKIP() << "this file system has no leases";
  fs::rename(part, watched.drop + "/1.xyz");
  const RunningProgram program(watched.folder, watched.once());
  file.change(" x\n");
  const ProgramRun run = program.wait();
  EXPECT_EQ(count(run.out, "1.xyz: not applied: "), 1U) << run.out;
  EXPECT_EQ(count(run.out, "0 clouds applied, 1 refused"), 1U) << run.out;
}

// Views of one change wait for each other.
TEST(WatchAway, WhatIsAppliedTogetherWaitsForAll) {
  Watched watched;
  watched.arguments.emplace_back("--together");
  const std::string part = watched.folder.write("part", "");
  const std::size_t half = north.find('\n', north.size() / 2) + 1;
  const ChangedWhenOpened file(part, north.substr(0, half));
  if (!file.is_held()) GTEST_SKIP() << "this file system has no leases";
  fs::rename(part, watched.drop + "/2.xyz");
  const fs::file_time_type time = fs::last_write_time(watched.drop + "/2.xyz");
  for (const std::string name : {"1.xyz", "3.xyz"}) {
    watched.put(name, name == "1.xyz" ? south : flat);
    fs::last_write_time(watched.drop + "/" + name, time);
  }
  const RunningProgram program(watched.folder, watched.once());
  file.change(north.substr(half));
  const ProgramRun run = program.wait();
  EXPECT_EQ(count(run.out, "\n1.xyz, 2.xyz, 3.xyz: "), 1U) << run.out;
  EXPECT_EQ(count(run.out, "3 clouds applied, 0 refused"), 1U) << run.out;
}

}  // namespace
}  // namespace cocoon::test
