// Output that appears complete or not at all: bytes go to a temporary file beside the target, which
// is renamed over the target when all is written.
//
//   - The temporary lies in the target's folder, without a name until just before the rename where
//     the system can do that (io/part_file.h). It is removed if anything fails. The old file is
//     never touched before the rename.
//   - The bytes are on the disk (fsync) before the rename, so that after a power cut the name holds
//     the old file or the new one, never half of one. The folder itself is not synced: the cut may
//     bring back the old file.
//   - A new file gets the permissions that the umask gives; a replaced file keeps its own. Owner
//     and extended attributes are not kept, and hard links to the old file keep the old bytes.
//   - A symbolic link stays: the file it leads to is replaced.
//   - A target that exists and is no regular file (/dev/full, a pipe) cannot be replaced: it is
//     opened and written directly, and a failure may leave a part in it. So is a descriptor of this
//     process (/dev/stdout, /dev/fd/3, links to such), whatever it leads to: it is duplicated, so
//     that what it is open for holds, and writing goes on where it stands (`>> log`).
//   - Several files of one job appear one right after the other, or none of them: see FileBatch.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/float_rounding.h"
#include "io/part_file.h"

namespace cocoon {

// The path behind all symbolic links in the last component, also if it does not exist yet; one that
// is a link still for a loop of them.
std::filesystem::path follow_links(std::filesystem::path path);

// The descriptor of this process that a path names, through links (/dev/stdout, /dev/fd/3); -1:
// none. What is open already is written as it is, not replaced.
int own_descriptor(std::filesystem::path path);

// A file in which a mesh is noticeably another one than was written.
struct RoundedFile {
  std::filesystem::path target;
  FloatRounding rounding;
};

// Files that wait to appear together: complete and on the disk, each as a temporary file. What can
// fail while a job writes its outputs (a full disk above all) fails before the first target is
// touched.
class FileBatch {
 public:
  FileBatch() = default;  // without commit() the temporary files are removed
  FileBatch(const FileBatch&) = delete;
  FileBatch& operator=(const FileBatch&) = delete;

  // Puts the files in their places, in the order in which they came. Throws FileError if one of
  // them cannot be renamed (its target became a folder meanwhile); those before it are in place
  // then, those after it are removed.
  void commit();

  // What is to be told of files before they appear: by their writers, and taken by who tells it.
  void note(RoundedFile file) { rounded_.push_back(std::move(file)); }
  std::vector<RoundedFile> take_rounded() { return std::exchange(rounded_, {}); }

 private:
  friend class AtomicFile;
  struct Waiting {
    std::filesystem::path target;  // as the caller named it
    PartFile part;
  };
  std::vector<Waiting> waiting_;
  std::vector<RoundedFile> rounded_;
};

class AtomicFile {
 public:
  // Opens the temporary file. Throws FileError if the folder is missing or not writable, or if the
  // target is a folder.
  explicit AtomicFile(const std::filesystem::path& target);
  // Without commit(): removes the temporary file.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // Appends bytes; they are buffered. Throws FileError if the disk is full or fails. That the
  // reader of standard output has gone is no error: he has what he wanted.
  void write(std::string_view bytes);

  // As the caller named it.
  const std::filesystem::path& target() const { return target_; }

  // A buffer that writers append to directly, calling flush_if_full() now and then (once per
  // element): saves a copy of every number.
  std::string& buffer() { return buffer_; }
  void flush_if_full() {
    if (buffer_.size() >= buffer_limit) flush();
  }

  // Completes the file and puts it in its place, or hands it over to a batch that will. Throws
  // FileError; then the old file is intact.
  void commit(FileBatch* batch = nullptr);

 private:
  static constexpr std::size_t buffer_limit = std::size_t{1} << 16;

  void flush();
  // If there is an error, throws FileError and removes the temporary file.
  void require(int error_number, const char* action = "cannot be written");

  std::filesystem::path target_;  // as the caller named it, for messages
  PartFile part_;
  int direct_ = -1;  // what is written directly: its descriptor
  bool is_standard_output_ = false;
  std::string buffer_;
};

// Writes `bytes` as the whole content of `target`, through an AtomicFile.
void write_file(const std::filesystem::path& target, std::string_view bytes,
                FileBatch* batch = nullptr);

}  // namespace cocoon
