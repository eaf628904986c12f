// A whole input file in memory, and the errors that name a place in it.
//
// Readers parse one buffer in one pass: the peak is the file's size plus the arrays that are built
// from it, and the buffer is gone before any stage runs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "geom/errors.h"

namespace cocoon {

struct FileBytes {
  std::filesystem::path path;
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  std::string_view view() const { return {data.get(), size}; }
};

// Reads the whole file; pipes and devices are read to their end. Throws FileError if it cannot be
// opened or read, if it is a folder, or if its first bytes say that it is packed, or no more than a
// pointer of Git LFS to the file. Complexity: O(bytes).
FileBytes read_file(const std::filesystem::path& path);

// The text of a file, without the UTF-8 byte order mark that some editors put first. Throws
// FileError for what is not 8-bit text (a NUL byte, a UTF-16 byte order mark), naming the byte.
std::string_view text_of(const FileBytes& file);

// The name of a file as messages show it: one line, whatever the name holds.
std::string display_name(const std::filesystem::path& path);

// "NAME: message", "NAME:LINE: message" (lines count from 1; 0 = no line to name).
FileError file_error(const std::filesystem::path& path, const std::string& message);
FileError file_error(const std::filesystem::path& path, std::size_t line,
                     const std::string& message);

// `text` as a message can show it: quoted, cut after some 30 bytes, control bytes replaced.
std::string in_quotes(std::string_view text);

// Counts coordinates that are not finite while a file is read, so that the error can say how many
// there are and where the first one is. Nothing is dropped: finish() throws.
class NonFinitePoints {
 public:
  // `line` 0: the format has no lines.
  void note(std::size_t index, std::size_t line);
  // Throws NonFiniteError (mesh_file_options.h) if any was noted.
  void finish(const std::filesystem::path& path, bool can_be_skipped) const;

 private:
  std::size_t count_ = 0;
  std::size_t first_index_ = 0;
  std::size_t first_line_ = 0;
};

}  // namespace cocoon
