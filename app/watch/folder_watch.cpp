#include "app/watch/folder_watch.h"

#include <algorithm>
#include <cerrno>
#include <fmt/format.h>
#include <sys/stat.h>
#include <system_error>
#include <tuple>
#include <utility>

#include "app/files/files.h"
#include "geom/errors.h"
#include "geom/messages/counted.h"
#include "io/file_format.h"

namespace cocoon::app {

namespace fs = std::filesystem;

namespace {

// Or what people take for one: they are told why it is none.
bool may_be_cloud(const fs::path& path) {
  if (path.filename().string().starts_with('.')) return false;
  return format_of(path) != FileFormat::other || is_scan_of_others(path) || is_packed(path);
}

std::error_code system_error(int number) { return {number, std::generic_category()}; }

bool says_gone(const std::error_code& error) {
  return error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
}

// Of a regular file. Anything else is as if it were gone.
void measure(const fs::path& path, std::optional<std::uintmax_t>& size, fs::file_time_type& changed,
             std::error_code& error) {
  const fs::file_status status = fs::status(path, error);
  if (!error && !fs::is_regular_file(status)) error = system_error(ENOENT);
  if (error) return;
  size = fs::file_size(path, error);
  if (!error) changed = fs::last_write_time(path, error);
  if (error) size.reset();
}

}  // namespace

FolderWatch::FolderWatch(fs::path folder, std::chrono::milliseconds settle,
                         const std::vector<fs::path>& no_clouds)
    : folder_(std::move(folder)), settle_(settle) {
  for (const fs::path& path : no_clouds) no_clouds_.push_back(place_of(path));
}

bool FolderWatch::is_no_cloud(const fs::path& path) const {
  return std::find(no_clouds_.begin(), no_clouds_.end(), place_of(path)) != no_clouds_.end();
}

void FolderWatch::fail(const std::error_code& error) const {
  throw FileError(folder_.string() + ": cannot read this folder: " + error.message());
}

void FolderWatch::require_readable() const {
  try {
    list();
  } catch (const FileError& error) {
    throw FileError(error.what() + std::string("; check its permissions"));
  }
}

FolderWatch::Place FolderWatch::place_now() const {
  struct stat status = {};
  if (::stat(folder_.c_str(), &status) != 0) fail(system_error(errno));
  return {status.st_dev, status.st_ino};
}

std::vector<fs::path> FolderWatch::list() const {
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator entries(folder_, error);
  while (!error && entries != fs::directory_iterator()) {
    if (may_be_cloud(entries->path())) files.push_back(entries->path());
    entries.increment(error);
  }
  if (error) fail(error);
  return files;
}

// `error`: it cannot be looked at; then it is as it was.
FolderWatch::Seen FolderWatch::look_at(const fs::path& path, const Seen& fresh,
                                       std::error_code& error) const {
  Seen file = fresh;
  measure(path, file.size, file.changed, error);
  const auto before = seen_.find(path);
  const bool is_known = before != seen_.end();
  if (error && is_known) {
    file = before->second;
    file.place = fresh.place;
    return file;
  }
  if (is_known && before->second.size) {
    const Seen& known = before->second;
    file.is_no_cloud = known.is_no_cloud;
    if (known.size != file.size || known.changed != file.changed) return file;
    file.was_there = known.was_there;
    file.reported = known.reported;
    file.since = known.since;
    return file;
  }
  if (is_known) file.was_there = before->second.was_there;
  file.is_no_cloud = is_no_cloud(path);
  return file;
}

std::vector<FolderWatch::CompleteFile> FolderWatch::poll() {
  const auto now = fs::file_time_type::clock::now();
  const auto poll_time = std::chrono::steady_clock::now();
  const Place place = place_now();
  const Seen fresh{place, {}, {}, poll_time, place != place_};
  std::map<fs::path, Seen> seen;
  std::vector<CompleteFile> complete;
  std::vector<std::error_code> out_of_reach;
  std::size_t waiting = 0;
  for (const fs::path& path : list()) {
    std::error_code error;
    Seen file = look_at(path, fresh, error);
    if (says_gone(error)) continue;
    if (error) {
      out_of_reach.push_back(error);
    } else if (!file.reported && !file.is_no_cloud) {
      // The clock that gave the file its time may be ahead.
      const bool is_settled = now - file.changed >= settle_ || poll_time - file.since >= settle_;
      if (file.since != poll_time && is_settled) {
        file.reported = true;
        complete.push_back({path, *file.size, file.changed, file.was_there});
      } else {
        ++waiting;
      }
    }
    seen.emplace(path, file);
  }
  // What is removed or unmounted while it is listed may end like a folder without more files.
  if (place_now() != place) fail(system_error(ESTALE));
  for (const auto& [path, file] : seen_) {
    if (file.place != place) seen.emplace(path, file);
  }
  seen_ = std::move(seen);
  place_ = place;
  waiting_ = waiting;
  out_of_reach_.clear();
  if (!out_of_reach.empty()) {
    out_of_reach_ = fmt::format("{}: {} cannot be looked at ({})", folder_.string(),
                                counted(out_of_reach.size(), "file"), out_of_reach[0].message());
  }
  std::sort(complete.begin(), complete.end(), [](const CompleteFile& a, const CompleteFile& b) {
    return std::tie(a.changed, a.path) < std::tie(b.changed, b.path);
  });
  return complete;
}

void FolderWatch::try_again(const fs::path& file) {
  const auto seen = seen_.find(file);
  if (seen != seen_.end()) seen->second.reported = false;
}

void FolderWatch::wait_for(const fs::path& file) {
  const auto seen = seen_.find(file);
  if (seen == seen_.end() || !std::exchange(seen->second.reported, false)) return;
  seen->second.size.reset();
  ++waiting_;
}

bool has_changed(const FolderWatch::CompleteFile& file) {
  std::optional<std::uintmax_t> size;
  fs::file_time_type changed;
  std::error_code error;
  measure(file.path, size, changed, error);
  if (error) return !says_gone(error);
  return size != file.size || changed != file.changed;
}

}  // namespace cocoon::app
