// The session that `watch` goes on with, and what it keeps of it on disk.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/files/pending_clouds.h"
#include "app/job.h"
#include "app/resumed_session.h"
#include "geom/triangle_mesh.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon::app {

// Invariant, from begin() on: whenever the program is killed, session file and pending clouds
// together tell of all that keep() was told, and the mesh file is that model or an earlier one,
// which begin() mends. Keeps references, which must outlive the object.
class WatchedSession {
 public:
  WatchedSession(const WatchArguments& arguments, const UpdateOptions& options, Job& job);

  // Beside the mesh, if no other is named.
  const std::string& file() const { return file_; }

  // Goes on from where the last run stopped, or begins with the model, and says so. Whether that
  // was made from points, of which nobody was told yet what is doubtful. Precondition: the
  // session's file is locked. Errors: FileError; InputError for a session of another model or with
  // other parameters, and for a model that gives no surface.
  bool begin();

  // The rest: after begin().
  UpdateSession& session() { return *state_.session; }
  const TriangleMesh& model() const { return state_.session->model(); }
  const std::vector<std::string>& notes() const { return state_.notes; }
  // The model is the mesh of the file, as it is; no cloud has changed it.
  bool is_mesh_of_file() const { return is_mesh_of_file_; }

  // Goes on with this mesh instead, on disk from the next keep() on. Precondition:
  // is_mesh_of_file().
  void begin_anew(TriangleMesh dense_model);

  // After clouds were applied to the session, or refused: writes the mesh, and the clouds beside
  // the session or, after so many (--save-every) and if it was begun anew, all of it. Errors:
  // FileError.
  void keep(const PendingUpdate& update);

  // Takes what is beside the session into its file. Errors: FileError.
  void finish();

 private:
  void resume(const std::string& first_note);
  void save_whole();

  const WatchArguments& arguments_;
  const UpdateOptions& options_;
  Job& job_;
  std::string file_;
  ResumedSession state_;
  bool is_mesh_of_file_ = false;
  bool is_begun_anew_ = false;  // of which the disk does not know yet
};

}  // namespace cocoon::app
