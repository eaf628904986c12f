// A folder that a command makes for its outputs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cocoon::app {

// A folder for outputs. What was made of it, and is empty in the end, is taken away again.
class OutputFolder {
 public:
  // Makes the folder, and those it lies in, if needed. Throws FileError if that is not possible.
  explicit OutputFolder(const std::string& path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  // the innermost first
};

}  // namespace cocoon::app
