#include "io/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file_bytes.h"

namespace cocoon {

namespace {

constexpr int most_links = 40;  // as the kernel's own limit

// The path behind all symbolic links in the last component, also if it does not exist yet.
std::filesystem::path follow_links(std::filesystem::path path) {
  for (int i = 0; i < most_links; ++i) {
    std::error_code error;
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) return path;
    const std::filesystem::path leads_to = std::filesystem::read_symlink(path, error);
    if (error) return path;
    path = path.parent_path() / leads_to;  // an absolute leads_to replaces all
  }
  throw file_error(path, "is a loop of symbolic links; write to another name");
}

[[noreturn]] void throw_write_error(const std::filesystem::path& target, const char* action,
                                    int error_number) {
  throw file_error(target, std::string(action) + " (" + std::strerror(error_number) +
                               "); check the folder, its permissions and the free space");
}

void remove_file(const std::filesystem::path& path) noexcept { ::unlink(path.c_str()); }

}  // namespace

FileBatch::~FileBatch() {
  for (const Waiting& file : waiting_) remove_file(file.temporary);
}

void FileBatch::commit() {
  while (!waiting_.empty()) {
    const Waiting& file = waiting_.front();
    if (::rename(file.temporary.c_str(), file.place.c_str()) != 0) {
      throw_write_error(file.target, "cannot be replaced", errno);
    }
    waiting_.erase(waiting_.begin());
  }
}

AtomicFile::AtomicFile(const std::filesystem::path& target) : target_(target) {
  struct stat status = {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail("cannot be written", EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("cannot be written", errno);
    return;
  }
  final_ = follow_links(target_);
  open_temporary();
  if (exists && ::fchmod(descriptor_, status.st_mode & 0777) != 0) {
    fail("cannot be given the permissions of the file it replaces", errno);
  }
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::open_temporary() {
  static std::atomic<unsigned> serial{0};
  constexpr int most_tries = 1000;           // leftovers of a killed process with our id
  constexpr std::size_t longest_name = 200;  // of the 255 bytes that file systems admit
  for (int i = 0; i < most_tries; ++i) {
    std::string name = ".";
    name += final_.filename().string().substr(0, longest_name);
    name += ".cocoon-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".part";
    const std::filesystem::path candidate = final_.parent_path() / name;
    descriptor_ = ::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      temporary_ = candidate;
      return;
    }
    if (errno != EEXIST) fail("cannot be written", errno);
  }
  fail("cannot be written", EEXIST);
}

void AtomicFile::write(std::string_view bytes) {
  buffer_ += bytes;
  flush_if_full();
}

void AtomicFile::flush() {
  const char* at = buffer_.data();
  std::size_t left = buffer_.size();
  while (left > 0) {
    const ssize_t written = ::write(descriptor_, at, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written", errno);
    at += written;
    left -= static_cast<std::size_t>(written);
  }
  buffer_.clear();
}

void AtomicFile::commit(FileBatch* batch) {
  flush();
  const bool direct = temporary_.empty();
  if (!direct && ::fsync(descriptor_) != 0) fail("cannot be written", errno);
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail("cannot be written", errno);
  if (direct) return;
  if (batch != nullptr) {
    batch->waiting_.push_back({target_, final_, temporary_});
    temporary_.clear();
    return;
  }
  if (::rename(temporary_.c_str(), final_.c_str()) != 0) fail("cannot be replaced", errno);
  temporary_.clear();
}

void AtomicFile::discard() noexcept {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) remove_file(temporary_);
  temporary_.clear();
}

void AtomicFile::fail(const char* action, int error_number) {
  discard();
  throw_write_error(target_, action, error_number);
}

void write_file(const std::filesystem::path& target, std::string_view bytes, FileBatch* batch) {
  AtomicFile file(target);
  file.write(bytes);
  file.commit(batch);
}

}  // namespace cocoon
