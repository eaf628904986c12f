// Which files of a folder are complete and have not been looked at yet.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <vector>

namespace cocoon::app {

// A file counts as complete when two polls in a row see the same length and time of change, and
// that time is at least `settle` ago: a file that is renamed into the folder is, at the second
// poll; one that is being written there is not before its writer has paused for that long. So is
// one that polls have seen unchanged for as long: its time may be from a clock that is ahead. Files
// whose names begin with a dot, and what is no point format, are not looked at. A file that changes
// later, or comes again under its old name, is a new one.
class FolderWatch {
 public:
  struct CompleteFile {
    std::filesystem::path path;
    std::filesystem::file_time_type changed;
    bool was_there = false;  // at the first poll, with that length and time
  };

  // `no_clouds`: files that are not looked at either, wherever they lie, by any name.
  FolderWatch(std::filesystem::path folder, std::chrono::milliseconds settle,
              const std::vector<std::filesystem::path>& no_clouds = {});

  // The files that have become complete, the earliest changed first, then by name; each once.
  // Throws FileError if the folder cannot be read.
  std::vector<CompleteFile> poll();
  // Files seen that are not complete yet.
  std::size_t waiting() const { return waiting_; }

 private:
  struct Seen {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type changed;
    std::chrono::steady_clock::time_point since;  // seen with that size and time
    bool was_there = false;
    bool reported = false;
    bool is_no_cloud = false;
  };
  bool is_no_cloud(const std::filesystem::path& path) const;

  std::filesystem::path folder_;
  std::chrono::milliseconds settle_;
  std::vector<std::filesystem::path> no_clouds_;  // their places (files.h)
  std::map<std::filesystem::path, Seen> seen_;
  std::size_t waiting_ = 0;
  bool is_first_poll_ = true;
};

}  // namespace cocoon::app
