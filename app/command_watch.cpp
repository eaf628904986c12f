#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/console/interrupt.h"
#include "app/console/standard_streams.h"
#include "app/files/files.h"
#include "app/files/model_file.h"
#include "app/files/pending_clouds.h"
#include "app/files/session_file.h"
#include "app/report/findings.h"
#include "app/report/update_report.h"
#include "app/resumed_session.h"
#include "app/shapes/cloud_filter.h"
#include "app/shapes/densify.h"
#include "app/shapes/thin_cloud.h"
#include "app/updating.h"
#include "app/watch/folder_watch.h"
#include "app/watch/watch_notes.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "geom/messages/counted.h"
#include "io/file_bytes.h"
#include "io/input_file.h"
#include "io/lock_file.h"
#include "io/mesh_file.h"

namespace cocoon::app {

namespace {

namespace fs = std::filesystem;

// Files that are clouds, as they were when they were read, and are applied together.
struct Drop {
  std::chrono::steady_clock::time_point start;
  std::vector<NotedFile> files;
  std::vector<std::string> names;  // as messages show them
  std::vector<std::vector<Point>> clouds;
  std::vector<std::size_t> thinned;  // how many points --thin left out of each
  std::vector<StraySamples> strays;  // what --noise robust left out of each
  bool has_to_wait = false;          // one of those that belong to it was being written

  std::string name() const { return fmt::format("{}", fmt::join(names, ", ")); }
  // One of several, alone.
  Drop only(std::size_t k) const {
    const auto now = std::chrono::steady_clock::now();
    return {now, {files[k]}, {names[k]}, {clouds[k]}, {thinned[k]}, {strays[k]}, false};
  }
};

StraySamples total_of(const std::vector<StraySamples>& strays) {
  StraySamples total;
  for (const StraySamples& some : strays) {
    total.outliers += some.outliers;
    total.in_small_parts += some.in_small_parts;
    total.small_parts += some.small_parts;
  }
  return total;
}

class Watch {
 public:
  Watch(const WatchArguments& arguments, Job& job)
      : arguments_(arguments),
        job_(job),
        session_file_(arguments.session.empty() ? arguments.mesh + ".session" : arguments.session),
        folder_(arguments.folder, to_milliseconds(arguments.settle), own_files()),
        options_(update_options(arguments.parameters)),
        filter_(cloud_filter(arguments.filter)) {
    require_outputs(
        job, {{arguments.mesh, mesh_extensions}, {.path = session_file_, .is_session = true}},
        {arguments.model});
    require_folder(arguments.folder);
    constexpr std::size_t most_notes = std::numeric_limits<std::uint32_t>::max();
    require_possible_name(pending_cloud_file(session_file_, most_notes));
  }

  void run() {
    const LockFile lock(session_file_);
    begin();
    follow_folder();
    if (state_.pending > 0) save_whole();
    tell_findings();
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
    add_filter(job_.report(), filter_, thinned_);
    add_update_parameters(job_.report(), options_);
    add_model(job_.report(), state_.session->reconstruction(), model(),
              mesh_check(model(), {}, job_.execution()));
    add_findings(job_.report(), findings_);
    job_.say("stopped: {} applied, {} refused, {} known from before", counted(applied_, "cloud"),
             refused, known_.size());
  }

 private:
  // What may lie in the folder, and is no cloud.
  std::vector<fs::path> own_files() const {
    std::vector<fs::path> files = {arguments_.model, arguments_.mesh, session_file_};
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

  // From where the last run stopped, or from the model.
  void begin() {
    const std::string first_note = note_of_model(arguments_.model, arguments_.densify);
    if (fs::exists(session_file_)) {
      SavedSession saved = load_session(session_file_, {job_.execution().threads});
      if (saved.notes.empty() || saved.notes.front() != first_note) {
        throw InputError(session_file_ + ": was begun with another model than " + arguments_.model +
                         " or another --densify; remove it, or name another one by --session");
      }
      if (!same_parameters(saved.parameters, arguments_.parameters)) {
        throw InputError(session_file_ +
                         ": was begun with other parameters; remove it, or name "
                         "another one by --session");
      }
      resume_session(session_file_, std::move(saved), arguments_.parameters,
                     {job_.execution().threads}, state_);
      write_mesh(arguments_.mesh, model(), arguments_.writing);
      const NoteCounts noted = count_notes(state_.notes);
      std::string line = fmt::format("{}: resumed with {} applied", session_file_,
                                     counted(noted.applied, "cloud"));
      if (noted.refused > 0) {
        line += fmt::format(", {} refused that will not be tried again", noted.refused);
      }
      say(line);
    } else {
      begin_with_model();
      state_.notes = {first_note};
      remove_pending_clouds(session_file_);  // of a session that somebody removed
      save_whole();
      say(fmt::format("{}: {} vertices, {} triangles", arguments_.model, model().points.size(),
                      model().triangles.size()));
    }
  }

  void begin_with_model() {
    DensifiedMesh dense;
    if (arguments_.densify) {
      dense = read_densified(job_, arguments_.model, *arguments_.densify);
    } else {
      TriangleMesh mesh = read_model(job_, arguments_.model, "input").mesh;
      if (!mesh.triangles.empty()) {
        orient_model(job_, arguments_.model, "input", mesh);
        state_.session.emplace(std::move(mesh), options_);
        return;
      }
      dense.points = std::move(mesh.points).raw();
    }
    begin_session(job_, arguments_.model, dense.points, dense.labels, options_, state_.session);
    if (arguments_.densify) {
      warn_of_handles(job_, arguments_.model, dense, mesh_check(model(), {}, job_.execution()));
    }
    findings_are_due_ = true;
  }

  const TriangleMesh& model() const { return state_.session->model(); }

  // Session and mesh together. The session is put in place first: should the program be killed
  // between the two, the mesh follows as soon as the session is taken up again.
  void save_whole() {
    FileBatch outputs;
    save_session(session_file_, {state_.session->snapshot(), arguments_.parameters, state_.notes},
                 &outputs);
    write_mesh(arguments_.mesh, model(), arguments_.writing, &outputs);
    job_.warn_of_rounding(outputs);
    outputs.commit();
    remove_pending_clouds(session_file_);
    state_.pending = 0;
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

  // After clouds were applied or refused: the same with the clouds in place of the session, as a
  // rule.
  void keep(const PendingUpdate& update) {
    const auto note = [&] {
      state_.notes.insert(state_.notes.end(), update.notes.begin(), update.notes.end());
    };
    if (state_.pending + update.notes.size() >= arguments_.save_every) {
      note();
      return save_whole();
    }
    FileBatch outputs;
    save_pending_clouds(session_file_, state_.notes, update, outputs);
    if (!update.refused) {
      write_mesh(arguments_.mesh, model(), arguments_.writing, &outputs);
    }
    job_.warn_of_rounding(outputs);
    outputs.commit();
    note();
    state_.pending += update.notes.size();
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
    Drop drop;
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
                    [&](const NotedFile& file) { return is_to_be_alone(state_.notes, file); });
    if (are_alone) return apply_each(drop);
    apply(std::move(drop));
  }

  // False: the interrupt.
  bool read(const FolderWatch::CompleteFile& file, Drop& drop) {
    const std::string name = display_name(file.path.filename());
    NotedFile noted;
    std::vector<Point> cloud;
    std::string no_cloud;  // why it is none
    try {
      noted = noted_file(file.path, file.changed);
      if (file.was_there && is_noted(state_.notes, noted)) {
        known_.insert(file.path);
        return true;
      }
      cloud = read_cloud(job_, file.path.string(), "input");
    } catch (const Cancelled&) {
      return false;
    } catch (const UnreadableFile& error) {
      folder_.try_again(file.path);
      if (!unreadable_.insert(file.path).second) return true;
      say(fmt::format("{}: not applied: {}; it is tried again until it can be read", name,
                      error.what()));
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

  void apply(Drop drop) {
    SessionUpdate update;
    const std::size_t local_before = state_.session->local_changes();
    try {
      update = state_.session->apply(drop.clouds, job_.execution());
    } catch (const Cancelled&) {
      return;  // the interrupt; the session is as it was
    } catch (const Error& error) {
      return refuse(drop, error.what());
    }
    if (update.result.status != UpdateStatus::ok) return refuse(drop, update.result.message);
    // Where the surface is certain, and of all samples, there is nothing to find.
    const ReconstructResult& surface = update.result.reconstruction;
    if (state_.session->local_changes() == local_before || surface.unused_points > 0 ||
        surface.counters.boundary_samples > 0) {
      findings_are_due_ = true;
    }
    PendingUpdate applied{{}, std::move(drop.clouds), arguments_.parameters.rho};
    for (const NotedFile& file : drop.files) applied.notes.push_back(note_of_applied(file));
    keep(applied);
    applied_ += drop.files.size();
    for (std::size_t k = 0; k < drop.files.size(); ++k) {
      thinned_ += drop.thinned[k];
      if (filter_.strays) append_strays(job_.report(), drop.strays[k], applied.clouds[k].size());
    }
    tell_applied(drop, update);
  }

  void tell_applied(const Drop& drop, const SessionUpdate& update) {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - drop.start;
    std::string line = fmt::format(
        "{}: {} points for {} of the model, {} triangles new, {} gone, {:.2f} s", drop.name(),
        update.result.reconstruction.points - update.result.replacement.kept,
        update.result.replacement.replaced, update.change.added.size(),
        update.change.removed.size(), time.count());
    const std::string topology = topology_change(update.result);
    if (!topology.empty()) line += "; " + topology;
    if (filter_.thin) {
      const std::size_t thinned =
          std::accumulate(drop.thinned.begin(), drop.thinned.end(), std::size_t{0});
      line += fmt::format("; {} left out by --thin", counted(thinned, "point"));
    }
    if (filter_.strays) {
      line += fmt::format("; {} left out as noise", told_strays(total_of(drop.strays)));
    }
    for (const std::string& note :
         notes_of_uneven_clouds(update.result, drop.names, options_.cloud.density)) {
      line += "; note: " + note;
    }
    for (const std::string& warning : update.result.warnings) {
      line += "; warning: " + with_cloud_names(warning, drop.names);
    }
    say(line);
  }

  // What is doubtful about the model, once no cloud waits for it: that takes passes over the whole.
  void tell_findings() {
    if (!std::exchange(findings_are_due_, false)) return;
    ReconstructResult surface = state_.session->reconstruction();
    surface.mesh = model();
    MeshReport certificate;
    findings_ = findings_of_update(surface, state_.session->points(),
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
    keep({{note_of_refused(file)}, {}, arguments_.parameters.rho, true});
  }

  // What is refused together is tried one after the other: some of it may be good. That is noted,
  // so that a kill on the way does not bring what is left together again.
  void refuse(const Drop& drop, const std::string& why) {
    const std::string told = with_cloud_names(why, drop.names);
    if (drop.files.size() == 1) return refuse(drop.files[0], drop.names[0], told);
    say(fmt::format("{}: not applied together: {}; each by itself:", drop.name(), told));
    PendingUpdate apart{{}, {}, arguments_.parameters.rho, true};
    for (const NotedFile& file : drop.files) apart.notes.push_back(note_of_alone(file));
    keep(apart);
    apply_each(drop);
  }

  void apply_each(const Drop& drop) {
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
  std::string session_file_;
  FolderWatch folder_;
  bool folder_was_read_ = false;
  bool folder_is_away_ = false;
  bool all_in_reach_ = true;
  UpdateOptions options_;
  CloudFilter filter_;
  ResumedSession state_;
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

void run_watch(const WatchArguments& arguments, Job& job) {
  Watch watch(arguments, job);
  watch.run();
  watch.report();
  job.finish();
}

}  // namespace cocoon::app
