// Numbers as text, independent of the locale, with every bit of a double kept both ways.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cocoon {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

// Reads a decimal number at `at` and moves `at` behind it; false, and `at` stays, if there is none.
// Accepted: sign (also +), digits with or without point, exponent e or E, nan, inf, infinity. Not:
// hexadecimal, Fortran's D, decimal comma: they end the number, and the caller finds a character
// that separates nothing. The result is the nearest double; too large a number gives an infinity,
// too small a one 0, with its sign. What older C libraries of Windows print, "1.#QNAN", "-1.#IND",
// "1.#INF", is read as what they mean.
bool parse_double(const char*& at, const char* end, double& value);
// The same with the nearest float (which is not always the float nearest to the nearest double).
bool parse_float(const char*& at, const char* end, float& value);

// The same for a whole number (sign allowed); false also if it does not fit 64 bits.
bool parse_integer(const char*& at, const char* end, std::int64_t& value);
bool parse_integer(const char*& at, const char* end, std::uint64_t& value);

// `line` up to the '#' that begins a comment; that of "1.#INF" does not.
std::string_view without_comment(std::string_view line);

// Appends the shortest decimal text that reads back as the same bits (at most 17 digits).
void append_number(std::string& text, double value);
void append_number(std::string& text, float value);
void append_number(std::string& text, std::size_t value);
void append_number(std::string& text, std::int64_t value);

// Takes the blank-separated fields of one line, one after the other.
class Fields {
 public:
  explicit Fields(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

  // No field is left.
  bool done();
  // The next field as a number; false, and the field stays, if there is none or it is no number.
  bool number(double& value);
  bool integer(std::int64_t& value);
  // The next field as it stands, empty at the end.
  std::string_view word();
  // What is left of the line.
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

 private:
  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
  }
  bool at_field_end(const char* at) const { return at == end_ || is_blank(*at); }

  const char* at_;
  const char* end_;
};

}  // namespace cocoon
