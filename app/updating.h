// An update as `update` and `demo` run it, from what was read to the outputs.
#pragma once

#include <string>

#include "app/job.h"
#include "app/update_input.h"
#include "io/mesh_file_options.h"
#include "update/checks/lost_surface.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon::app {

// What came out, and what was lost of the model.
struct UpdateOutcome {
  SessionUpdate update;
  LostSurface lost;   // if it is ok
  std::string tried;  // what became of a trial to make the model dense (coarse_model.h) that was
                      // not taken; empty: there was none
};

// What to write; empty: not wanted.
struct UpdateOutput {
  std::string mesh;
  std::string map;  // one line per vertex of the model's file: its new index, or -1
  std::string html;
  MeshWriteOptions writing;
  bool manifold = false;
  bool keeps_session = false;  // a session is written, too
};

// Updates the model, by the session, if there is one, whose model is then input.model. The result
// need not be ok. Throws InputError as update_model.
UpdateOutcome updated(Job& job, const UpdateInput& input, const UpdateOptions& options,
                      UpdateSession* session = nullptr);

// Writes the outputs, which wait for job.finish, and fills in the report. Throws InputError, with
// the library's explanation, if there is no updated model; then nothing is written.
void write_update(Job& job, const UpdateInput& input, UpdateOutcome outcome,
                  const UpdateOptions& options, const UpdateOutput& output);

}  // namespace cocoon::app
