#include "io/lock_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/atomic_file.h"
#include "io/file_bytes.h"

namespace cocoon {

namespace {

// Has somebody removed the file that was opened, or put another one in its place?
bool is_still_there(int descriptor, const std::filesystem::path& path) {
  struct stat opened = {};
  struct stat there = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &there) == 0 &&
         opened.st_dev == there.st_dev && opened.st_ino == there.st_ino;
}

// As all locks are that this makes.
bool is_empty(int descriptor) {
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size == 0;
}

std::string no_lock(const std::string& name) {
  return name + " beside it, which is there and no lock; move that away, or use another name";
}

}  // namespace

std::filesystem::path lock_of(const std::filesystem::path& file) {
  std::filesystem::path lock = follow_links(file);
  lock += ".lock";
  return lock;
}

LockFile::LockFile(const std::filesystem::path& file) : lock_(lock_of(file)) {
  const auto fail = [&](const std::string& why) {
    if (descriptor_ >= 0) ::close(descriptor_);
    throw file_error(file, why);
  };
  const std::string name = lock_.filename().string();
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = ::open(lock_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (errno == ELOOP && descriptor_ < 0) fail("cannot be locked by " + no_lock(name));
    if (descriptor_ >= 0 && !is_empty(descriptor_)) fail("cannot be locked by " + no_lock(name));
    if (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) continue;
    if (errno == EWOULDBLOCK) {
      fail("is in use by another run of cocoon; wait until that is done, or stop it");
    }
    if (errno == ENAMETOOLONG)
      fail("this name is too long with .lock behind it; use a shorter one");
    fail("cannot be locked by " + name + " beside it (" + std::strerror(errno) +
         "); check the folder and its permissions");
  } while (!is_still_there(descriptor_, lock_));
}

// Who has opened it meanwhile sees that it is gone.
LockFile::~LockFile() {
  ::unlink(lock_.c_str());
  ::close(descriptor_);
}

}  // namespace cocoon
