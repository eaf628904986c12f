#include "app/pending_clouds.h"

#include <filesystem>
#include <fmt/format.h>
#include <string_view>
#include <utility>

#include "app/updating.h"
#include "geom/errors.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"

namespace cocoon::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "COCOONCL";
constexpr std::uint32_t version = 2;
constexpr std::uint32_t oldest_version = 1;
constexpr std::size_t header_size = 48;

enum Bits : std::uint32_t { has_rho = 1, is_refused = 2 };

// What stands for the notes before a cloud.
std::uint64_t history_of(std::span<const std::string> notes) {
  std::string text;
  for (const std::string& note : notes) text += note + "\n";
  return checksum_of(std::move(text));
}

PendingCloud load_pending_cloud(const fs::path& path, std::span<const std::string> notes) {
  SummedReader file(path, magic, "cloud of a session");
  const auto damaged = [&] {
    return file_error(path,
                      "the numbers in the header do not fit the file; remove it, and put its "
                      "cloud into the folder again");
  };
  if (magic.size() + file.left() < header_size) throw damaged();
  if (const auto found = file.next<std::uint32_t>(); found < oldest_version || found > version) {
    throw file_error(path,
                     fmt::format("cloud of a session of version {}, but only versions {} to {} "
                                 "can be read; finish it with the program that wrote it",
                                 found, oldest_version, version));
  }
  const auto bits = file.next<std::uint32_t>();
  const auto rho = file.next<double>();
  const auto history = file.next<std::uint64_t>();
  const auto note_bytes = file.next<std::uint64_t>();
  const auto points = file.next<std::uint64_t>();
  if (note_bytes > file.left() || points > file.left() ||
      24 * points + round_up_to_8(note_bytes) != file.left()) {
    file.finish();  // knows better, as a rule
    throw damaged();
  }
  PendingCloud cloud;
  if ((bits & has_rho) != 0) cloud.rho = rho;
  cloud.refused = (bits & is_refused) != 0;
  if (cloud.refused && points > 0) throw damaged();
  cloud.points.resize(points);
  file.fill<double>(std::span(cloud.points));
  cloud.note = file.take(note_bytes);
  file.skip_to_word();
  file.finish();
  if (history != history_of(notes)) {
    throw file_error(path, "follows another session than the one beside it; remove one of them");
  }
  return cloud;
}

}  // namespace

std::string pending_cloud_file(const std::string& session, std::size_t notes) {
  return fmt::format("{}.cloud-{}", session, notes);
}

void save_pending_cloud(const std::string& session, std::span<const std::string> notes,
                        const PendingCloud& cloud, FileBatch& batch) {
  SummedFile file(pending_cloud_file(session, notes.size()));
  file.append(magic);
  file.append(version);
  file.append((cloud.rho ? has_rho : 0U) | (cloud.refused ? is_refused : 0U));
  file.append(cloud.rho.value_or(0));
  file.append(history_of(notes));
  file.append(std::uint64_t{cloud.note.size()});
  file.append(std::uint64_t{cloud.points.size()});
  file.append_numbers<double>(std::span(cloud.points));
  file.append(std::string_view(cloud.note));
  file.fill_word();
  file.commit(&batch);
}

std::vector<PendingCloud> load_pending_clouds(const std::string& session,
                                              std::span<const std::string> notes) {
  std::vector<std::string> before(notes.begin(), notes.end());
  std::vector<PendingCloud> clouds;
  for (;;) {
    const fs::path path = pending_cloud_file(session, before.size());
    if (!fs::exists(path)) return clouds;
    clouds.push_back(load_pending_cloud(path, before));
    before.push_back(clouds.back().note);
  }
}

void remove_pending_clouds(const std::string& session) {
  const fs::path path(session);
  const std::string prefix = path.filename().string() + ".cloud-";
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const bool is_numbered =
        name.size() > prefix.size() && name.starts_with(prefix) &&
        name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
    if (is_numbered) found.push_back(entry->path());
  }
  if (error)
    throw file_error(folder, "cannot be listed (" + error.message() + "); check the folder");
  for (const fs::path& file : found) {
    if (!fs::remove(file, error) && error) {
      throw file_error(file, "cannot be removed (" + error.message() + "); check the folder");
    }
  }
}

void resume_session(const std::string& path, SavedSession saved, const SurfaceArguments& parameters,
                    const Execution& execution, ResumedSession& resumed) {
  resumed.parameters = saved.parameters;
  SurfaceArguments arguments = saved.parameters;
  arguments.verify = parameters.verify;
  const auto take_up = [&](SessionSnapshot snapshot, std::optional<double> rho) {
    arguments.rho = rho;
    resumed.session.emplace(std::move(snapshot), update_options(arguments), SnapshotCheck::done);
  };
  const std::vector<PendingCloud> clouds = load_pending_clouds(path, saved.notes);
  resumed.notes = std::move(saved.notes);
  resumed.pending = clouds.size();
  take_up(std::move(saved.snapshot), clouds.empty() ? parameters.rho : clouds.front().rho);
  for (const PendingCloud& cloud : clouds) {
    if (cloud.refused) {
      resumed.notes.push_back(cloud.note);
      continue;
    }
    if (cloud.rho != arguments.rho) take_up(resumed.session->snapshot(), cloud.rho);
    const std::vector<std::vector<Point>> points{cloud.points};
    const UpdateResult result = resumed.session->apply(points, execution).result;
    if (result.status != UpdateStatus::ok) {
      throw InputError(fmt::format(
          "{}: a cloud that was applied before is refused now ({}): {}; "
          "begin again from the model",
          pending_cloud_file(path, resumed.notes.size()), name_of(result.status), result.message));
    }
    resumed.notes.push_back(cloud.note);
  }
  if (arguments.rho != parameters.rho) take_up(resumed.session->snapshot(), parameters.rho);
}

}  // namespace cocoon::app
