// A disk that is full, for every command that writes: all of its outputs appear, or none of them;
// then the old files are as they were, nothing of ours stays, and one line says why.
//
// The disk is a memory file system of 1 MB, mounted where only a child process sees it. Who may not
// mount one skips these tests; faults_test.cpp has a limit on the size of files instead.
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sched.h>
#include <string>
#include <sys/mount.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Names = std::vector<std::string>;
namespace fs = std::filesystem;

constexpr int cannot_mount = 77;

// Mounts the disk for this process and its children alone: as root, or as the root of a user
// namespace of its own.
bool mount_small_disk(const std::string& folder) {
  if (unshare(CLONE_NEWNS) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
  if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  return mount("cocoon-test", folder.c_str(), "tmpfs", 0, "size=1m") == 0;
}

// Inputs on a large disk, and a folder that becomes the small one.
struct Disks {
  TemporaryFolder large;
  TemporaryFolder small;
  std::string points = large.write("points.xyz", whole_sphere(1200));
  std::string cloud = large.write("cloud.xyz", sphere_cap(2400, 0.8, 0.2));
  std::string model = large.file("model.ply");
  std::string session = large.file("model.session");
};

// Runs `body` where disks.small is a small disk; its failures are this test's.
template <class Body>
void on_small_disk(const Disks& disks, const Body& body) {
  const pid_t child = fork();
  if (child == 0) {
    if (!mount_small_disk(disks.small.file(""))) _exit(cannot_mount);
    body();
    std::fflush(stdout);
    _exit(testing::Test::HasFailure() ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == cannot_mount) {
    GTEST_SKIP() << "this user may not mount a file system";
  }
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "see the failures above";
}

// A command and the files that it writes on the small disk; "SMALL/" begins their names.
struct Writing {
  Names arguments;
  Names outputs;
};

std::vector<Writing> all_writings(const Disks& disks) {
  std::vector<Writing> all;
  for (const std::string name : {"a.ply", "a.obj", "a.off", "a.stl"}) {
    for (const std::string option : {"--quiet", "--ascii"}) {
      all.push_back({{"reconstruct", disks.points, "-o", "SMALL/" + name, option}, {name}});
    }
  }
  for (const std::string name : {"a.tet", "a.mesh", "a.vtu"}) {
    all.push_back({{"delaunay", disks.points, "-o", "SMALL/" + name, "--json", "SMALL/r.json"},
                   {name, "r.json"}});
  }
  all.push_back({{"reconstruct", disks.points, "-o", "SMALL/a.ply", "--session", "SMALL/s.session",
                  "--json", "SMALL/r.json"},
                 {"a.ply", "s.session", "r.json"}});
  all.push_back({{"boundary", disks.cloud, "-o", "SMALL/a.ply", "--loops", "SMALL/l.obj", "--json",
                  "SMALL/r.json"},
                 {"a.ply", "l.obj", "r.json"}});
  all.push_back({{"update", disks.model, disks.cloud, "-o", "SMALL/a.ply", "--map", "SMALL/m.txt",
                  "--html", "SMALL/p.html", "--json", "SMALL/r.json"},
                 {"a.ply", "m.txt", "p.html", "r.json"}});
  all.push_back({{"sample", "block", "-o", "SMALL/", "--points", "2000"},
                 {"initial.xyz", "cloud-1.xyz", "truth.ply", "replaced.txt"}});
  all.push_back({{"demo", "-o", "SMALL/"},
                 {"initial.ply", "cloud.ply", "updated.ply", "report.html", "report.json"}});
  all.push_back({{"check", disks.model, "--json", "SMALL/r.json"}, {"r.json"}});
  all.push_back({{"compare", disks.model, disks.cloud, "--json", "SMALL/r.json"}, {"r.json"}});
  return all;
}

// Fills the disk until `left` bytes are free (whole pages: what a file takes).
void fill_disk(const std::string& folder, std::size_t left) {
  struct statvfs disk = {};
  ASSERT_EQ(statvfs(folder.c_str(), &disk), 0);
  const std::size_t free = disk.f_bavail * disk.f_bsize;
  ASSERT_GE(free, left);
  std::ofstream(fs::path(folder) / "filler", std::ios::binary) << std::string(free - left, 'f');
}

std::map<std::string, std::string> contents_of(const std::string& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::directory_iterator(folder)) {
    contents[entry.path().filename().string()] = content_of(entry.path().string());
  }
  return contents;
}

void make_model(const Disks& disks) {
  const ProgramRun run = run_program(
      {"reconstruct", disks.points, "-o", disks.model, "--session", disks.session, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
}

// True if the command succeeded with `left` bytes free.
bool all_or_nothing(const std::string& folder, const Writing& writing, std::size_t left) {
  SCOPED_TRACE(writing.arguments[0] + " " + writing.outputs[0] + ", free: " + std::to_string(left));
  for (const auto& entry : fs::directory_iterator(folder)) fs::remove_all(entry.path());
  for (const std::string& name : writing.outputs) {
    std::ofstream(fs::path(folder) / name) << "what was there before";
  }
  fill_disk(folder, left);
  const std::map<std::string, std::string> before = contents_of(folder);
  Names arguments = writing.arguments;
  for (std::string& argument : arguments) {
    if (argument.starts_with("SMALL/")) argument = folder + argument.substr(6);
  }
  const ProgramRun run = run_program(arguments);
  std::map<std::string, std::string> after = contents_of(folder);
  if (run.exit_code == 0) {
    EXPECT_EQ(after.size(), before.size());
    for (const std::string& name : writing.outputs) {
      EXPECT_NE(after[name], "what was there before") << name;
    }
    return true;
  }
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.error.rfind("cocoon: " + folder, 0), 0U) << run.error;
  EXPECT_NE(run.error.find("cannot be written (No space left on device)"), std::string::npos)
      << run.error;
  EXPECT_EQ(run.error.find('\n'), run.error.size() - 1) << run.error;
  EXPECT_TRUE(after == before) << "files changed, or new ones stayed";
  return false;
}

TEST(FullDisk, EveryCommandWritesAllOrNothing) {
  const Disks disks;
  make_model(disks);
  on_small_disk(disks, [&] {
    std::size_t completed = 0;
    const std::vector<Writing> writings = all_writings(disks);
    for (const Writing& writing : writings) {
      EXPECT_FALSE(all_or_nothing(disks.small.file(""), writing, 0));
      for (const unsigned pages : {1U, 3U, 10U, 30U, 100U, 230U}) {
        if (!all_or_nothing(disks.small.file(""), writing, pages * 4096U)) continue;
        ++completed;
        break;
      }
    }
    EXPECT_EQ(completed, writings.size() - 2);  // a sample and the demo take more than the disk
  });
}

// The session is an input as well, so that the old one must stay good.
TEST(FullDisk, SessionsAndWatchedMeshesStayTogether) {
  const Disks disks;
  make_model(disks);
  const Names updating = {"update",    "--session", disks.small.file("s.session"),
                          disks.cloud, "-o",        disks.small.file("a.ply")};
  const std::string clouds = disks.large.file("clouds");
  fs::create_directory(clouds);
  fs::copy_file(disks.cloud, clouds + "/a.xyz");
  const Names watching = {"watch",
                          disks.model,
                          clouds,
                          "-o",
                          disks.small.file("a.ply"),
                          "--session",
                          disks.small.file("s.session"),
                          "--once"};
  on_small_disk(disks, [&] {
    for (const Names& arguments : {updating, watching}) {
      SCOPED_TRACE(arguments[0]);
      const std::string folder = disks.small.file("");
      fs::remove(folder + "filler");
      fs::remove(folder + "s.session");
      if (arguments == watching) {
        fs::create_directory(disks.large.file("none"));
        Names begin = watching;
        begin[2] = disks.large.file("none");
        ASSERT_EQ(run_program(begin).exit_code, 0);
      } else {
        fs::copy_file(disks.session, folder + "s.session");
      }
      fill_disk(folder, (arguments == watching ? 20 : 150) * 1024);
      const std::map<std::string, std::string> before = contents_of(folder);
      const ProgramRun failed = run_program(arguments);
      EXPECT_EQ(failed.exit_code, 1);
      EXPECT_NE(failed.error.find("No space left on device"), std::string::npos) << failed.error;
      EXPECT_TRUE(contents_of(folder) == before);
      fs::remove(folder + "filler");
      const ProgramRun again = run_program(arguments);
      EXPECT_EQ(again.exit_code, 0) << again.error;
      EXPECT_EQ(contents_of(folder).size(), 2U);
    }
  });
}

// Room for a cloud and the mesh, but not for the whole session: what was applied is not lost.
TEST(FullDisk, AWatchedCloudIsKeptWhereTheSessionHasNoRoom) {
  const Disks disks;
  make_model(disks);
  const std::string clouds = disks.large.file("clouds");
  const std::string none = disks.large.file("none");
  fs::create_directory(clouds);
  fs::create_directory(none);
  fs::copy_file(disks.cloud, clouds + "/a.xyz");
  on_small_disk(disks, [&] {
    const std::string mesh = disks.small.file("a.ply");
    const std::string session = disks.small.file("s.session");
    const auto watch = [&](const std::string& folder) {
      return run_program(
          {"watch", disks.model, folder, "-o", mesh, "--session", session, "--once"});
    };
    ASSERT_EQ(watch(none).exit_code, 0);
    fill_disk(disks.small.file(""), 150 * 1024);
    const std::string before = content_of(session);
    const ProgramRun full = watch(clouds);
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_NE(full.error.find("No space left on device"), std::string::npos) << full.error;
    EXPECT_EQ(content_of(session), before);
    EXPECT_TRUE(fs::exists(session + ".cloud-1"));
    const std::string updated = content_of(mesh);
    fs::remove(disks.small.file("filler"));
    const ProgramRun again = watch(clouds);
    EXPECT_EQ(again.exit_code, 0) << again.error;
    EXPECT_NE(again.out.find("0 clouds applied, 0 refused, 1 known"), std::string::npos);
    EXPECT_EQ(content_of(mesh), updated);
    EXPECT_FALSE(fs::exists(session + ".cloud-1"));
  });
}

}  // namespace
}  // namespace cocoon::test
