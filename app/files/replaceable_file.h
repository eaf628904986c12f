// Whether a file can be replaced by a rename.
#pragma once

#include <filesystem>
#include <string>

namespace cocoon::app {

// Why nothing can be renamed over `target` though its folder can be written: "it is ...". Empty: it
// can, or there is no such file. Known are mount points, as containers make of single files, files
// with the attributes +i and +a, and files of others in sticky folders like /tmp, all of Linux; on
// other systems nothing is. Precondition: no link. Complexity: O(1).
std::string obstacle_to_replacing(const std::filesystem::path& target);

}  // namespace cocoon::app
