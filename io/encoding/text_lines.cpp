#include "io/encoding/text_lines.h"

#include <cstring>

namespace cocoon {

bool TextLines::next(std::string_view& line) {
  if (at_ == end_) return false;
  // Remembered between calls: a file with CR line ends would else be searched anew for every line.
  if (!newline_known_ || next_newline_ < at_) {
    const void* found = std::memchr(at_, '\n', static_cast<std::size_t>(end_ - at_));
    next_newline_ = found != nullptr ? static_cast<const char*>(found) : end_;
    newline_known_ = true;
  }
  const char* line_end = next_newline_;
  const char* next_line = next_newline_ == end_ ? end_ : next_newline_ + 1;
  const void* found = std::memchr(at_, '\r', static_cast<std::size_t>(line_end - at_));
  if (found != nullptr) {
    const char* carriage_return = static_cast<const char*>(found);
    if (carriage_return + 1 != next_newline_) next_line = carriage_return + 1;
    line_end = carriage_return;
  }
  line = {at_, static_cast<std::size_t>(line_end - at_)};
  at_ = next_line;
  ++number_;
  return true;
}

std::string_view TextLines::rest_without_blanks() const {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const std::string_view text = rest();
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

}  // namespace cocoon
