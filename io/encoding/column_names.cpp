#include "io/encoding/column_names.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <optional>
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
constexpr std::array<Family, 4> families = {
    Family{"x", "y", "z"}, Family{"points:0", "points:1", "points:2"},
    Family{"points_0", "points_1", "points_2"},
    Family{"points_m_xyz:0", "points_m_xyz:1", "points_m_xyz:2"}};

constexpr std::size_t npos = std::string_view::npos;
using Found = std::optional<std::array<std::size_t, 3>>;  // the columns, if there are all three

std::size_t column_named(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? npos : static_cast<std::size_t>(found - names.begin());
}

// Two columns on the ground and one of the names of a height; with two such it is not clear which.
Found survey_columns(const std::vector<std::string>& names) {
  std::size_t height = npos;
  for (const std::string_view name : {"z", "elevation", "elev", "height", "altitude", "up"}) {
    const std::size_t found = column_named(names, name);
    if (found != npos && height != npos) return std::nullopt;
    if (found != npos) height = found;
  }
  if (height == npos) return std::nullopt;
  for (const std::string_view ending : {"ing", ""}) {
    const std::size_t east = column_named(names, "east" + std::string(ending));
    const std::size_t north = column_named(names, "north" + std::string(ending));
    if (east != npos && north != npos) return std::array{east, north, height};
  }
  return std::nullopt;
}

// pos_x, positionX, x_coord and the like.
Found composed_columns(const std::vector<std::string>& names) {
  for (const std::string word : {"pos", "position", "point", "coord", "coordinate"}) {
    for (const std::string between : {"", "_", ".", " ", "-"}) {
      for (const bool in_front : {true, false}) {
        std::array<std::size_t, 3> at = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::string letter(families[0][axis]);
          const std::string& first = in_front ? word : letter;
          at[axis] = column_named(names, first + between + (in_front ? letter : word));
        }
        if (std::find(at.begin(), at.end(), npos) == at.end()) return at;
      }
    }
  }
  return std::nullopt;
}

bool names_angles(const std::vector<std::string>& names) {
  const auto names_one_of = [&](std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return column_named(names, word) != npos; });
  };
  return names_one_of({"latitude", "lat"}) && names_one_of({"longitude", "long", "lon", "lng"});
}

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
      at[axis] = column_named(plain, family[axis]);
      if (at[axis] != npos) ++found;
    }
    if (found == 3) return {CoordinateColumns::Told::all, at};
    if (found > 0) columns.told = CoordinateColumns::Told::some;
  }
  for (const Found& found : {survey_columns(plain), composed_columns(plain)}) {
    if (found) return {CoordinateColumns::Told::all, *found};
  }
  if (names_angles(plain)) columns.told = CoordinateColumns::Told::angles;
  return columns;
}

}  // namespace cocoon
