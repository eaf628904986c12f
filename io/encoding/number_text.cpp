#include "io/encoding/number_text.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace cocoon {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Whether the unsigned decimal number in `text`, which no double holds, is too large (and not too
// small): the power of ten of its first digit that is not 0 decides.
bool is_too_large(std::string_view text) {
  std::int64_t power = 0;  // of the first nonzero digit
  bool nonzero = false;
  bool after_point = false;
  std::size_t i = 0;
  for (; i < text.size() && (is_digit(text[i]) || text[i] == '.'); ++i) {
    if (text[i] == '.') {
      after_point = true;
      continue;
    }
    nonzero = nonzero || text[i] != '0';
    if (nonzero && !after_point) ++power;
    if (!nonzero && after_point) --power;
  }
  if (i < text.size()) {  // the exponent, which may itself not fit an integer
    ++i;
    const bool negative = i < text.size() && text[i] == '-';
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
    std::int64_t exponent = 0;
    if (std::from_chars(text.data() + i, text.data() + text.size(), exponent).ec != std::errc()) {
      return !negative;
    }
    // An exponent outweighs the digits, or neither is near the limits of the integers.
    constexpr std::int64_t decisive = std::int64_t{1} << 62;
    if (exponent > decisive) return !negative;
    power += negative ? -exponent : exponent;
  }
  return power > 0;
}

template <class T>
void append_shortest(std::string& text, T value) {
  char buffer[32];
  const std::to_chars_result result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

// Behind an optional plus sign, which from_chars does not take; null if what follows is no number.
const char* behind_plus(const char* at, const char* end) {
  if (at == end || *at != '+') return at;
  ++at;
  return at != end && *at == '-' ? nullptr : at;
}

// The end of "#INF", "#QNAN00" and the like; `at` itself if that is not what stands there.
const char* behind_special(const char* at, const char* end) {
  for (const std::string_view name : {"#INF", "#IND", "#QNAN", "#SNAN"}) {
    const std::string_view rest(at, static_cast<std::size_t>(end - at));
    if (!rest.starts_with(name)) continue;
    at += name.size();
    while (at != end && is_digit(*at)) ++at;
    break;
  }
  return at;
}

template <class T>
bool parse_real(const char*& at, const char* end, T& value) {
  const char* begin = behind_plus(at, end);
  if (begin == nullptr) return false;
  const std::from_chars_result result = std::from_chars(begin, end, value);
  if (result.ec == std::errc::invalid_argument) return false;
  if (result.ec == std::errc::result_out_of_range) {
    const bool negative = *begin == '-';
    const char* digits = begin + (negative ? 1 : 0);
    const bool large = is_too_large({digits, static_cast<std::size_t>(result.ptr - digits)});
    value =
        std::copysign(large ? std::numeric_limits<T>::infinity() : T(0), negative ? T(-1) : T(1));
  }
  at = result.ptr;
  if (at == end || *at != '#' || at[-1] != '.') return true;
  const char* special_end = behind_special(at, end);
  if (special_end == at) return true;
  value = at[3] == 'F' ? std::copysign(std::numeric_limits<T>::infinity(), value)
                       : std::numeric_limits<T>::quiet_NaN();
  at = special_end;
  return true;
}

template <class T>
bool parse_whole(const char*& at, const char* end, T& value) {
  const char* begin = behind_plus(at, end);
  if (begin == nullptr) return false;
  const std::from_chars_result result = std::from_chars(begin, end, value);
  if (result.ec != std::errc()) return false;
  at = result.ptr;
  return true;
}

}  // namespace

bool parse_double(const char*& at, const char* end, double& value) {
  return parse_real(at, end, value);
}
bool parse_float(const char*& at, const char* end, float& value) {
  return parse_real(at, end, value);
}
bool parse_integer(const char*& at, const char* end, std::int64_t& value) {
  return parse_whole(at, end, value);
}
bool parse_integer(const char*& at, const char* end, std::uint64_t& value) {
  return parse_whole(at, end, value);
}

std::string_view without_comment(std::string_view line) {
  const char* end = line.data() + line.size();
  for (std::size_t i = line.find('#'); i != std::string_view::npos; i = line.find('#', i + 1)) {
    const bool is_special =
        i > 0 && line[i - 1] == '.' && behind_special(line.data() + i, end) != line.data() + i;
    if (!is_special) return line.substr(0, i);
  }
  return line;
}

void append_number(std::string& text, double value) { append_shortest(text, value); }
void append_number(std::string& text, float value) { append_shortest(text, value); }
void append_number(std::string& text, std::size_t value) { append_shortest(text, value); }
void append_number(std::string& text, std::int64_t value) { append_shortest(text, value); }

bool Fields::done() {
  skip_blanks();
  return at_ == end_;
}

bool Fields::number(double& value) {
  skip_blanks();
  const char* at = at_;
  if (!parse_double(at, end_, value) || !at_field_end(at)) return false;
  at_ = at;
  return true;
}

bool Fields::integer(std::int64_t& value) {
  skip_blanks();
  const char* at = at_;
  if (!parse_integer(at, end_, value) || !at_field_end(at)) return false;
  at_ = at;
  return true;
}

std::string_view Fields::word() {
  skip_blanks();
  const char* begin = at_;
  while (at_ != end_ && !is_blank(*at_)) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

}  // namespace cocoon
