// Base64 (RFC 4648), as XML and HTML files carry binary data.
#pragma once

#include <string>
#include <string_view>

namespace cocoon {

// Appends the code of `bytes`, padded with '=' to a multiple of four. Complexity: O(bytes).
void append_base64(std::string& text, std::string_view bytes);

}  // namespace cocoon
