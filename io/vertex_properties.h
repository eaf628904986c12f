// What PLY vertices carry beside their position: colors, normals, intensities, whatever a scanner
// writes. Not understood, only kept: name, type and bits, to be written again for the vertices that
// survive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geom/ids.h"
#include "io/formats/ply_header.h"

namespace cocoon {

// One property of all vertices.
struct VertexProperty {
  PlyProperty declaration;
  std::string values;             // of all rows, one behind the other, little endian
  std::vector<std::size_t> ends;  // lists only: row r has values [ends[r - 1], ends[r])

  friend bool operator==(const VertexProperty&, const VertexProperty&) = default;
};

struct VertexProperties {
  std::size_t rows = 0;                 // vertices
  std::vector<VertexProperty> columns;  // in the order of the file
  // Properties that could not be kept, each with the reason, one line.
  std::vector<std::string> left_out;

  friend bool operator==(const VertexProperties&, const VertexProperties&) = default;
};

// A property of the caller's own, to be written with a mesh: one number a row, as `double` or
// `uchar`. To be written to PLY its name must be one word, and not x, y or z.
// docs/examples/own_stages.cpp writes some. Complexity: O(rows).
VertexProperty property_of(std::string name, std::span<const double> values);
VertexProperty property_of(std::string name, std::span<const std::uint8_t> values);

// Where a row comes from.
struct RowOrigin {
  std::uint32_t table = 0;
  std::size_t row = 0;
};

// The same name with another type in a later table: its values there are left out.
struct PropertyConflict {
  std::size_t column = 0;   // of the result
  std::uint32_t table = 0;  // the one whose values are left out

  friend bool operator==(const PropertyConflict&, const PropertyConflict&) = default;
};

struct GatheredProperties {
  VertexProperties properties;       // left_out is empty
  std::vector<std::size_t> missing;  // per column: rows that have no value
  std::vector<PropertyConflict> conflicts;
};

// The rows `origins` of `tables`, in this order. The columns are those of the tables, by name: of
// equal names the first table's type holds. A row whose table does not have a column gets the value
// for "nothing known": NaN for floating point, 0 for integers, the empty list; `missing` counts
// them. Precondition: origins are in range. Complexity: O(bytes of the result).
GatheredProperties gather_properties(std::span<const VertexProperties> tables,
                                     std::span<const RowOrigin> origins);

// The rows `origins` of one table, in this order; what was left out of it stays noted.
VertexProperties select_rows(const VertexProperties& table, std::span<const RowOrigin> origins);
VertexProperties select_rows(const VertexProperties& table, std::span<const VertexId> vertices);

// The rows of `table` whose flag in `kept` (one a row) is set, in their order.
VertexProperties select_properties(const VertexProperties& table,
                                   std::span<const std::uint8_t> kept);

// "uchar", "list uchar int": as a PLY header says it.
std::string type_text(const PlyProperty& declaration);

}  // namespace cocoon
