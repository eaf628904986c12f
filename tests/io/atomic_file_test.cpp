#include "io/atomic_file.h"

#include <csignal>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "geom/errors.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

unsigned permissions_of(const std::filesystem::path& path) {
  struct stat status = {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0);
  return status.st_mode & 0777U;
}

// Runs `action` in a child process, whose rights and limits it may give up for good.
template <class Action>
int exit_code_of_child(const Action& action) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(action());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(AtomicFile, AppearsCompleteAndAlone) {
  const TemporaryFolder folder;
  const std::string content(1'000'003, 'x');
  {
    AtomicFile file(folder / "a.txt");
    file.write(content);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    file.commit();
  }
  EXPECT_EQ(content_of(folder / "a.txt"), content);
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(AtomicFile, AnExceptionInTheMiddleLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  const auto write_half = [&] {
    AtomicFile file(folder / "a.txt");
    file.write(std::string(1'000'000, 'x'));
    throw std::runtime_error("interrupted");
  };
  EXPECT_THROW(write_half(), std::runtime_error);
  EXPECT_EQ(content_of(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names().size(), 1U);
}

// Where the file system has no files without a name, it does not hold.
TEST(AtomicFile, AKilledProcessLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  const int probe = ::open(folder.path().c_str(), O_WRONLY | O_TMPFILE, 0600);
  if (probe < 0) GTEST_SKIP() << "no files without a name here";
  ::close(probe);
  const pid_t child = ::fork();
  if (child == 0) {
    FileBatch batch;
    write_file(folder / "b.txt", "complete, but not in its place", &batch);
    AtomicFile file(folder / "a.txt");
    file.write(std::string(1'000'000, 'x'));
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(content_of(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(AtomicFile, NewFilesFollowTheUmaskAndReplacedOnesKeepTheirPermissions) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_file(folder / "new.txt", "x");
  ::umask(before);
  EXPECT_EQ(permissions_of(folder / "new.txt"), 0640U);
  folder.write("old.txt", "old");
  ASSERT_EQ(::chmod((folder / "old.txt").c_str(), 0604), 0);
  write_file(folder / "old.txt", "x");
  EXPECT_EQ(permissions_of(folder / "old.txt"), 0604U);
}

TEST(AtomicFile, SymbolicLinksStay) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "real");
  folder.write("real/a.txt", "old");
  std::filesystem::create_symlink("real/a.txt", folder / "link.txt");
  std::filesystem::create_symlink("real/new.txt", folder / "dangling.txt");
  write_file(folder / "link.txt", "new");
  write_file(folder / "dangling.txt", "made");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(content_of(folder / "real/a.txt"), "new");
  EXPECT_EQ(content_of(folder / "real/new.txt"), "made");
  std::filesystem::create_symlink("loop.txt", folder / "loop.txt");
  EXPECT_THROW(write_file(folder / "loop.txt", "x"), FileError);
}

TEST(AtomicFile, FoldersThatAreMissingOrNotWritableAreNamedInOneLine) {
  const TemporaryFolder folder;
  const auto missing = folder / "no/such/a.txt";
  EXPECT_EQ(
      message_of<FileError>(missing, [&] { write_file(missing, "x"); }),
      ": cannot be written (No such file or directory); check the folder, its permissions and "
      "the free space");
  EXPECT_EQ(message_of<FileError>(folder.path(), [&] { write_file(folder.path(), "x"); }),
            ": cannot be written (Is a directory); check the folder, its permissions and the free "
            "space");
}

TEST(AtomicFile, AFolderThatIsNotWritableKeepsTheOldFile) {
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  std::filesystem::create_directory(folder / "locked");
  folder.write("locked/a.txt", "old");
  std::filesystem::permissions(folder / "locked", std::filesystem::perms(0555));
  const int code = exit_code_of_child([&] {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && ::setuid(nobody) != 0) ::_exit(1);  // root may write everywhere
    const std::string message = message_of<FileError>(
        folder / "locked/a.txt", [&] { write_file(folder / "locked/a.txt", "x"); });
    return message.starts_with(": cannot be written (Permission denied)") ? 7 : 2;
  });
  EXPECT_EQ(code, 7);
  EXPECT_EQ(content_of(folder / "locked/a.txt"), "old");
  std::filesystem::permissions(folder / "locked", std::filesystem::perms(0755));
}

TEST(AtomicFile, AFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_EQ(message_of<FileError>("/dev/full", [] { write_file("/dev/full", "x"); }),
            ": cannot be written (No space left on device); check the folder, its permissions and "
            "the free space");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));  // not replaced
}

// As `>> log` of a shell: the file that a descriptor leads to is not replaced.
TEST(AtomicFile, DescriptorsOfThisProcessAreWrittenWhereTheyStand) {
  if (!std::filesystem::exists("/proc/self/fd")) GTEST_SKIP() << "no names of descriptors";
  const TemporaryFolder folder;
  folder.write("log", "old,");
  const int descriptor = ::open((folder / "log").c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(descriptor, 0);
  const std::string number = std::to_string(descriptor);
  std::filesystem::create_symlink("/dev/fd/" + number, folder / "link");
  std::filesystem::create_symlink("link", folder / "link to link");
  FileBatch batch;
  write_file("/dev/fd/" + number, "1,");
  write_file("/proc/self/fd/" + number, "2,");
  write_file("/proc/thread-self/fd/" + number, "3,");
  write_file("/proc/" + std::to_string(::getpid()) + "/fd/" + number, "4,");
  write_file(folder / "link", "5,");
  write_file(folder / "link to link", "6,", &batch);
  batch.commit();
  EXPECT_EQ(::write(descriptor, "7", 1), 1);
  ::close(descriptor);
  EXPECT_EQ(content_of(folder / "log"), "old,1,2,3,4,5,6,7");
  EXPECT_EQ(
      message_of<FileError>("/dev/fd/" + number, [&] { write_file("/dev/fd/" + number, "x"); }),
      ": cannot be written (Bad file descriptor); check the folder, its permissions and the "
      "free space");
}

TEST(FileBatch, FilesAppearTogether) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  FileBatch batch;
  write_file(folder / "a.txt", "new", &batch);
  write_file(folder / "b.txt", "also new", &batch);
  EXPECT_EQ(content_of(folder / "a.txt"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "b.txt"));
  batch.commit();
  EXPECT_EQ(content_of(folder / "a.txt"), "new");
  EXPECT_EQ(content_of(folder / "b.txt"), "also new");
  EXPECT_EQ(folder.names().size(), 2U);
}

TEST(FileBatch, WithoutCommitNothingStays) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    FileBatch batch;
    write_file(folder / "a.txt", "new", &batch);
    EXPECT_EQ(content_of(folder / "a.txt"), "old");
  }
  EXPECT_EQ(content_of(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(FileBatch, ATargetThatCannotBeReplacedIsNamedAndLeavesNoTemporary) {
  const TemporaryFolder folder;
  {
    FileBatch batch;
    write_file(folder / "a.txt", "new", &batch);
    write_file(folder / "b.txt", "new", &batch);
    std::filesystem::create_directory(folder / "a.txt");
    EXPECT_EQ(message_of<FileError>(folder / "a.txt", [&] { batch.commit(); }),
              ": cannot be replaced (Is a directory); check the folder, its permissions and the "
              "free space");
  }
  EXPECT_EQ(folder.names().size(), 1U);
}

// The temporary's name is longer than the target's.
TEST(AtomicFile, NamesAsLongAsTheFileSystemAdmits) {
  const TemporaryFolder folder;
  const std::string name = std::string(251, 'n') + ".txt";
  write_file(folder / name, "x");
  EXPECT_EQ(content_of(folder / name), "x");
}

// A limit on the size of files fails in the middle of the bytes, as a full disk does.
TEST(AtomicFile, ADiskThatFillsUpLeavesTheOldFile) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  const int code = exit_code_of_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100'000, 100'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const std::string message = message_of<FileError>(
        folder / "a.txt", [&] { write_file(folder / "a.txt", std::string(1'000'000, 'x')); });
    return message.starts_with(": cannot be written (File too large)") ? 7 : 2;
  });
  EXPECT_EQ(code, 7);
  EXPECT_EQ(content_of(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(AtomicFile, PipesAreWrittenDirectly) {
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe.txt";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = content_of(pipe); });
  write_file(pipe, "through");
  reader.join();
  EXPECT_EQ(received, "through");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

}  // namespace
}  // namespace cocoon
