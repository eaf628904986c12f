// A program that waits for a pipe ends by a signal, too.
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "tests/run_program.h"
#include "tests/temporary_folder.h"
#include "tests/test_clouds.h"

namespace cocoon::test {
namespace {

class InterruptedPipes : public testing::Test {
 protected:
  // Its path.
  std::string make_pipe(const std::string& name) const {
    const std::string path = folder_.file(name);
    EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
    return path;
  }

  // One that waits until somebody opens the other end.
  ProgramRun interrupted_while_it_opens(const std::vector<std::string>& arguments) const {
    const RunningProgram program(outputs_, arguments);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    program.send(SIGTERM);
    return program.wait();
  }

  TemporaryFolder folder_;
  TemporaryFolder outputs_;
};

TEST_F(InterruptedPipes, ThatNobodyWritesOrReadsAreGivenUp) {
  const std::string out = folder_.file("out.ply");
  const ProgramRun reading =
      interrupted_while_it_opens({"reconstruct", make_pipe("in.xyz"), "-o", out});
  EXPECT_EQ(reading.signal, SIGTERM) << reading.error;
  EXPECT_EQ(reading.error.find("Interrupted system call"), std::string::npos) << reading.error;
  const std::string cloud = folder_.write("cloud.xyz", whole_sphere(200));
  const ProgramRun writing = interrupted_while_it_opens(
      {"reconstruct", cloud, "-o", out, "--json", make_pipe("report.json")});
  EXPECT_EQ(writing.signal, SIGTERM) << writing.error;
  EXPECT_FALSE(std::filesystem::exists(out));
}

// It reads its model again when it resumes.
TEST_F(InterruptedPipes, WatchTakesNone) {
  std::filesystem::create_directory(folder_ / "scans");
  const std::string model = make_pipe("model.xyz");
  const ProgramRun run =
      run_program({"watch", model, folder_.file("scans"), "-o", folder_.file("live.ply")});
  EXPECT_EQ(run.exit_code, 1) << run.error;
  EXPECT_EQ(run.error.find("cocoon: " + model + ": is no regular file"), 0U) << run.error;
}

// Whichever the second signal is.
TEST_F(InterruptedPipes, ASecondSignalEndsTheWaitForMore) {
  const std::string pipe = make_pipe("in.xyz");
  const RunningProgram program(outputs_, {"reconstruct", pipe, "-o", folder_.file("out.ply")});
  const int writer = ::open(pipe.c_str(), O_WRONLY);  // waits until the program reads
  ASSERT_GE(writer, 0);
  program.send(SIGTERM);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  program.send(SIGINT);
  EXPECT_EQ(program.wait().signal, SIGINT);
  ::close(writer);
}

}  // namespace
}  // namespace cocoon::test
