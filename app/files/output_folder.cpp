#include "app/files/output_folder.h"

#include <system_error>

#include "geom/errors.h"

namespace cocoon::app {

namespace fs = std::filesystem;

namespace {

// From the innermost on, until something is in one.
void remove_empty(const std::vector<fs::path>& folders) {
  std::error_code error;
  for (const fs::path& folder : folders) fs::remove(folder, error);
}

}  // namespace

OutputFolder::OutputFolder(const std::string& path) {
  std::error_code error;
  for (fs::path folder = fs::absolute(path); !fs::exists(folder, error) && !error;
       folder = folder.parent_path()) {
    made_.push_back(folder);
  }
  fs::create_directories(path, error);
  if (!error) return;
  remove_empty(made_);
  throw FileError(path + ": cannot make this folder: " + error.message() + "; name another one");
}

OutputFolder::~OutputFolder() { remove_empty(made_); }

}  // namespace cocoon::app
