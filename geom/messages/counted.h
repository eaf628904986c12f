// A number and what it counts, as messages say it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cocoon {

// "1 part is", "3 parts are": the number, a space, and `one` if it is 1, else `many`.
inline std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count).append(" ").append(count == 1 ? one : many);
}

// "1 edge", "3 edges". Precondition: the noun has its plural in s.
inline std::string counted(std::size_t count, std::string_view noun) {
  return counted(count, noun, std::string(noun) + "s");
}

}  // namespace cocoon
