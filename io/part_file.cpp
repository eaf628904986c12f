#include "io/part_file.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace cocoon {

namespace {

// By which a file without a name is given one.
std::string path_of_descriptor(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

std::filesystem::path folder_of(const std::filesystem::path& place) {
  return place.has_parent_path() ? place.parent_path() : std::filesystem::path(".");
}

int error_of(int result) { return result < 0 ? errno : 0; }

}  // namespace

PartFile::PartFile(PartFile&& other) noexcept
    : place_(std::move(other.place_)),
      name_(std::exchange(other.name_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

PartFile& PartFile::operator=(PartFile&& other) noexcept {
  discard();
  place_ = std::move(other.place_);
  name_ = std::exchange(other.name_, {});
  descriptor_ = std::exchange(other.descriptor_, -1);
  return *this;
}

int PartFile::open(const std::filesystem::path& place) {
  place_ = place;
  if (open_unnamed()) return 0;
  return take_name([&](const std::filesystem::path& candidate) {
    descriptor_ = ::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return error_of(descriptor_);
  });
}

// False where the system cannot do that, or could not give the file a name later.
bool PartFile::open_unnamed() {
#ifdef O_TMPFILE
  descriptor_ = ::open(folder_of(place_).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
  if (descriptor_ < 0) return false;
  if (::access(path_of_descriptor(descriptor_).c_str(), F_OK) == 0) return true;
  discard();
#endif
  return false;
}

template <class Take>
int PartFile::take_name(Take take) {
  static std::atomic<unsigned> serial{0};
  constexpr int most_tries = 1000;           // leftovers of a killed process with our id
  constexpr std::size_t longest_name = 200;  // of the 255 bytes that file systems admit
  for (int i = 0; i < most_tries; ++i) {
    std::string name = ".";
    name += place_.filename().string().substr(0, longest_name);
    name += ".cocoon-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".part";
    const std::filesystem::path candidate = place_.parent_path() / name;
    const int error = take(candidate);
    if (error == 0) name_ = candidate;
    if (error != EEXIST) return error;
  }
  return EEXIST;
}

int PartFile::set_permissions(unsigned mode) const { return error_of(::fchmod(descriptor_, mode)); }

int PartFile::write(std::string_view bytes) const { return write_all(descriptor_, bytes); }

int PartFile::complete() const { return error_of(::fsync(descriptor_)); }

int PartFile::give_name() {
  if (name_.empty()) {
    const std::string source = path_of_descriptor(descriptor_);
    const int error = take_name([&](const std::filesystem::path& candidate) {
      return error_of(
          ::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, candidate.c_str(), AT_SYMLINK_FOLLOW));
    });
    if (error != 0) return error;
  }
  return error_of(::close(std::exchange(descriptor_, -1)));
}

int PartFile::rename_to_place() {
  const int error = error_of(::rename(name_.c_str(), place_.c_str()));
  if (error == 0) name_.clear();
  return error;
}

void PartFile::discard() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (!name_.empty()) ::unlink(name_.c_str());
  name_.clear();
}

int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace cocoon
