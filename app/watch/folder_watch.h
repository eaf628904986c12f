// Which files of a folder are complete and have not been looked at yet.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <sys/types.h>
#include <system_error>
#include <utility>
#include <vector>

namespace cocoon::app {

// A file counts as complete when two polls in a row see the same length and time of change, and
// that time is at least `settle` ago: a file that is renamed into the folder is, at the second
// poll; one that is being written there is not before its writer has paused for that long. So is
// one that polls have seen unchanged for as long: its time may be from a clock that is ahead. Files
// whose names begin with a dot, and what is no point format, are not looked at. A file that changes
// later, or comes again under its old name, is a new one.
//
// Folders and files may be away for a while (a share that is unmounted, permissions that are
// changed), and what comes back is not new. Therefore a file is forgotten only if the folder in
// which it was seen was listed to the end and the file is not there. A folder counts as that one by
// its device and inode: under its name may be another one meanwhile, as the empty place at which a
// share is mounted. What lies in another folder when that is listed first was there before.
class FolderWatch {
 public:
  struct CompleteFile {
    std::filesystem::path path;
    std::uintmax_t size = 0;
    std::filesystem::file_time_type changed;
    bool was_there = false;  // at the first poll of that folder, with that length and time
  };

  // `no_clouds`: files that are not looked at either, wherever they lie, by any name.
  FolderWatch(std::filesystem::path folder, std::chrono::milliseconds settle,
              const std::vector<std::filesystem::path>& no_clouds = {});

  // The files that have become complete, the earliest changed first, then by name; each once.
  // Throws FileError if the folder cannot be listed to the end; then nothing is new, and nothing
  // forgotten.
  std::vector<CompleteFile> poll();
  // Throws FileError if the folder cannot be listed now.
  void require_readable() const;
  // Files seen that are not complete yet.
  std::size_t waiting() const { return waiting_; }
  // Files that the last poll found in the folder but could not look at, and why: one line; empty if
  // there is none. They do not wait, and are told of when they can be looked at.
  const std::string& out_of_reach() const { return out_of_reach_; }

  // Polls tell of that file again: it could not be read.
  void try_again(const std::filesystem::path& file);
  // The same when it has become complete again: it changed while it was read.
  void wait_for(const std::filesystem::path& file);

 private:
  // Device and inode of a folder.
  using Place = std::pair<dev_t, ino_t>;
  struct Seen {
    Place place;                         // where it was seen last
    std::optional<std::uintmax_t> size;  // none: it could not be looked at, or is to be anew
    std::filesystem::file_time_type changed;
    std::chrono::steady_clock::time_point since;  // seen with that size and time
    bool was_there = false;
    bool reported = false;
    bool is_no_cloud = false;
  };

  [[noreturn]] void fail(const std::error_code& error) const;
  Place place_now() const;
  // The paths of what may be clouds.
  std::vector<std::filesystem::path> list() const;
  // A file as it is now; `fresh`: what is so of each that is seen for the first time.
  Seen look_at(const std::filesystem::path& path, const Seen& fresh, std::error_code& error) const;
  bool is_no_cloud(const std::filesystem::path& path) const;

  std::filesystem::path folder_;
  std::chrono::milliseconds settle_;
  std::vector<std::filesystem::path> no_clouds_;  // their places (files.h)
  std::map<std::filesystem::path, Seen> seen_;
  std::optional<Place> place_;  // of the last poll
  std::size_t waiting_ = 0;
  std::string out_of_reach_;
};

// Is a file another one than a poll told of? One that is gone is not.
bool has_changed(const FolderWatch::CompleteFile& file);

}  // namespace cocoon::app
