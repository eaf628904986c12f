#include "io/atomic_file.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "io/file_bytes.h"

namespace cocoon {

namespace {

constexpr int most_links = 40;  // as the kernel's own limit

bool is_link(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_symlink(std::filesystem::symlink_status(path, error));
}

// What the links in the last component of `path` lead to, one step.
std::filesystem::path next_behind(const std::filesystem::path& path, std::error_code& error) {
  // An absolute name replaces all.
  return path.parent_path() / std::filesystem::read_symlink(path, error);
}

// The names in such folders are the numbers of this process's descriptors.
bool is_folder_of_descriptors(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path place =
      std::filesystem::canonical(folder.empty() ? "." : folder, error);
  if (error) return false;
  for (const char* known : {"/proc/self/fd", "/proc/thread-self/fd", "/dev/fd"}) {
    if (place == std::filesystem::canonical(known, error) && !error) return true;
  }
  return false;
}

[[noreturn]] void throw_write_error(const std::filesystem::path& target, const char* action,
                                    int error_number) {
  throw file_error(target, std::string(action) + " (" + std::strerror(error_number) +
                               "); check the folder, its permissions and the free space");
}

}  // namespace

std::filesystem::path follow_links(std::filesystem::path path) {
  for (int i = 0; i < most_links && is_link(path); ++i) {
    std::error_code error;
    const std::filesystem::path leads_to = next_behind(path, error);
    if (error) return path;
    path = leads_to;
  }
  return path;
}

int own_descriptor(std::filesystem::path path) {
  for (int i = 0; i <= most_links; ++i) {
    const std::string name = path.filename().string();
    int number = -1;
    const auto [end, wrong] = std::from_chars(name.data(), name.data() + name.size(), number);
    const bool is_number = wrong == std::errc() && end == name.data() + name.size();
    if (is_number && number >= 0 && is_folder_of_descriptors(path.parent_path())) return number;
    if (!is_link(path)) return -1;
    std::error_code error;
    path = next_behind(path, error);
    if (error) return -1;
  }
  return -1;
}

void FileBatch::commit() {
  for (Waiting& file : waiting_) {
    if (const int error = file.part.give_name()) {
      throw_write_error(file.target, "cannot be written", error);
    }
  }
  while (!waiting_.empty()) {
    Waiting& file = waiting_.front();
    if (const int error = file.part.rename_to_place()) {
      throw_write_error(file.target, "cannot be replaced", error);
    }
    waiting_.erase(waiting_.begin());
  }
}

AtomicFile::AtomicFile(const std::filesystem::path& target) : target_(target) {
  struct stat status = {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) require(EISDIR);
  // Whoever opened it may have more in that file, and goes on writing to it.
  if (const int descriptor = own_descriptor(target_); descriptor >= 0) {
    is_standard_output_ = descriptor == STDOUT_FILENO;
    direct_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
    if (direct_ < 0) require(errno);
    return;
  }
  if (exists && !S_ISREG(status.st_mode)) {
    direct_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (direct_ < 0) require(errno);
    return;
  }
  const std::filesystem::path place = follow_links(target_);
  if (is_link(place)) {
    throw file_error(place, "is a loop of symbolic links; write to another name");
  }
  require(part_.open(place));
  if (exists) {
    require(part_.set_permissions(status.st_mode & 0777),
            "cannot be given the permissions of the file it replaces");
  }
}

AtomicFile::~AtomicFile() {
  if (direct_ >= 0) ::close(direct_);
}

void AtomicFile::write(std::string_view bytes) {
  buffer_ += bytes;
  flush_if_full();
}

void AtomicFile::flush() {
  const int error = direct_ >= 0 ? write_all(direct_, buffer_) : part_.write(buffer_);
  if (error != EPIPE || !is_standard_output_) require(error);
  buffer_.clear();
}

void AtomicFile::commit(FileBatch* batch) {
  flush();
  if (direct_ >= 0) {
    require(::close(std::exchange(direct_, -1)) != 0 ? errno : 0);
    return;
  }
  require(part_.complete());
  if (batch != nullptr) {
    batch->waiting_.push_back({target_, std::move(part_)});
    return;
  }
  require(part_.give_name());
  require(part_.rename_to_place(), "cannot be replaced");
}

void AtomicFile::require(int error_number, const char* action) {
  if (error_number == 0) return;
  part_.discard();
  throw_write_error(target_, action, error_number);
}

void write_file(const std::filesystem::path& target, std::string_view bytes, FileBatch* batch) {
  AtomicFile file(target);
  file.write(bytes);
  file.commit(batch);
}

}  // namespace cocoon
