#include "app/watch/watched_session.h"

#include <filesystem>
#include <fmt/format.h>
#include <utility>

#include "app/console/interrupt.h"
#include "app/files/session_file.h"
#include "app/initial_model.h"
#include "app/watch/watch_notes.h"
#include "geom/errors.h"
#include "geom/messages/counted.h"
#include "io/atomic_file.h"
#include "io/mesh_file.h"

namespace cocoon::app {

WatchedSession::WatchedSession(const WatchArguments& arguments, const UpdateOptions& options,
                               Job& job)
    : arguments_(arguments),
      options_(options),
      job_(job),
      file_(arguments.session.empty() ? arguments.mesh + ".session" : arguments.session) {}

bool WatchedSession::begin() {
  const std::string first_note = note_of_model(arguments_.model, arguments_.densify);
  if (std::filesystem::exists(file_)) {
    resume(first_note);
    return false;
  }
  const bool is_new = begin_session(
      job_, read_model_input(job_, arguments_.model, arguments_.densify), options_, state_.session);
  is_mesh_of_file_ = !is_new;
  state_.notes = {first_note};
  remove_pending_clouds(file_);  // of a session that somebody removed
  save_whole();
  job_.say("{}: {} vertices, {} triangles", arguments_.model, model().points.size(),
           model().triangles.size());
  return is_new;
}

void WatchedSession::resume(const std::string& first_note) {
  StopWhenInterrupted stop;
  const Execution quiet{job_.execution().threads, &stop};
  SavedSession saved = load_session(file_, quiet);
  if (saved.notes.empty() || saved.notes.front() != first_note) {
    throw InputError(file_ + ": was begun with another model than " + arguments_.model +
                     " or another --densify; remove it, or name another one by --session");
  }
  if (!same_parameters(saved.parameters, arguments_.parameters)) {
    throw InputError(file_ +
                     ": was begun with other parameters; remove it, or name another one by "
                     "--session");
  }
  resume_session(file_, std::move(saved), arguments_.parameters, quiet, state_);
  if (state_.pending == 0) remove_pending_clouds(file_);  // the kill came before that
  write_mesh(arguments_.mesh, model(), arguments_.writing);
  const NoteCounts noted = count_notes(state_.notes);
  if (noted.applied == 0 && !arguments_.densify) {
    is_mesh_of_file_ = !read_model_input(job_, arguments_.model, {}).mesh.triangles.empty();
  }
  std::string line =
      fmt::format("{}: resumed with {} applied", file_, counted(noted.applied, "cloud"));
  if (noted.refused > 0) {
    line += fmt::format(", {} refused that will not be tried again", noted.refused);
  }
  job_.say("{}", line);
}

// Session and mesh together. The session is put in place first: should the program be killed
// between the two, the mesh follows as soon as the session is taken up again.
void WatchedSession::save_whole() {
  FileBatch outputs;
  save_session(file_, {state_.session->snapshot(), arguments_.parameters, state_.notes}, &outputs);
  write_mesh(arguments_.mesh, model(), arguments_.writing, &outputs);
  job_.warn_of_rounding(outputs);
  outputs.commit();
  remove_pending_clouds(file_);
  state_.pending = 0;
  is_begun_anew_ = false;
}

void WatchedSession::keep(const PendingUpdate& update) {
  const auto note = [&] {
    state_.notes.insert(state_.notes.end(), update.notes.begin(), update.notes.end());
  };
  if (!update.refused) is_mesh_of_file_ = false;
  if (is_begun_anew_ || state_.pending + update.notes.size() >= arguments_.save_every) {
    note();
    return save_whole();
  }
  FileBatch outputs;
  save_pending_clouds(file_, state_.notes, update, outputs);
  if (!update.refused) write_mesh(arguments_.mesh, model(), arguments_.writing, &outputs);
  job_.warn_of_rounding(outputs);
  outputs.commit();
  note();
  state_.pending += update.notes.size();
}

void WatchedSession::begin_anew(TriangleMesh dense_model) {
  ModelInput dense;
  dense.mesh = std::move(dense_model);
  begin_session(job_, std::move(dense), options_, state_.session);
  is_mesh_of_file_ = false;
  is_begun_anew_ = true;
}

void WatchedSession::finish() {
  if (state_.pending > 0 && !is_begun_anew_) save_whole();
}

}  // namespace cocoon::app
