#include "app/folder_watch.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "app/files.h"
#include "geom/errors.h"
#include "io/file_format.h"

namespace cocoon::app {

namespace fs = std::filesystem;

namespace {

bool may_be_cloud(const fs::path& path) {
  return !path.filename().string().starts_with('.') && format_of(path) != FileFormat::other;
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

std::vector<FolderWatch::CompleteFile> FolderWatch::poll() {
  std::error_code error;
  fs::directory_iterator entries(folder_, error);
  if (error) {
    throw FileError(folder_.string() + ": cannot read this folder: " + error.message());
  }
  const auto now = fs::file_time_type::clock::now();
  const auto seen_now = std::chrono::steady_clock::now();
  std::map<fs::path, Seen> seen;
  std::vector<CompleteFile> complete;
  waiting_ = 0;
  for (; entries != fs::directory_iterator(); entries.increment(error)) {
    const fs::path path = entries->path();
    if (!may_be_cloud(path) || !entries->is_regular_file(error)) continue;
    Seen file{fs::file_size(path, error), {}, seen_now};
    if (error) continue;  // gone meanwhile
    file.changed = fs::last_write_time(path, error);
    if (error) continue;
    const auto before = seen_.find(path);
    const bool same = before != seen_.end() && before->second.size == file.size &&
                      before->second.changed == file.changed;
    file.was_there = same ? before->second.was_there : is_first_poll_;
    file.reported = same && before->second.reported;
    if (same) file.since = before->second.since;
    file.is_no_cloud = before != seen_.end() ? before->second.is_no_cloud : is_no_cloud(path);
    if (!file.reported && !file.is_no_cloud) {
      // The clock that gave the file its time may be ahead.
      if (same && (now - file.changed >= settle_ || seen_now - file.since >= settle_)) {
        file.reported = true;
        complete.push_back({path, file.changed, file.was_there});
      } else {
        ++waiting_;
      }
    }
    seen.emplace(path, file);
  }
  seen_ = std::move(seen);
  is_first_poll_ = false;
  std::sort(complete.begin(), complete.end(), [](const CompleteFile& a, const CompleteFile& b) {
    return std::tie(a.changed, a.path) < std::tie(b.changed, b.path);
  });
  return complete;
}

}  // namespace cocoon::app
