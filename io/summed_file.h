// Binary files that end with a checksum of all their bytes.
//
// Checksum: h = 0; for each 64-bit little-endian word w: h = (h xor w) * 0x9E3779B97F4A7C15,
// h = h xor (h >> 32). Every change of one word changes it; other damage is missed with a chance of
// about 2^-64. It guards against accidents, not against forgery.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "io/atomic_file.h"
#include "io/encoding/byte_order.h"
#include "io/file_bytes.h"
#include "io/input_file.h"

namespace cocoon {

inline constexpr std::size_t checksum_size = 8;

constexpr std::size_t round_up_to_8(std::size_t size) { return (size + 7) / 8 * 8; }

class Checksum {
 public:
  void add(std::string_view bytes);
  // Precondition: the bytes so far are whole words.
  std::uint64_t value() const { return hash_; }

 private:
  void add_word(const char* word);

  std::uint64_t hash_ = 0;
  std::array<char, 8> begun_{};  // of the next word, the first bytes
  std::size_t num_begun_ = 0;
};

// Of bytes, with zeros up to a multiple of 8. Complexity: O(bytes).
std::uint64_t checksum_of(std::string_view bytes);

// Writes such a file; it appears complete or not at all (atomic_file.h). Errors: FileError.
class SummedFile {
 public:
  explicit SummedFile(const std::filesystem::path& path) : file_(path) {}

  // Little-endian. Precondition: aligned to the size of T, so that words come out whole.
  template <class T>
  void append(T value) {
    append_little_endian(bytes_, value);
    if (bytes_.size() >= limit && bytes_.size() % 8 == 0) flush();
  }
  void append(std::string_view text) { bytes_ += text; }
  // The numbers of type T that the records are made of, one after the other.
  template <class T, class Record>
  void append_numbers(std::span<const Record> records) {
    static_assert(std::is_arithmetic_v<T> && std::is_trivially_copyable_v<Record> &&
                  sizeof(Record) % sizeof(T) == 0 && limit % sizeof(T) == 0);
    const char* at = reinterpret_cast<const char*>(records.data());
    for (std::size_t left = records.size_bytes(); left > 0;) {
      const std::size_t taken = std::min(left, limit - bytes_.size() % limit);
      append_in_order(at, taken, sizeof(T));
      at += taken;
      left -= taken;
      if (bytes_.size() >= limit && bytes_.size() % 8 == 0) flush();
    }
  }
  // Zero bytes up to a multiple of 8.
  void fill_word() { bytes_.resize(round_up_to_8(bytes_.size()), '\0'); }
  // Appends the checksum and puts the file in its place, or hands it over to a batch that will.
  void commit(FileBatch* batch = nullptr);

 private:
  static constexpr std::size_t limit = std::size_t{1} << 16;
  void flush();
  // Precondition: a multiple of the width of a number.
  void append_in_order(const char* numbers, std::size_t size, std::size_t width);

  AtomicFile file_;
  Checksum checksum_;
  std::string bytes_;
};

// Reads such a file piece by piece, right to where its numbers belong, and sums up on the way. What
// it gives may be damaged until finish() has returned.
class SummedReader {
 public:
  // Throws FileError, with `kind` ("session file") in its message, for a file that cannot be read,
  // does not begin with `magic`, or is not made of whole words. `remedy`: what to do about a file
  // that is damaged ("write it again").
  SummedReader(const std::filesystem::path& path, std::string_view magic, std::string_view kind,
               std::string_view remedy);

  const std::filesystem::path& path() const { return file_.path(); }
  // Bytes that are left before the checksum.
  std::size_t left() const { return left_; }
  // The next number, the next records made of numbers of type T, the next text. Throw FileError if
  // the file cannot be read on. Precondition: so many bytes are left.
  template <class T>
  T next() {
    T value;
    fill<T>(std::span<T>(&value, 1));
    return value;
  }
  template <class T, class Record>
  void fill(std::span<Record> records) {
    static_assert(std::is_arithmetic_v<T> && std::is_trivially_copyable_v<Record> &&
                  sizeof(Record) % sizeof(T) == 0);
    if (records.empty()) return;
    const std::span<char> bytes(reinterpret_cast<char*>(records.data()), records.size_bytes());
    read(bytes);
    if (std::endian::native != std::endian::little) reverse_each(bytes, sizeof(T));
  }
  std::string take(std::size_t size);
  // Passes over zero bytes up to a multiple of 8.
  void skip_to_word() { take(left_ % 8); }

  // Passes over what is left. Throws FileError if the checksum is wrong.
  void finish();

 private:
  void read(std::span<char> bytes);
  void read_unsummed(char* to, std::size_t size);

  InputFile file_;
  std::string remedy_;
  std::optional<FileBytes> whole_;  // of what is no regular file
  std::size_t at_ = 0;              // in it
  std::size_t left_ = 0;
  Checksum checksum_;
};

}  // namespace cocoon
