// A file that is read from its beginning to its end.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "geom/errors.h"

namespace cocoon {

// The system does not give the bytes of a file: it is not there, permissions or a device are in the
// way. What the bytes say is not to blame, and the same file may be read later.
class UnreadableFile : public FileError {
 public:
  using FileError::FileError;
};

class InputFile {
 public:
  // Throws UnreadableFile if it cannot be opened, or if it is a folder.
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // In bytes; none for pipes and devices.
  std::optional<std::size_t> size() const { return size_; }
  // Reads the next bytes, up to `most`; returns how many, less only at the end. Throws
  // UnreadableFile.
  std::size_t read(char* to, std::size_t most);

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::optional<std::size_t> size_;
};

// Throws UnreadableFile, as the constructor does, if there is nothing at that path, or a folder.
// Opens nothing: a pipe would wait. O(1).
void require_input(const std::filesystem::path& path);

}  // namespace cocoon
