// The bytes of a file to come, in the folder where it is to be (a rename across file systems would
// be a copy): without a name, where the system can do that (O_TMPFILE), so that a process that is
// killed leaves nothing behind; elsewhere as ".NAME.cocoon-PID-N.part". What is not put in its
// place is removed.
#pragma once

#include <filesystem>
#include <string_view>

namespace cocoon {

// Functions that return int return the error number of the system; 0: done. In this order: open(),
// write() any number of times, complete(), give_name(), rename_to_place().
class PartFile {
 public:
  PartFile() = default;
  ~PartFile() { discard(); }
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&& other) noexcept;

  // `place`: where the file is to be, behind all symbolic links. Permissions follow the umask.
  [[nodiscard]] int open(const std::filesystem::path& place);
  [[nodiscard]] int set_permissions(unsigned mode) const;
  [[nodiscard]] int write(std::string_view bytes) const;
  // The bytes are on the disk then (fsync).
  [[nodiscard]] int complete() const;
  // A temporary one beside the place, where it has none: the last step that needs space.
  [[nodiscard]] int give_name();
  [[nodiscard]] int rename_to_place();
  void discard() noexcept;

 private:
  bool open_unnamed();
  // Calls take(candidate), which returns an error number, for names that no file has.
  template <class Take>
  int take_name(Take take);

  std::filesystem::path place_;
  std::filesystem::path name_;  // empty: none yet
  int descriptor_ = -1;
};

// Writes all bytes. Returns the error number of the system; 0: done.
[[nodiscard]] int write_all(int descriptor, std::string_view bytes);

}  // namespace cocoon
