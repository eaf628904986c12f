#include "geom/messages/rounded.h"

#include <array>
#include <clocale>
#include <cstdio>

namespace cocoon {

std::string rounded(double value, int digits) {
  std::array<char, 32> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  std::string text = buffer.data();
  // The host of the library may have set another locale.
  const std::string point = std::localeconv()->decimal_point;
  const std::size_t at = text.find(point);
  if (at != std::string::npos) text.replace(at, point.size(), 1, '.');
  return text;
}

}  // namespace cocoon
