#include "app/files/files.h"

#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

#include "geom/errors.h"
#include "tests/temporary_folder.h"

namespace cocoon::app {
namespace {

// What the shell has opened (/dev/stdout) is written as it is, wherever that lies: here nowhere.
TEST(RequireOutputs, OpenDescriptorsNeedNoFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "logs");
  const std::string log = folder.write("logs/log.txt", "");
  const int descriptor = open(log.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  std::filesystem::remove_all(folder / "logs");
  const std::string name = "/dev/fd/" + std::to_string(descriptor);
  const std::string link = (folder / "link.txt").string();
  std::filesystem::create_symlink(name, link);
  Job job("check", {});
  EXPECT_THROW(require_outputs(job, {{log}}), FileError);
  EXPECT_NO_THROW(require_outputs(job, {{name}}));
  EXPECT_NO_THROW(require_outputs(job, {{link}}));
  EXPECT_THROW(require_outputs(job, {{name}, {link}}), UsageError);
  close(descriptor);
}

}  // namespace
}  // namespace cocoon::app
