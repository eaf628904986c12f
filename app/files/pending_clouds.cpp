#include "app/files/pending_clouds.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <string_view>
#include <utility>

#include "geom/errors.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"

namespace cocoon::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "COCOONCL";
constexpr std::uint32_t version = 4;
constexpr std::uint32_t oldest_version = 1;
constexpr std::uint32_t first_version_with_count = 3;
constexpr std::uint32_t first_version_with_crowded = 4;
constexpr std::size_t least_header = 48;  // of versions 1 and 2

enum Bits : std::uint32_t { has_rho = 1, is_refused = 2, keeps_crowded = 4 };

// What stands for the notes before a cloud.
std::uint64_t history_of(std::span<const std::string> notes) {
  std::string text;
  for (const std::string& note : notes) text += note + "\n";
  return checksum_of(text);
}

// What the header says of one cloud.
struct CloudSizes {
  std::uint64_t note_bytes = 0;
  std::uint64_t points = 0;
};

// None if these numbers do not fit the file.
std::optional<std::vector<CloudSizes>> next_sizes(SummedReader& file, bool counted) {
  const std::uint64_t clouds = counted ? file.next<std::uint64_t>() : 1;
  if (clouds == 0 || clouds > file.left() / sizeof(CloudSizes)) return std::nullopt;
  std::vector<CloudSizes> sizes(clouds);
  file.fill<std::uint64_t>(std::span(sizes));
  std::size_t left = file.left();
  for (const auto& [note_bytes, points] : sizes) {
    if (note_bytes > left || points > left / sizeof(Point)) return std::nullopt;
    const std::size_t size = sizeof(Point) * points + round_up_to_8(note_bytes);
    if (size > left) return std::nullopt;
    left -= size;
  }
  if (left != 0) return std::nullopt;
  return sizes;
}

// The name of all of them but K.
std::string pending_cloud_prefix(const std::string& session) {
  return follow_links(session).string() + ".cloud-";
}

// The prefix, then digits and nothing else.
bool is_name_with_number(const std::string& name, const std::string& prefix) {
  return name.size() > prefix.size() && name.starts_with(prefix) &&
         name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
}

// One that lies beside the session. Numbers of any length: a name tells, whoever made it.
struct FoundCloud {
  fs::path path;
  std::string number;  // K without leading zeros

  bool is_behind(const std::string& other) const {
    return number.size() != other.size() ? number.size() > other.size() : number > other;
  }
};

// By the names alone: a folder may be spelled in several ways.
std::vector<FoundCloud> pending_cloud_files(const std::string& session) {
  const fs::path path = pending_cloud_prefix(session);
  const std::string prefix = path.filename().string();
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  std::vector<FoundCloud> found;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!is_name_with_number(name, prefix)) continue;
    std::string number = name.substr(prefix.size());
    number.erase(0, std::min(number.find_first_not_of('0'), number.size() - 1));
    found.push_back({path.parent_path() / name, number});
  }
  if (error) {
    throw file_error(folder, "cannot be listed (" + error.message() + "); check the folder");
  }
  return found;
}

// Others that have the name of one are somebody else's.
bool begins_with_magic(const fs::path& path) {
  std::array<char, magic.size()> beginning = {};
  std::ifstream(path, std::ios::binary).read(beginning.data(), beginning.size());
  return std::string_view(beginning.data(), beginning.size()) == magic;
}

// Clouds are applied one after the other: where one is missing, those that came after it mean
// nothing. `notes`: how many there are with all that precede it.
void require_none_behind(const std::string& session, std::size_t notes) {
  const std::string missing = std::to_string(notes);
  std::optional<FoundCloud> next;
  for (const FoundCloud& file : pending_cloud_files(session)) {
    if (!file.is_behind(missing) || !begins_with_magic(file.path)) continue;
    if (!next || next->is_behind(file.number)) next = file;
  }
  if (!next) return;
  throw file_error(pending_cloud_file(session, notes),
                   "is missing, but " + next->path.string() +
                       " follows it; put it there again, or remove all behind it and put their "
                       "clouds into the folder again");
}

PendingUpdate load_update(const fs::path& path, std::span<const std::string> notes) {
  constexpr const char* remedy =
      "put a copy of it there, or remove it and those with higher numbers, and put their clouds "
      "into the folder again";
  SummedReader file(path, magic, "cloud of a session", remedy);
  const auto damaged = [&] {
    return file_error(path,
                      std::string("the numbers in the header do not fit the file; ") + remedy);
  };
  if (magic.size() + file.left() < least_header) throw damaged();
  const auto found = file.next<std::uint32_t>();
  if (found < oldest_version || found > version) {
    throw file_error(path,
                     fmt::format("cloud of a session of version {}, but only versions {} to {} "
                                 "can be read; finish it with the program that wrote it",
                                 found, oldest_version, version));
  }
  const auto bits = file.next<std::uint32_t>();
  const auto rho = file.next<double>();
  const auto history = file.next<std::uint64_t>();
  PendingUpdate update;
  if ((bits & has_rho) != 0) update.rho = rho;
  update.refused = (bits & is_refused) != 0;
  update.keep_crowded = found < first_version_with_crowded || (bits & keeps_crowded) != 0;
  const std::optional<std::vector<CloudSizes>> sizes =
      next_sizes(file, found >= first_version_with_count);
  if (!sizes) {
    file.finish();  // knows better, as a rule
    throw damaged();
  }
  for (const auto& [note_bytes, points] : *sizes) {
    if (update.refused && points > 0) throw damaged();
    std::vector<Point> cloud(points);
    file.fill<double>(std::span(cloud));
    if (!update.refused) update.clouds.push_back(std::move(cloud));
    update.notes.push_back(file.take(note_bytes));
    file.skip_to_word();
  }
  file.finish();
  if (history != history_of(notes)) {
    throw file_error(path, "follows another session than the one beside it; remove one of them");
  }
  return update;
}

}  // namespace

std::string pending_cloud_file(const std::string& session, std::size_t notes) {
  return fmt::format("{}{}", pending_cloud_prefix(session), notes);
}

void save_pending_clouds(const std::string& session, std::span<const std::string> notes,
                         const PendingUpdate& update, FileBatch& batch) {
  const auto cloud_at = [&](std::size_t c) {
    return update.refused ? std::span<const Point>{} : std::span<const Point>(update.clouds[c]);
  };
  SummedFile file(pending_cloud_file(session, notes.size()));
  file.append(magic);
  file.append(version);
  file.append((update.rho ? has_rho : 0U) | (update.refused ? is_refused : 0U) |
              (update.keep_crowded ? keeps_crowded : 0U));
  file.append(update.rho.value_or(0));
  file.append(history_of(notes));
  file.append(std::uint64_t{update.notes.size()});
  for (std::size_t c = 0; c < update.notes.size(); ++c) {
    file.append(std::uint64_t{update.notes[c].size()});
    file.append(std::uint64_t{cloud_at(c).size()});
  }
  for (std::size_t c = 0; c < update.notes.size(); ++c) {
    file.append_numbers<double>(cloud_at(c));
    file.append(std::string_view(update.notes[c]));
    file.fill_word();
  }
  file.commit(&batch);
}

bool is_pending_cloud_file(const fs::path& path, const std::string& session) {
  return is_name_with_number(path.string(), pending_cloud_prefix(session));
}

std::vector<PendingUpdate> load_pending_clouds(const std::string& session,
                                               std::span<const std::string> notes) {
  std::vector<std::string> before(notes.begin(), notes.end());
  std::vector<PendingUpdate> updates;
  for (;;) {
    const fs::path path = pending_cloud_file(session, before.size());
    if (!fs::exists(path)) {
      require_none_behind(session, before.size());
      return updates;
    }
    updates.push_back(load_update(path, before));
    const std::vector<std::string>& more = updates.back().notes;
    before.insert(before.end(), more.begin(), more.end());
  }
}

void remove_pending_clouds(const std::string& session) {
  std::error_code error;
  for (const FoundCloud& file : pending_cloud_files(session)) {
    if (!begins_with_magic(file.path)) continue;
    if (!fs::remove(file.path, error) && error) {
      throw file_error(file.path, "cannot be removed (" + error.message() + "); check the folder");
    }
  }
}

}  // namespace cocoon::app
