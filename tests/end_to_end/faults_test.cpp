// What goes wrong outside of the program: full disks, memory limits, targets that cannot be
// written, kills. The old output stays, nothing of ours stays beside it, one line says what
// happened.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/resource.h>
#include <thread>
#include <utility>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Names = std::vector<std::string>;

void limit_to(int resource, std::size_t amount) {
  const rlimit limit{amount, amount};
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

// A folder with a cloud and an old output.
struct OldOutput {
  TemporaryFolder folder;
  std::string cloud;
  std::string target;

  explicit OldOutput(std::size_t points)
      : cloud(folder.write("cloud.xyz", whole_sphere(points))),
        target(folder.write("out.ply", "what was there before")) {}

  void expect_untouched() const {
    EXPECT_TRUE(content_of(target) == "what was there before");
    EXPECT_EQ(folder.names(), (Names{"cloud.xyz", "out.ply"}));
  }
};

// The disk, or a quota, is full after some bytes.
TEST(Faults, AFullDiskLeavesTheOldFile) {
  const OldOutput old(3000);
  const auto limit = [] { limit_to(RLIMIT_FSIZE, 100000); };
  for (const std::string command : {"reconstruct", "boundary"}) {
    expect_error(run_program({command, old.cloud, "-o", old.target, "--quiet"}, limit), 1,
                 old.target + ": cannot be written (File too large); check the folder");
    old.expect_untouched();
  }
  const std::string cells = old.folder.file("cells.vtu");
  expect_error(run_program({"delaunay", old.cloud, "-o", cells, "--quiet"}, limit), 1, cells);
  old.expect_untouched();
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool address_space_can_be_limited = false;  // the sanitizers take terabytes of it
#else
constexpr bool address_space_can_be_limited = true;
#endif

TEST(Faults, MemoryThatRunsOutIsSaid) {
  if (!address_space_can_be_limited) GTEST_SKIP() << "a sanitizer owns the address space";
  const OldOutput old(60000);
  static std::size_t megabytes;  // enough for the threads, and not for their work
  for (const auto& [threads, limit] : {std::pair("1", 36U), std::pair("4", 48U)}) {
    megabytes = limit;
    const ProgramRun run =
        run_program({"reconstruct", old.cloud, "-o", old.target, "--threads", threads, "--quiet"},
                    [] { limit_to(RLIMIT_AS, megabytes << 20); });
    expect_error(run, 1, "not enough memory");
    old.expect_untouched();
  }
}

// The kilobytes of address space with which the program can start, and throw: for that the C++
// runtime wants a hundred or two beside what is loaded.
std::size_t least_address_space() {
  static std::size_t kilobytes;
  for (kilobytes = 4'000; kilobytes < 64'000; kilobytes += 100) {
    const ProgramRun run = run_program({"--version"}, [] { limit_to(RLIMIT_AS, kilobytes << 10); });
    if (run.exit_code == 0) break;
  }
  return kilobytes + 500;
}

// However little there is: enough, or one line. Each thread wants some megabytes for its stack.
TEST(Faults, ThreadsThatCannotBeStartedAreSaid) {
  if (!address_space_can_be_limited) GTEST_SKIP() << "a sanitizer owns the address space";
  const OldOutput old(3000);
  static std::size_t kilobytes;
  std::size_t enough = 0;
  std::size_t without_threads = 0;
  for (kilobytes = least_address_space(); kilobytes < 64'000; kilobytes += 500) {
    const ProgramRun run =
        run_program({"reconstruct", old.cloud, "-o", old.target, "--threads", "8", "--quiet"},
                    [] { limit_to(RLIMIT_AS, kilobytes << 10); });
    enough += run.exit_code == 0 ? 1U : 0U;
    if (run.exit_code == 0) continue;
    SCOPED_TRACE(kilobytes);
    const bool threads = run.error.find("thread can be started") != std::string::npos;
    without_threads += threads ? 1U : 0U;
    expect_error(run, 1, threads ? "--threads 1" : "not enough memory");
  }
  EXPECT_GT(enough, 0U);
  EXPECT_GT(without_threads, 0U);
}

TEST(Faults, TargetsThatCannotBeWritten) {
  const OldOutput old(500);
  const Names targets = {old.folder.file("cloud.xyz/out.ply"), old.folder.file("none/out.ply"),
                         "/proc/out.ply"};
  for (const std::string& target : targets) {
    expect_error(run_program({"reconstruct", old.cloud, "-o", target, "--quiet"}), 1, target);
    old.expect_untouched();
  }
}

// Killed at any moment: the output is the old one or the new one, whole.
TEST(Faults, AKillLeavesOneWholeFile) {
  const OldOutput old(4000);
  const std::string whole = old.folder.file("whole.ply");
  ASSERT_EQ(run_program({"reconstruct", old.cloud, "-o", whole, "--quiet"}).exit_code, 0);
  const std::string expected = content_of(whole);
  int killed = 0;
  for (int delay_ms = 0; delay_ms < 400; delay_ms += 20) {
    const TemporaryFolder outputs;
    const RunningProgram program(outputs, {"reconstruct", old.cloud, "-o", old.target, "--quiet"});
    std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
    program.send(SIGKILL);
    killed += program.wait().signal == SIGKILL ? 1 : 0;
    const std::string found = content_of(old.target);
    EXPECT_TRUE(found == "what was there before" || found == expected) << delay_ms;
  }
  EXPECT_GT(killed, 0);
  for (const std::string& name : old.folder.names()) {
    const bool is_ours = name == "cloud.xyz" || name == "out.ply" || name == "whole.ply";
    EXPECT_TRUE(is_ours || name.rfind(".out.ply.cocoon-", 0) == 0) << name;
  }
}

// Several programs at once, on the same files: as if each were alone.
TEST(Faults, ProgramsSideBySideDoNotDisturbEachOther) {
  const OldOutput old(2000);
  const std::string alone = old.folder.file("alone.ply");
  ASSERT_EQ(run_program({"reconstruct", old.cloud, "-o", alone, "--quiet"}).exit_code, 0);
  const TemporaryFolder outputs[8];
  std::vector<RunningProgram> programs;
  for (const TemporaryFolder& folder : outputs) {
    programs.emplace_back(folder,
                          Names{"reconstruct", old.cloud, "-o", folder.file("own.ply"), "--quiet"});
    programs.emplace_back(folder, Names{"reconstruct", old.cloud, "-o", old.target, "--quiet"});
  }
  for (const RunningProgram& program : programs) EXPECT_EQ(program.wait().exit_code, 0);
  const std::string expected = content_of(alone);
  for (const TemporaryFolder& folder : outputs) {
    EXPECT_TRUE(content_of(folder.file("own.ply")) == expected);
  }
  EXPECT_TRUE(content_of(old.target) == expected);
  EXPECT_EQ(old.folder.names(), (Names{"alone.ply", "cloud.xyz", "out.ply"}));
}

TEST(Faults, VerifiedResultsSaySo) {
  const OldOutput old(500);
  const std::string cap = old.folder.write("cap.xyz", sphere_cap(800, 1.2, 0.05));
  const auto verification = [](Names arguments) {
    arguments.insert(arguments.end(), {"--verify", "--json", "-"});
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.error;
    return nlohmann::json::parse(run.out)["verification"];
  };
  EXPECT_EQ(verification({"reconstruct", old.cloud, "-o", old.target})["triangles"], 2 * 500 - 4);
  EXPECT_EQ(verification({"boundary", cap, "-o", old.folder.file("cap.ply")})["ok"], true);
  EXPECT_EQ(verification({"delaunay", old.cloud, "-o", old.folder.file("cells.tet")})["ok"], true);
  EXPECT_EQ(verification({"update", old.target, cap, "-o", old.folder.file("new.ply")})["ok"],
            true);
}

}  // namespace
}  // namespace cocoon::test
