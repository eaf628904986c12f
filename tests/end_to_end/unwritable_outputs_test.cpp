// Outputs that cannot be written are told before the work: no stage has run then.
#include <filesystem>
#include <gtest/gtest.h>
#include <sched.h>
#include <string>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "tests/file_permissions.h"
#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

struct UnwritableOutputs : testing::Test {
  TemporaryFolder folder;
  std::string points = folder.write("points.xyz", whole_sphere(500));
  std::string cap = folder.write("cap.xyz", sphere_cap(2000, 0.8, 0.3));
  std::string good = folder.file("good.ply");

  // Many ways to name an output, which has the extension of a mesh.
  std::vector<Names> writings(const std::string& output) const {
    return {{"reconstruct", points, "-o", output},
            {"reconstruct", points, "-o", good, "--json", output},
            {"reconstruct", points, "-o", good, "--session", output},
            {"boundary", cap, "-o", output},
            {"update", points, cap, "-o", output},
            {"update", points, cap, "-o", good, "--map", output},
            {"update", points, cap, "-o", good, "--html", output},
            {"watch", points, folder.file(""), "-o", output, "--once"},
            {"check", points, "--json", output},
            {"sample", "block", "-o", folder.file("block"), "--json", output},
            {"demo", "-o", folder.file("demo"), "--json", output}};
  }

  // Each stage that is done would add a line.
  static void expect_told_first(Names arguments, const std::string& message,
                                void (*limit)() = obey_permissions) {
    SCOPED_TRACE(arguments[0] + " " + arguments[3]);
    arguments.emplace_back("--progress");
    expect_error(run_program(arguments, limit), 1, message);
  }
};

TEST_F(UnwritableOutputs, LinksIntoMissingFolders) {
  const std::string link = folder.file("link.ply");
  fs::create_symlink("nowhere/mesh.ply", link);
  for (const Names& arguments : writings(link)) {
    expect_told_first(arguments, link + ": is a link to " + folder.file("nowhere/mesh.ply") +
                                     ", but there is no folder " + folder.file("nowhere") +
                                     "; make it first");
  }
  EXPECT_FALSE(fs::exists(good));
  EXPECT_FALSE(fs::exists(folder.file("block")));  // nor is an empty folder left behind
  EXPECT_FALSE(fs::exists(folder.file("demo")));
}

// To replace a file needs its folder, not the file.
TEST_F(UnwritableOutputs, FilesInFoldersThatAreNot) {
  if (!permissions_can_be_obeyed()) GTEST_SKIP() << "root cannot give up its rights here";
  const std::string locked = folder.file("locked");
  fs::create_directory(locked);
  const std::string old = folder.write("locked/old.ply", "what was there before");
  fs::create_symlink(old, folder.file("link.ply"));
  fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
  const std::string why =
      ": no file can be written or replaced in " + locked + " (Permission denied)";
  for (const std::string& output : {old, locked + "/new.ply", folder.file("link.ply")}) {
    for (const Names& arguments : writings(output)) expect_told_first(arguments, output + why);
  }
  for (const std::string command : {"demo", "sample"}) {
    Names arguments = {command, "-o", locked};
    if (command == "sample") arguments.insert(arguments.begin() + 1, "block");
    arguments.emplace_back("--progress");
    expect_error(run_program(arguments, obey_permissions), 1, "can be written or replaced in");
  }
  fs::permissions(locked, fs::perms::owner_all);
  EXPECT_EQ(content_of(old), "what was there before");
  EXPECT_FALSE(fs::exists(good));
}

// As in /tmp. The outputs named before such a one would be replaced, and the command fail.
TEST_F(UnwritableOutputs, FilesOfOthersInStickyFolders) {
  constexpr uid_t somebody = 65534;
  if (geteuid() != 0 || !permissions_can_be_obeyed())
    GTEST_SKIP() << "only root can give files away";
  const std::string sticky = folder.file("sticky");
  fs::create_directory(sticky);
  const std::string old = folder.write("sticky/old.ply", "what was there before");
  for (const std::string& name : {sticky, old}) {
    ASSERT_EQ(chown(name.c_str(), somebody, somebody), 0);
  }
  fs::permissions(sticky, fs::perms::all | fs::perms::sticky_bit);
  fs::create_symlink(old, folder.file("link.ply"));
  const auto own_no_others = [] { prctl(PR_CAPBSET_DROP, CAP_FOWNER, 0, 0, 0); };
  for (const std::string& output : {old, folder.file("link.ply")}) {
    for (const Names& arguments : writings(output)) {
      expect_told_first(arguments,
                        output +
                            ": cannot be replaced: it is another user's, in a folder with the "
                            "sticky bit; name another file",
                        own_no_others);
    }
  }
  EXPECT_EQ(content_of(old), "what was there before");
  EXPECT_FALSE(fs::exists(good));
  const std::string fresh = folder.file("sticky/new.ply");
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(run_program({"reconstruct", points, "-o", fresh}, own_no_others).exit_code, 0);
  }
}

std::string mount_point;

// As containers get single files.
TEST_F(UnwritableOutputs, MountPoints) {
  constexpr int cannot_mount = 77;
  mount_point = folder.write("mounted.ply", "what was there before");
  const auto mount_it = [] {
    const bool done =
        (unshare(CLONE_NEWNS) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0) &&
        mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
        mount(mount_point.c_str(), mount_point.c_str(), nullptr, MS_BIND, nullptr) == 0;
    if (!done) _exit(cannot_mount);
  };
  for (const Names& arguments : writings(mount_point)) {
    if (run_program(arguments, mount_it).exit_code == cannot_mount) {
      GTEST_SKIP() << "this user may not mount a file";
    }
    expect_told_first(arguments,
                      mount_point + ": cannot be replaced: it is a mount point; name another file",
                      mount_it);
  }
  EXPECT_EQ(content_of(mount_point), "what was there before");
  EXPECT_FALSE(fs::exists(good));
}

TEST_F(UnwritableOutputs, FoldersThatCannotBe) {
  const std::string below_a_file = folder.file("cap.xyz/block");
  const std::string with_a_folder = folder.file("with");
  fs::create_directories(with_a_folder + "/truth.ply");
  fs::create_directories(with_a_folder + "/updated.ply");
  const std::string not_made = ": cannot make this folder: Not a directory; name another one";
  expect_told_first({"sample", "block", "-o", below_a_file}, below_a_file + not_made);
  expect_told_first({"demo", "--quiet", "-o", below_a_file}, below_a_file + not_made);
  expect_told_first({"sample", "block", "-o", with_a_folder}, "truth.ply: is a folder");
  expect_told_first({"demo", "--quiet", "-o", with_a_folder}, "updated.ply: is a folder");
}

// The report may lie in the folder that is made for it, also in the place that it has anyway.
TEST_F(UnwritableOutputs, AFolderIsMadeForTheReportToo) {
  const std::string made = folder.file("new/block");
  EXPECT_EQ(run_program({"sample", "block", "-o", made, "--points", "600", "--cloud-points", "900",
                         "--json", made + "/report.json"})
                .exit_code,
            0);
  EXPECT_TRUE(fs::exists(made + "/report.json"));
  EXPECT_EQ(run_program({"demo", "-o", made, "--json", made + "/report.json"}).exit_code, 0);
  expect_error(run_program({"demo", "-o", made, "--json", made + "/updated.ply"}), 2,
               "two outputs cannot be the same file");
}

}  // namespace
}  // namespace cocoon::test
