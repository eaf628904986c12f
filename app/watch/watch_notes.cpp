#include "app/watch/watch_notes.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <set>
#include <string_view>

#include "io/file_bytes.h"
#include "io/summed_file.h"

namespace cocoon::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view applied = "applied ";
constexpr std::string_view refused = "refused ";
constexpr std::string_view alone = "alone ";
constexpr std::string_view applied_at_any_time = "cloud ";

std::string content_of(const fs::path& path) {
  const FileBytes file = read_file(path);
  return fmt::format("{:016x}-{}", checksum_of(file.view()), file.size);
}

// All bytes of the name, so that other files have other notes; but a note is one line.
std::string name_of(const NotedFile& file) {
  std::string name = file.path.filename().string();
  std::replace(name.begin(), name.end(), '\n', '?');
  return name;
}

std::string note_of(std::string_view what, const NotedFile& file) {
  return fmt::format("{}{} {} {}", what, file.content, file.changed, name_of(file));
}

// Behind so many words.
std::string_view rest_of(std::string_view note, int words) {
  for (; words > 0; --words) note.remove_prefix(std::min(note.find(' '), note.size() - 1) + 1);
  return note;
}

// The latest note on a file of that name; empty: there is none.
std::string_view latest_note(std::span<const std::string> notes, const NotedFile& file) {
  const std::string name = name_of(file);
  const std::string shown_name = display_name(file.path.filename());
  for (std::size_t k = notes.size(); k-- > 0;) {
    const std::string_view note = notes[k];
    if (note.starts_with(applied_at_any_time) && rest_of(note, 2) == shown_name) return note;
    const bool is_timed =
        note.starts_with(applied) || note.starts_with(refused) || note.starts_with(alone);
    if (is_timed && rest_of(note, 3) == name) return note;
  }
  return {};
}

}  // namespace

std::string note_of_model(const fs::path& model, const std::optional<double>& densify) {
  const std::string note = "model " + content_of(model);
  return densify ? fmt::format("{} densify {}", note, *densify) : note;
}

NotedFile noted_file(const fs::path& path, fs::file_time_type changed) {
  const auto time = fs::file_time_type::clock::to_sys(changed).time_since_epoch();
  return {path, content_of(path),
          std::chrono::duration_cast<std::chrono::nanoseconds>(time).count()};
}

std::string note_of_applied(const NotedFile& file) { return note_of(applied, file); }
std::string note_of_refused(const NotedFile& file) { return note_of(refused, file); }
std::string note_of_alone(const NotedFile& file) { return note_of(alone, file); }

bool is_noted(std::span<const std::string> notes, const NotedFile& file) {
  const std::string_view note = latest_note(notes, file);
  return note == note_of_applied(file) || note == note_of_refused(file) ||
         note == fmt::format("{}{} {}", applied_at_any_time, file.content,
                             display_name(file.path.filename()));
}

bool is_to_be_alone(std::span<const std::string> notes, const NotedFile& file) {
  return latest_note(notes, file) == note_of_alone(file);
}

NoteCounts count_notes(std::span<const std::string> notes) {
  NoteCounts counts;
  std::set<std::string_view> refused_names;
  for (const std::string& note : notes) {
    if (note.starts_with(refused)) refused_names.insert(rest_of(note, 3));
    if (note.starts_with(applied)) refused_names.erase(rest_of(note, 3));
    if (note.starts_with(applied) || note.starts_with(applied_at_any_time)) ++counts.applied;
  }
  counts.refused = refused_names.size();
  return counts;
}

}  // namespace cocoon::app
