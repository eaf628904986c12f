#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "app/arguments/update_options.h"
#include "app/coarse_model.h"
#include "app/commands.h"
#include "app/console/interrupt.h"
#include "app/console/standard_streams.h"
#include "app/files/files.h"
#include "app/files/pending_clouds.h"
#include "app/report/findings.h"
#include "app/report/lost_surface_report.h"
#include "app/report/update_findings.h"
#include "app/report/update_report.h"
#include "app/shapes/cloud_filter.h"
#include "app/shapes/thin_cloud.h"
#include "app/watch/dropped_clouds.h"
#include "app/watch/folder_watch.h"
#include "app/watch/watch_notes.h"
#include "app/watch/watched_session.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/messages/counted.h"
#include "io/file_bytes.h"
#include "io/input_file.h"
#include "io/lock_file.h"
#include "update/checks/lost_surface.h"
#include "update/report/cloud_report.h"

namespace cocoon::app {

namespace {

namespace fs = std::filesystem;

class Watch {
 public:
  Watch(const WatchArguments& arguments, Job& job)
      : arguments_(arguments),
        job_(job),
        options_(update_options(arguments.parameters)),
        session_(arguments, options_, job),
        folder_(arguments.folder, to_milliseconds(arguments.settle), own_files()),
        filter_(cloud_filter(arguments.filter)) {
    require_outputs(
        job, {{arguments.mesh, mesh_extensions}, {.path = session_.file(), .is_session = true}},
        {arguments.model});
    if (place_of(session_.file()) == place_of(lock_of(arguments.mesh))) {
      throw UsageError(session_.file() + ": this name is kept for the lock of " + arguments.mesh +
                       "; name another one");
    }
    require_readable_again(arguments.model);
    require_folder(arguments.folder);
    folder_.require_readable();
    constexpr std::size_t most_notes = std::numeric_limits<std::uint32_t>::max();
    require_possible_name(pending_cloud_file(session_.file(), most_notes));
  }

  // Whether it got as far as to watch.
  bool run() {
    const LockFile lock(session_.file());
    const LockFile mesh_lock(arguments_.mesh);  // by whatever session
    try {
      findings_are_due_ = session_.begin();
    } catch (const Cancelled&) {
      if (arguments_.once || !interrupted()) throw;
      say("stopped before it watched; no file was changed");
      return false;
    }
    flush_output();
    follow_folder();
    session_.finish();
    tell_findings();
    return true;
  }

  // Until it is time to stop.
  void follow_folder() {
    std::vector<FolderWatch::CompleteFile> held;  // until no other file is being written
    do {
      std::vector<FolderWatch::CompleteFile> files;
      if (!look_into_folder(files)) continue;
      for (FolderWatch::CompleteFile& file : files) {
        if (arguments_.together) {
          std::erase_if(held, [&](const auto& before) { return before.path == file.path; });
          held.push_back(std::move(file));
        } else {
          look_at({&file, 1});
        }
        if (interrupted()) return;
      }
      if (folder_.waiting() == 0) {
        look_at_groups(std::exchange(held, {}));
        if (interrupted()) return;
        tell_findings();
      }
      if (arguments_.once && folder_.waiting() == 0 && ++idle_polls_ > 1) return;
    } while (pause());
  }

  void report() {
    const std::size_t refused = refused_ + unreadable_.size();
    job_.report().set("watch/applied", applied_);
    job_.report().set("watch/refused", refused);
    job_.report().set("watch/known", known_.size());
    report_cloud_filter(job_.report(), filter_, thinned_);
    add_update_parameters(job_.report(), options_);
    job_.report().set("parameters/keep_coarse", keeps_coarse(arguments_));
    add_model(job_.report(), session_.session().reconstruction(), session_.model(),
              mesh_check(session_.model(), {}, job_.execution()));
    add_findings(job_.report(), findings_);
    job_.say("stopped: {} applied, {} refused, {} known from before", counted(applied_, "cloud"),
             refused, known_.size());
  }

 private:
  // What may lie in the folder, and is no cloud.
  std::vector<fs::path> own_files() const {
    std::vector<fs::path> files = {arguments_.model, arguments_.mesh, session_.file()};
    if (!job_.shared().json.empty()) files.emplace_back(job_.shared().json);
    return files;
  }

  static std::chrono::milliseconds to_milliseconds(double seconds) {
    return std::chrono::milliseconds(static_cast<long>(1000 * seconds));
  }

  void say(const std::string& line) {
    job_.say("{}", line);
    flush_output();
  }

  // False if the folder cannot be read now. It may be back later: that is told once. Where nobody
  // waits for it, or it could never be read, that ends the command.
  bool look_into_folder(std::vector<FolderWatch::CompleteFile>& files) {
    try {
      files = folder_.poll();
    } catch (const FileError& error) {
      if (arguments_.once || !folder_was_read_) throw;
      if (!std::exchange(folder_is_away_, true)) {
        say(fmt::format("{}; waiting until it can be read again", error.what()));
      }
      return false;
    }
    folder_was_read_ = true;
    if (std::exchange(folder_is_away_, false)) say(arguments_.folder + ": can be read again");
    const bool all_in_reach = folder_.out_of_reach().empty();
    if (std::exchange(all_in_reach_, all_in_reach) && !all_in_reach) {
      say(folder_.out_of_reach() + (arguments_.once ? "; --once does not wait for that"
                                                    : "; waiting until that is possible"));
    }
    return true;
  }

  // Those that came one soon after the other, in the order of their times.
  void look_at_groups(std::vector<FolderWatch::CompleteFile> files) {
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
      return std::tie(a.changed, a.path) < std::tie(b.changed, b.path);
    });
    const auto longest_pause = to_milliseconds(std::max(arguments_.settle, arguments_.poll));
    for (std::size_t first = 0; first < files.size() && !interrupted();) {
      std::size_t end = first + 1;
      while (end < files.size() && files[end].changed - files[end - 1].changed <= longest_pause) {
        ++end;
      }
      look_at(std::span(files).subspan(first, end - first));
      first = end;
    }
  }

  // One line whatever happens to each cloud, unless it was looked at before the program began; what
  // happens to our own files ends the command.
  void look_at(std::span<const FolderWatch::CompleteFile> files) {
    DroppedClouds drop;
    drop.start = std::chrono::steady_clock::now();
    for (const FolderWatch::CompleteFile& file : files) {
      if (!read(file, drop)) return;
    }
    if (drop.has_to_wait) {
      for (const NotedFile& file : drop.files) folder_.wait_for(file.path);
      return;
    }
    if (drop.files.empty()) return;
    // They were on their way when the program was killed.
    const bool are_alone =
        std::any_of(drop.files.begin(), drop.files.end(),
                    [&](const NotedFile& file) { return is_to_be_alone(session_.notes(), file); });
    if (are_alone) return apply_each(drop);
    apply(std::move(drop));
  }

  // False: the interrupt.
  bool read(const FolderWatch::CompleteFile& file, DroppedClouds& drop) {
    const std::string name = display_name(file.path.filename());
    NotedFile noted;
    std::vector<Point> cloud;
    std::string no_cloud;  // why it is none
    try {
      noted = noted_file(file.path, file.changed);
      if (file.was_there && is_noted(session_.notes(), noted)) {
        known_.insert(file.path);
        return true;
      }
      cloud = read_cloud(job_, file.path.string(), "input");
    } catch (const Cancelled&) {
      return false;
    } catch (const UnreadableFile& error) {
      folder_.try_again(file.path);
      if (!unreadable_.insert(file.path).second) return true;
      say(fmt::format("{}: not applied: {}; {}", name, error.what(),
                      arguments_.once ? "--once does not wait for that"
                                      : "it is tried again until it can be read"));
      return true;
    } catch (const Error& error) {
      no_cloud = error.what();
    }
    unreadable_.erase(file.path);
    // Written while it was read: what was read may be half of it.
    if (has_changed(file)) {
      folder_.wait_for(file.path);
      drop.has_to_wait = true;
      return true;
    }
    // What makes no sense is not noted: it changes nothing when it is tried again.
    if (!no_cloud.empty()) {
      tell_refused(name, no_cloud);
      return true;
    }
    std::size_t thinned = 0;
    StraySamples strays;
    try {
      if (is_model_itself(cloud, session_.model())) {
        throw InputError("it is the model itself; drop only scans of what changed");
      }
      if (filter_.thin) thinned = thin_cloud(name, *filter_.thin, cloud);
      if (filter_.strays) {
        strays = leave_out_strays(name, cloud, *filter_.strays, {job_.execution().threads});
      }
    } catch (const Error& error) {
      refuse(noted, name, error.what());
      return true;
    }
    drop.files.push_back(std::move(noted));
    drop.names.push_back(name);
    drop.clouds.push_back(std::move(cloud));
    drop.thinned.push_back(thinned);
    drop.strays.push_back(std::move(strays));
    return true;
  }

  void apply(DroppedClouds drop) {
    SessionUpdate update;
    const bool is_first = count_notes(session_.notes()).applied == 0;
    TriangleMesh before;
    std::size_t local_before = 0;
    std::string tried;
    try {
      tried = make_dense_enough(drop);
      if (is_first) before = session_.model();
      local_before = session_.session().local_changes();
      update = session_.session().apply(drop.clouds, job_.execution());
    } catch (const Cancelled&) {
      return;  // the interrupt; the session is as it was
    } catch (const Error& error) {
      return refuse(drop, error.what());
    }
    if (update.result.status != UpdateStatus::ok) return refuse(drop, update.result.message);
    if (is_first) add_lost_surface_warnings(before, drop, tried, update);
    // Where the surface is certain, and of all samples, there is nothing to find.
    const ReconstructResult& surface = update.result.reconstruction;
    if (session_.session().local_changes() == local_before || surface.unused_points > 0 ||
        surface.counters.boundary_samples > 0) {
      findings_are_due_ = true;
    }
    PendingUpdate applied{{}, std::move(drop.clouds), arguments_.parameters.rho};
    applied.keep_crowded = arguments_.parameters.keep_crowded;
    for (const NotedFile& file : drop.files) applied.notes.push_back(note_of_applied(file));
    session_.keep(applied);
    applied_ += drop.files.size();
    for (std::size_t k = 0; k < drop.files.size(); ++k) {
      thinned_ += drop.thinned[k];
      if (filter_.strays) append_strays(job_.report(), drop.strays[k], applied.clouds[k].size());
    }
    say(told_applied(drop, update, filter_, options_));
  }

  // The first clouds tell how dense a mesh has to be. Returns what became of a trial that was not
  // taken.
  std::string make_dense_enough(const DroppedClouds& drop) {
    if (!session_.is_mesh_of_file() || keeps_coarse(arguments_)) return {};
    UpdateInput input;
    input.model_name = arguments_.model;
    input.model = session_.model();
    input.is_mesh_of_file = true;
    input.cloud_names = drop.names;
    input.clouds = drop.clouds;
    std::string tried = app::make_dense_enough(job_, input, options_);
    if (!input.is_mesh_of_file) session_.begin_anew(std::move(input.model));
    return tried;
  }

  // A mesh that is no dense sampling of its surface loses some with its first update.
  void add_lost_surface_warnings(const TriangleMesh& model, const DroppedClouds& drop,
                                 const std::string& tried, SessionUpdate& update) const {
    const std::vector<Scan> scans = scans_of(drop.clouds, update.result.clouds);
    const LostSurface lost =
        lost_surface(model, scans, update.result, update.change, session_.model());
    std::vector<std::string>& warnings = update.result.warnings;
    if (lost.warns) {
      warnings.push_back(warning_of_lost_surface(lost, tried, arguments_.model, model));
    }
    if (lost.makes_up) warnings.push_back(warning_of_made_up_surface(lost, arguments_.model));
  }

  // What is doubtful about the model, once no cloud waits for it: that takes passes over the whole.
  void tell_findings() {
    if (!std::exchange(findings_are_due_, false)) return;
    ReconstructResult surface = session_.session().reconstruction();
    surface.mesh = session_.model();
    MeshReport certificate;
    findings_ = findings_of_update(surface, session_.session().points(),
                                   noise_filter_of_update(filter_.strays.has_value()),
                                   {.manifold = false}, {job_.execution().threads}, certificate);
    for (const Finding& finding : findings_) {
      if (!told_findings_.insert(finding.message).second) continue;
      tell(job_, finding);
    }
    flush_output();
  }

  void tell_refused(const std::string& name, const std::string& why) {
    ++refused_;
    say(fmt::format("{}: not applied: {}", name, why));
  }

  // Killed before the note is kept, the program tries the cloud again on the same model.
  void refuse(const NotedFile& file, const std::string& name, const std::string& why) {
    tell_refused(name, why);
    session_.keep({{note_of_refused(file)}, {}, arguments_.parameters.rho, true});
  }

  // What is refused together is tried one after the other: some of it may be good. That is noted,
  // so that a kill on the way does not bring what is left together again.
  void refuse(const DroppedClouds& drop, const std::string& why) {
    const std::string told = with_cloud_names(why, drop.names);
    if (drop.files.size() == 1) return refuse(drop.files[0], drop.names[0], told);
    say(fmt::format("{}: not applied together: {}; each by itself:", drop.name(), told));
    PendingUpdate apart{{}, {}, arguments_.parameters.rho, true};
    for (const NotedFile& file : drop.files) apart.notes.push_back(note_of_alone(file));
    session_.keep(apart);
    apply_each(drop);
  }

  void apply_each(const DroppedClouds& drop) {
    for (std::size_t k = 0; k < drop.files.size() && !interrupted(); ++k) apply(drop.only(k));
  }

  // False if it is time to stop.
  bool pause() const {
    const auto end = std::chrono::steady_clock::now() + to_milliseconds(arguments_.poll);
    while (!interrupted() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return !interrupted();
  }

  const WatchArguments& arguments_;
  Job& job_;
  UpdateOptions options_;
  WatchedSession session_;
  FolderWatch folder_;
  bool folder_was_read_ = false;
  bool folder_is_away_ = false;
  bool all_in_reach_ = true;
  CloudFilter filter_;
  std::size_t applied_ = 0;
  std::size_t refused_ = 0;
  std::set<fs::path> known_;
  std::size_t thinned_ = 0;        // points of clouds that were applied
  std::set<fs::path> unreadable_;  // told, and tried again
  int idle_polls_ = 0;
  bool findings_are_due_ = false;
  std::vector<Finding> findings_;        // of the last look
  std::set<std::string> told_findings_;  // each message is told once
};

}  // namespace

void run(const WatchArguments& arguments, Job& job) {
  Watch watch(arguments, job);
  if (!watch.run()) return;
  watch.report();
  job.finish();
}

}  // namespace cocoon::app
