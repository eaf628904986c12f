// Which options of a command need each other, or go not together: rules that hold whatever the
// files are. (Which arguments there must be is in command_line.cpp.)
#pragma once

#include "app/command_line.h"

namespace cocoon::app {

// Throws UsageError, one line, for the first rule that is broken. Looks at no file.
void require_possible_options(const Command& command);

}  // namespace cocoon::app
