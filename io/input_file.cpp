#include "io/input_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file_bytes.h"

namespace cocoon {

namespace {

constexpr const char* it_is_a_folder = "it is a folder";
constexpr const char* it_is_a_device = "it is a device, which may never end";

[[noreturn]] void throw_unreadable(const std::filesystem::path& path, const std::string& reason) {
  const std::string told = "cannot be read (" + reason + "); check the name and the permissions";
  throw UnreadableFile(file_error(path, told).what());
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat status = {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) {
    const std::string reason = std::strerror(errno);
    if (descriptor_ >= 0) ::close(descriptor_);
    throw_unreadable(path, reason);
  }
  if (S_ISDIR(status.st_mode)) {
    ::close(descriptor_);
    throw_unreadable(path, it_is_a_folder);
  }
  if (S_ISCHR(status.st_mode) && ::isatty(descriptor_) == 0) {
    ::close(descriptor_);
    throw_unreadable(path, it_is_a_device);
  }
  if (S_ISREG(status.st_mode)) size_ = static_cast<std::size_t>(status.st_size);
}

void require_input(const std::filesystem::path& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) throw_unreadable(path, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) throw_unreadable(path, it_is_a_folder);
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::read(char* to, std::size_t most) {
  std::size_t done = 0;
  while (done < most) {
    const ssize_t got = ::read(descriptor_, to + done, most - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_unreadable(path_, std::strerror(errno));
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace cocoon
