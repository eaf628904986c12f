#include "geom/messages/without_control_bytes.h"

#include <algorithm>

namespace cocoon {

std::string without_control_bytes(std::string line) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  std::replace_if(line.begin(), line.end(), is_control, '?');
  return line;
}

}  // namespace cocoon
