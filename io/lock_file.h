// Holds a file for this process as long as the object lives, by a lock (flock) on "FILE.lock"
// beside it: the file itself is replaced when it is written, and a lock would go with the old one.
//
//   - The lock ends with the process, however it ends; a ".lock" that a killed process has left
//     behind is taken over.
//   - It keeps out those who ask for it, nobody else.
//   - By whatever symbolic links the file is named: the ".lock" lies beside the file that they lead
//     to.
#pragma once

#include <filesystem>

namespace cocoon {

// "FILE.lock", beside the file that the links lead to.
std::filesystem::path lock_of(const std::filesystem::path& file);

class LockFile {
 public:
  // Throws FileError, one line, if another process (or object) holds it, or if there can be no
  // lock: the folder is missing or not writable, or "FILE.lock" is a link or holds something, so
  // that it is somebody else's.
  explicit LockFile(const std::filesystem::path& file);
  // Removes "FILE.lock".
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

 private:
  std::filesystem::path lock_;
  int descriptor_ = -1;
};

}  // namespace cocoon
