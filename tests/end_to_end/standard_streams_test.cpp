// Standard output and standard error that are closed, full, or a pipe without a reader.
#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>
#include <vector>

#include "tests/run_program.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

using Names = std::vector<std::string>;

void fill(int stream) { dup2(open("/dev/full", O_WRONLY), stream); }
void leave_unread(int stream) {
  int ends[2];
  if (pipe(ends) != 0) _exit(126);
  close(ends[0]);
  dup2(ends[1], stream);
}

class StandardStreams : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string cloud_ = folder_.write("cloud.xyz", whole_sphere(300));
  std::string mesh_ = folder_.write("mesh.ply", tetrahedron_ply);
  std::string target_ = folder_.write("out.ply", "what was there before");

  void expect_only(const std::string& content) const {
    EXPECT_TRUE(content_of(target_) == content);
    EXPECT_EQ(folder_.names(), (Names{"cloud.xyz", "mesh.ply", "out.ply"}));
  }
};

TEST_F(StandardStreams, OutputThatCannotBeWrittenIsAnError) {
  const std::vector<Names> commands = {{"--help"},
                                       {"--version"},
                                       {"check", mesh_},
                                       {"check", mesh_, "--json", "-"},
                                       {"compare", mesh_, cloud_},
                                       {"reconstruct", cloud_, "-o", target_},
                                       {"reconstruct", cloud_, "-o", target_, "--json", "-"}};
  for (const Names& command : commands) {
    SCOPED_TRACE(command[0]);
    expect_error(run_program(command, [] { fill(STDOUT_FILENO); }), 1,
                 "standard output: cannot be written (No space left on device)");
    expect_error(run_program(command, [] { close(STDOUT_FILENO); }), 1,
                 "standard output: cannot be written (Bad file descriptor)");
    expect_only("what was there before");
  }
}

TEST_F(StandardStreams, AReaderThatHasGoneIsNoFailure) {
  const std::string expected_file = folder_.file("expected.ply");
  ASSERT_EQ(run_program({"reconstruct", cloud_, "-o", expected_file}).exit_code, 0);
  const std::string expected = content_of(expected_file);
  std::filesystem::remove(expected_file);
  const ProgramRun run = run_program({"reconstruct", cloud_, "-o", target_, "--json", "-"},
                                     [] { leave_unread(STDOUT_FILENO); });
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.signal, 0);
  expect_only(expected);
}

// Errors that nobody can read do not change the exit code, and go into no file.
TEST_F(StandardStreams, ErrorsThatCannotBeWrittenKeepTheExitCode) {
  const std::vector<void (*)()> limits = {[] { fill(STDERR_FILENO); },
                                          [] { leave_unread(STDERR_FILENO); },
                                          [] { close(STDERR_FILENO); },
                                          [] {
                                            close(STDIN_FILENO);
                                            close(STDOUT_FILENO);
                                            close(STDERR_FILENO);
                                          }};
  const std::string flat = folder_.write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  for (void (*const limit)() : limits) {
    EXPECT_EQ(run_program({"reconstruct", flat, "-o", target_, "--quiet"}, limit).exit_code, 1);
    EXPECT_EQ(run_program({"reconstruct"}, limit).exit_code, 2);
    const Names good = {"reconstruct",           cloud_,    "-o",
                        folder_.file("new.ply"), "--quiet", "--progress"};
    const ProgramRun run = run_program(good, limit);
    EXPECT_EQ(run.exit_code, 0) << run.signal;
    EXPECT_EQ(run_program({"check", folder_.file("new.ply"), "--require", "closed"}).exit_code, 0);
    std::filesystem::remove(folder_.file("new.ply"));
  }
  std::filesystem::remove(flat);
  expect_only("what was there before");
}

// A log that the shell opened for appending keeps what was in it, and gets all of the output.
TEST_F(StandardStreams, OutputsToAStreamByItsNameDoNotReplaceItsFile) {
  const std::string log = folder_.write("log", "old\n");
  std::filesystem::create_symlink("/dev/stdout", folder_.file("link.ply"));
  setenv("COCOON_TEST_LOG", log.c_str(), 1);
  const auto append = [] {
    dup2(open(getenv("COCOON_TEST_LOG"), O_WRONLY | O_APPEND), STDOUT_FILENO);
  };
  ASSERT_EQ(run_program({"check", mesh_, "--json", "/dev/stdout"}, append).exit_code, 0);
  const std::string checked = content_of(log);
  ASSERT_EQ(checked.rfind("old\n{", 0), 0U) << checked;
  EXPECT_TRUE(nlohmann::json::accept(checked.substr(4)));
  const Names into_link = {"reconstruct", cloud_, "-o", folder_.file("link.ply")};
  ASSERT_EQ(run_program(into_link, append).exit_code, 0);
  EXPECT_EQ(content_of(log).rfind(checked + "ply\nformat", 0), 0U);
}

// Programs that read it would take the summary for a part of it.
TEST_F(StandardStreams, AnOutputThereIsAllThereIs) {
  std::filesystem::create_symlink("/dev/stdout", folder_.file("link.ply"));
  ASSERT_EQ(run_program({"reconstruct", cloud_, "-o", target_}).exit_code, 0);
  EXPECT_EQ(run_program({"reconstruct", cloud_, "-o", folder_.file("link.ply")}).out,
            content_of(target_));
  EXPECT_TRUE(nlohmann::json::accept(run_program({"check", target_, "--json", "/dev/stdout"}).out));
}

TEST_F(StandardStreams, MapAndPageMayGoThere) {
  const std::string cap = folder_.write("cap.xyz", sphere_cap(6000, 0.8, 0.3));
  const std::string model = folder_.write("model.xyz", whole_sphere(1500));
  const ProgramRun map = run_program({"update", model, cap, "-o", target_, "--map", "-"});
  ASSERT_EQ(map.exit_code, 0) << map.error;
  EXPECT_EQ(std::count(map.out.begin(), map.out.end(), '\n'), 1500);
  EXPECT_EQ(map.out.find_first_not_of("-0123456789\n"), std::string::npos) << map.out;
  const ProgramRun page = run_program({"update", model, cap, "-o", target_, "--html", "-"});
  EXPECT_EQ(page.out.rfind("<!", 0), 0U) << page.out.substr(0, 80);
  expect_error(run_program({"update", model, cap, "-o", target_, "--html", "-", "--json", "-"}), 2,
               "two outputs cannot be the same file");
  expect_error(run_program({"reconstruct", cloud_, "-o", "-"}), 2, "ln -s /dev/stdout out.ply");
  expect_error(run_program({"reconstruct", cloud_, "-o", target_, "--session", "-"}), 2,
               "-: this is kept in a file; name one");
  expect_error(run_program({"sample", "block", "-o", "-"}), 2,
               "-: several files are written, to a folder; name one");
}

// Where standard error is no terminal nothing but errors goes there.
TEST_F(StandardStreams, WhoReadsOnlyTheFirstLinesOfAMapGetsTheMesh) {
  const std::string cap = folder_.write("cap.xyz", sphere_cap(6000, 0.8, 0.3) + "nan 0 0\n");
  const Names command = {"update", folder_.write("model.xyz", whole_sphere(1500)),
                         cap,      "-o",
                         target_,  "--map",
                         "-",      "--skip-non-finite"};
  const ProgramRun run = run_program(command);
  EXPECT_EQ(run.error, "");
  EXPECT_EQ(run.out.find_first_not_of("-0123456789\n"), std::string::npos) << run.out;
  const std::string expected = content_of(target_);
  for (const char* output : {"--map", "--html"}) {
    folder_.write("out.ply", "what was there before");
    Names to_nobody = command;
    to_nobody[5] = output;
    const ProgramRun unread = run_program(to_nobody, [] { leave_unread(STDOUT_FILENO); });
    EXPECT_EQ(unread.exit_code, 0) << unread.error;
    EXPECT_TRUE(content_of(target_) == expected);
  }
}

// With --quiet, and where an output goes to standard output.
TEST_F(StandardStreams, AFailureTellsTheWarningThatNobodySaw) {
  const std::string flat = folder_.write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\nnan 0 0\n");
  const Names loud = {"reconstruct", flat, "-o", target_, "--skip-non-finite"};
  const std::string warning = flat + ": 1 point is not finite and was left out";
  const ProgramRun seen = run_program(loud);
  EXPECT_EQ(seen.exit_code, 1);
  EXPECT_EQ(seen.out, "warning: " + warning + "\n");
  EXPECT_EQ(seen.error.find("warning"), std::string::npos) << seen.error;
  for (const Names& silence : {Names{"--quiet"}, Names{"--json", "-"}}) {
    Names command = loud;
    command.insert(command.end(), silence.begin(), silence.end());
    expect_error(run_program(command), 1, " (warning: " + warning + ")\n");
  }
}

// One of several outputs that cannot be written: the others are not touched, either.
TEST_F(StandardStreams, OutputsAppearTogether) {
  expect_error(
      run_program({"reconstruct", cloud_, "-o", target_, "--quiet", "--json", "/dev/full"}), 1,
      "/dev/full: cannot be written (No space left on device)");
  expect_only("what was there before");
}

}  // namespace
}  // namespace cocoon::test
