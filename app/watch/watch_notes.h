// What a session of `watch` remembers of the files that it looked at: a note each (session_file.h),
// in the order in which they were looked at.
//
//   model CONTENT [densify SPACING]  the first note: what the session began with
//   applied CONTENT TIME NAME        a cloud
//   refused CONTENT TIME NAME        a cloud that could not be applied to the model of that moment
//   alone CONTENT TIME NAME          one that could not be applied together with others: it is to
//                                    be tried by itself
//   cloud CONTENT NAME               one that was applied, in session files of version 3
//
// CONTENT tells one content from another: a checksum and the size. TIME is that of the file's last
// change, in nanoseconds since 1970.
//
// A file that was there before the program began, or when its folder was first listed
// (folder_watch.h), and is as the latest note on its name says, was looked at already; with another
// content or another time somebody has put it there since, also if an earlier note says the same.
// (A note without time stands for any time.) What was refused is noted, too: tried again after a
// restart it could be applied after all, on top of newer clouds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace cocoon::app {

std::string note_of_model(const std::filesystem::path& model, const std::optional<double>& densify);

// A file as it was when it was looked at.
struct NotedFile {
  std::filesystem::path path;
  std::string content;
  std::int64_t changed = 0;
};

// Errors: FileError if the file cannot be read.
NotedFile noted_file(const std::filesystem::path& path, std::filesystem::file_time_type changed);

std::string note_of_applied(const NotedFile& file);
std::string note_of_refused(const NotedFile& file);
std::string note_of_alone(const NotedFile& file);

// Does the latest note on a file of that name tell that this one was applied or refused?
bool is_noted(std::span<const std::string> notes, const NotedFile& file);
// Or that it is to be tried by itself?
bool is_to_be_alone(std::span<const std::string> notes, const NotedFile& file);

struct NoteCounts {
  std::size_t applied = 0;
  std::size_t refused = 0;  // files: each name whose latest note says so
};
NoteCounts count_notes(std::span<const std::string> notes);

}  // namespace cocoon::app
