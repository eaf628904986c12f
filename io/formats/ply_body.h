// The values behind a PLY header, one after the other: from text lines or from bytes.
//
// Both classes have the same functions, so that one reader serves the three encodings:
//   begin_element(name, index)  the values that follow belong to this element
//   number(type)                the next value as a double
//   integer(type)               the next value as a whole number
//   list_length(type, type)     the length of a list whose values of the second type follow
//   skip(type, count)           leaves out values
//   append(type, count, bytes)  appends values of this type, little endian, with their bits; false
//                               if one of them is no such value (ascii only): it is then behind us
//                               with all the others, but not appended
//   line()                      of the element, 0 in a binary file
//   end_element()
// All but append() throw FileError if the value cannot be what is asked for; all do if it is
// missing. Complexity: O(bytes passed) each.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/encoding/number_text.h"
#include "io/encoding/text_lines.h"
#include "io/file_bytes.h"
#include "io/formats/ply_header.h"

namespace cocoon {

// One element is one line; blank lines do not count. Some programs write an element in several
// lines (librealsense does): they are one if the last one holds what is missing and nothing else,
// so that a line with too few values is not completed by the next element.
class PlyTextBody {
 public:
  PlyTextBody(const FileBytes& file, const PlyHeader& header);

  void begin_element(const PlyElement& element, std::size_t index);
  double number(PlyType type);
  std::int64_t integer(PlyType type);
  std::size_t list_length(PlyType count_type, PlyType type);
  void skip(PlyType type, std::size_t count);
  bool append(PlyType type, std::size_t count, std::string& bytes);
  void end_element();
  std::size_t line() const { return header_lines_ + lines_.number(); }
  std::size_t surplus_lines() const { return surplus_lines_; }
  std::size_t first_surplus_line() const { return first_surplus_line_; }
  std::size_t trailing_bytes() const { return lines_.rest_without_blanks().size(); }

 private:
  // To the next line if this one has no value left.
  void go_on_behind_short_line(const char* expected);
  std::string_view next_word();
  [[noreturn]] void fail_value(const char* expected);
  [[noreturn]] void fail_short_line() const;

  const FileBytes& file_;
  std::size_t header_lines_;
  TextLines lines_;
  Fields fields_{std::string_view()};
  std::size_t short_line_ = 0;  // where the element had too few values; 0: it has not
  const char* expected_there_ = "";
  std::size_t surplus_lines_ = 0;
  std::size_t first_surplus_line_ = 0;
};

class PlyBinaryBody {
 public:
  PlyBinaryBody(const FileBytes& file, const PlyHeader& header);

  void begin_element(const PlyElement& element, std::size_t index) {
    element_ = &element;
    index_ = index;
  }
  double number(PlyType type);
  std::int64_t integer(PlyType type);
  std::size_t list_length(PlyType count_type, PlyType type);
  void skip(PlyType type, std::size_t count);
  bool append(PlyType type, std::size_t count, std::string& bytes);
  void end_element() {}
  std::size_t line() const { return 0; }
  std::size_t surplus_lines() const { return 0; }
  std::size_t first_surplus_line() const { return 0; }
  std::size_t trailing_bytes() const { return static_cast<std::size_t>(end_ - at_); }

 private:
  // The next `count` values of `size` bytes, which are then behind us.
  const char* take(std::size_t size, std::size_t count = 1);
  std::string place() const;

  const FileBytes& file_;
  const char* at_;
  const char* end_;
  std::endian order_;
  const PlyElement* element_ = nullptr;
  std::size_t index_ = 0;
};

}  // namespace cocoon
