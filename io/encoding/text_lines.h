// The lines of a text, numbered from 1. A line ends with LF, CR LF or CR alone; the last one needs
// no end.
#pragma once

#include <cstddef>
#include <string_view>

namespace cocoon {

class TextLines {
 public:
  explicit TextLines(std::string_view text)
      : at_(text.data()), end_(text.data() + text.size()), next_newline_(at_) {}

  // Moves to the next line; false at the end of the text. Complexity: O(length of the line).
  bool next(std::string_view& line);
  // The number of the line that next() gave last; 0 before the first call.
  std::size_t number() const { return number_; }
  // What lies behind the line that next() gave last.
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  // The same without the blanks and line ends around it.
  std::string_view rest_without_blanks() const;

 private:
  const char* at_;
  const char* end_;
  const char* next_newline_;  // the first LF at or behind at_ (end_ if none), once known
  bool newline_known_ = false;
  std::size_t number_ = 0;
};

}  // namespace cocoon
