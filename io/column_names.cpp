#include "io/column_names.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace cocoon {

namespace {

// Without quotes, blanks around it, what begins a comment, and a unit; in lower case.
std::string plain_name(std::string_view name) {
  constexpr std::string_view around = " \t\"'/#";
  const std::size_t begin = std::min(name.find_first_not_of(around), name.size());
  const std::size_t unit = std::min(name.find_first_of("[(", begin), name.size());
  std::string plain(name.substr(begin, unit - begin));
  plain.erase(plain.find_last_not_of(around) + 1);
  for (char& c : plain) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return plain;
}

using Family = std::array<std::string_view, 3>;
constexpr std::array<Family, 3> families = {Family{"x", "y", "z"},
                                            Family{"points:0", "points:1", "points:2"},
                                            Family{"points_0", "points_1", "points_2"}};

}  // namespace

CoordinateColumns coordinate_columns(std::span<const std::string_view> names) {
  std::vector<std::string> plain;
  plain.reserve(names.size());
  for (const std::string_view name : names) plain.push_back(plain_name(name));
  CoordinateColumns columns;
  for (const Family& family : families) {
    std::array<std::size_t, 3> at = {};
    std::size_t found = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto name = std::find(plain.begin(), plain.end(), family[axis]);
      at[axis] = static_cast<std::size_t>(name - plain.begin());
      if (name != plain.end()) ++found;
    }
    if (found == 3) return {CoordinateColumns::Told::all, at};
    if (found > 0) columns.told = CoordinateColumns::Told::some;
  }
  return columns;
}

}  // namespace cocoon
