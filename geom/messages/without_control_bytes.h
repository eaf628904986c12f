// What names of files may hold, and messages must not.
#pragma once

#include <string>

namespace cocoon {

// The line as a terminal may get it: control bytes are '?'. Complexity: O(bytes).
std::string without_control_bytes(std::string line);

}  // namespace cocoon
