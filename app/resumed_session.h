// A session taken up where it was left: its file, and the clouds applied since.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/files/session_file.h"
#include "geom/execution.h"
#include "update/update_session.h"

namespace cocoon::app {

struct ResumedSession {
  std::optional<UpdateSession> session;
  SurfaceArguments parameters;  // the session's own
  std::vector<std::string> notes;
  std::size_t pending = 0;  // notes that are not in the file
};

// Takes up a session with its pending clouds; `rho`, `keep_crowded` and `verify` of `parameters`
// hold for updates to come, the other parameters are the session's own. Errors: FileError;
// InputError if a pending cloud can no longer be applied.
void resume_session(const std::string& path, SavedSession saved, const SurfaceArguments& parameters,
                    const Execution& execution, ResumedSession& resumed);

}  // namespace cocoon::app
