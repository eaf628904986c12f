#include "io/file_bytes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "geom/arrays/large_pages.h"
#include "geom/messages/without_control_bytes.h"
#include "io/input_file.h"
#include "io/mesh_file_options.h"

namespace cocoon {

namespace {

constexpr std::size_t growth_step = std::size_t{1} << 20;  // for files whose size is not known

// What stands for a file in the place of it: packed by another program, or left by Git LFS.
void refuse_stand_ins(const FileBytes& file) {
  using namespace std::string_view_literals;
  constexpr std::array<std::array<std::string_view, 2>, 5> packers = {
      {{"gzip"sv, "\x1F\x8B\x08"sv},
       {"zip"sv, "PK\3\4"sv},
       {"bzip2"sv, "BZh91AY&SY"sv},
       {"xz"sv,
        "\xFD"
        "7zXZ\0"sv},
       {"zstd"sv, "\x28\xB5\x2F\xFD"sv}}};
  for (const auto& [name, beginning] : packers) {
    if (!file.view().starts_with(beginning)) continue;
    throw file_error(file.path, "is packed (" + std::string(name) + "); unpack it first");
  }
  if (file.view().starts_with("version https://git-lfs.github.com/spec/")) {
    throw file_error(file.path, "is a pointer of Git LFS, not the file itself; run 'git lfs pull'");
  }
}

}  // namespace

FileBytes read_file(const std::filesystem::path& path) {
  InputFile input(path);
  FileBytes file;
  file.path = path;
  // One byte more than announced, so that the read that finds the end needs no new room.
  std::size_t capacity = input.size().value_or(0) > 0 ? *input.size() + 1 : growth_step;
  file.data.reset(new char[capacity]);
  prefer_large_pages(file.data.get(), capacity);
  while (true) {
    if (file.size == capacity) {
      capacity += std::max(capacity, growth_step);
      std::unique_ptr<char[]> larger(new char[capacity]);
      std::memcpy(larger.get(), file.data.get(), file.size);
      file.data = std::move(larger);
    }
    file.size += input.read(file.data.get() + file.size, capacity - file.size);
    if (file.size < capacity) break;
  }
  refuse_stand_ins(file);
  return file;
}

std::string_view text_of(const FileBytes& file) {
  std::string_view text = file.view();
  if (text.empty()) throw file_error(file.path, "is empty (0 bytes); was it written completely?");
  if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE")) {
    throw file_error(file.path, "is UTF-16 text; save it as plain ASCII or UTF-8");
  }
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const void* nul = text.empty() ? nullptr : std::memchr(text.data(), 0, text.size());
  if (nul != nullptr) {
    const auto offset = static_cast<const char*>(nul) - file.data.get();
    throw file_error(file.path, "byte " + std::to_string(offset) +
                                    " is NUL, so this is no text file; check the extension");
  }
  return text;
}

std::string display_name(const std::filesystem::path& path) {
  return without_control_bytes(path.string());
}

FileError file_error(const std::filesystem::path& path, const std::string& message) {
  return FileError(display_name(path) + ": " + message);
}

FileError file_error(const std::filesystem::path& path, std::size_t line,
                     const std::string& message) {
  if (line == 0) return file_error(path, message);
  return FileError(display_name(path) + ":" + std::to_string(line) + ": " + message);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 30;
  std::string result = "'";
  for (char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte >= 0x7F ? '?' : c;
  }
  return result + (text.size() > longest ? "...'" : "'");
}

void NonFinitePoints::note(std::size_t index, std::size_t line) {
  if (count_ == 0) {
    first_index_ = index;
    first_line_ = line;
  }
  ++count_;
}

void NonFinitePoints::finish(const std::filesystem::path& path, bool can_be_skipped) const {
  if (count_ == 0) return;
  std::string message = "point " + std::to_string(first_index_) +
                        " (counted from 0) has a coordinate that is not a finite number";
  if (count_ > 1) message += ", and so have " + std::to_string(count_ - 1) + " more";
  message += "; remove or repair such points";
  throw NonFiniteError(file_error(path, first_line_, message).what(), can_be_skipped);
}

}  // namespace cocoon
