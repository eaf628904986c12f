#include "io/lock_file.h"

#include <csignal>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include "geom/errors.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

constexpr const char* in_use =
    ": is in use by another run of cocoon; wait until that is done, or stop it";

TEST(LockFile, KeepsOthersOutUntilItEnds) {
  const TemporaryFolder folder;
  auto lock = std::make_unique<LockFile>(folder / "a");
  EXPECT_TRUE(std::filesystem::exists(folder / "a.lock"));
  EXPECT_EQ(message_of<FileError>(folder / "a", [&] { LockFile(folder / "a"); }), in_use);
  const LockFile other(folder / "b");
  lock.reset();
  EXPECT_FALSE(std::filesystem::exists(folder / "a.lock"));
  const LockFile again(folder / "a");
  EXPECT_EQ(message_of<FileError>(folder / "a", [&] { LockFile(folder / "a"); }), in_use);
}

// Nobody has to remove anything by hand.
TEST(LockFile, OfAKilledProcessIsTakenOver) {
  const TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const LockFile lock(folder / "a");
    [[maybe_unused]] const ssize_t told = ::write(ready[1], "x", 1);
    for (;;) ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_EQ(message_of<FileError>(folder / "a", [&] { LockFile(folder / "a"); }), in_use);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "a.lock"));
  { const LockFile lock(folder / "a"); }
  EXPECT_EQ(folder.names().size(), 0U);
}

// Programs of other people call files so, too.
TEST(LockFile, OfSomebodyElseIsLeftAlone) {
  const TemporaryFolder folder;
  folder.write("poetry.lock", "what somebody needs");
  folder.write("other", "");
  std::filesystem::create_symlink("other", folder / "link.lock");
  for (const char* name : {"poetry", "link"}) {
    const std::string message =
        message_of<FileError>(folder / name, [&] { LockFile(folder / name); });
    EXPECT_NE(message.find(std::string(name) + ".lock beside it, which is there and no lock"),
              std::string::npos)
        << message;
  }
  EXPECT_EQ(content_of(folder.file("poetry.lock")), "what somebody needs");
  EXPECT_EQ(folder.names().size(), 3U);
}

// Also if the file does not exist yet.
TEST(LockFile, IsOnTheFileBehindSymbolicLinks) {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  std::filesystem::create_symlink(folder / "link", elsewhere / "link to link");
  std::filesystem::create_symlink("file", folder / "link");
  for (const std::filesystem::path& name : {folder / "file", elsewhere / "link to link"}) {
    const LockFile lock(name);
    EXPECT_TRUE(std::filesystem::exists(folder / "file.lock"));
    for (const std::filesystem::path& other :
         {folder / "file", folder / "link", elsewhere / "link to link"}) {
      EXPECT_EQ(message_of<FileError>(other, [&] { const LockFile second(other); }), in_use);
    }
  }
  EXPECT_EQ(elsewhere.names().size(), 1U);
}

TEST(LockFile, FoldersThatAreMissingAreNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(message_of<FileError>(folder / "no/a", [&] { LockFile(folder / "no/a"); }),
            ": cannot be locked by a.lock beside it (No such file or directory); check the folder "
            "and its permissions");
}

}  // namespace
}  // namespace cocoon
