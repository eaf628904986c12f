// Two watchers, each with a session of its own, would write over each other's mesh.
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "tests/end_to_end/watched_folder.h"
#include "tests/run_program.h"

namespace cocoon::test {
namespace {

TEST(WatchLocks, TwoDoNotWriteOneMesh) {
  const Watched watched;
  const TemporaryFolder outputs;
  const RunningProgram program(outputs, watched.arguments);
  ASSERT_TRUE(wait_for([&] { return std::filesystem::exists(watched.mesh); }));
  std::vector<std::string> arguments = watched.once();
  arguments.insert(arguments.end(), {"--session", watched.folder.file("other.session")});
  expect_error(run_program(arguments), 1, watched.mesh + ": is in use by another run");
  EXPECT_FALSE(std::filesystem::exists(watched.folder.file("other.session")));
  program.send(SIGTERM);
  EXPECT_EQ(program.wait().exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(watched.mesh + ".lock"));
  const ProgramRun alone = run_program(arguments);
  EXPECT_EQ(alone.exit_code, 0) << alone.error;
}

}  // namespace
}  // namespace cocoon::test
