// Which columns of a table of points are x, y and z, by the names in its first line.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace cocoon {

struct CoordinateColumns {
  enum class Told {
    all,     // by names of x, y and z
    some,    // one or two of the three have such a name
    angles,  // not all three, but a latitude and a longitude
    none     // no such name
  };
  Told told = Told::none;
  std::array<std::size_t, 3> at = {0, 1, 2};  // of x, y, z: the first three unless told == all
};

// Names that tell: x y z, as CloudCompare begins a line with them ("//X Y Z") and in upper case,
// too, with a unit in brackets ("x [mm]", "Y(m)"); Points:0 Points:1 Points:2, also with "_", as
// ParaView writes them, and Points_m_XYZ:0 of programs that build on it; easting and northing, or
// east and north, with one of z, elevation, elev, height, altitude and up; x, y, z composed with
// pos, position, point, coord or coordinate (pos_x, "x coordinate"), all three the same way. Of
// angles: latitude or lat, and longitude, long, lon or lng. In quotes or not. The first column of a
// name counts.
CoordinateColumns coordinate_columns(std::span<const std::string_view> names);

}  // namespace cocoon
