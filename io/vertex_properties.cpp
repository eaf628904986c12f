#include "io/vertex_properties.h"

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "io/encoding/byte_order.h"

namespace cocoon {

namespace {

// The column of `table` that `declaration` asks for, if it has it with the same type.
std::optional<std::size_t> column_of(const VertexProperties& table,
                                     const PlyProperty& declaration) {
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    if (table.columns[k].declaration == declaration) return k;
  }
  return {};
}

// Appends the column declarations of `table` that `result` lacks.
void add_columns(const VertexProperties& table, std::uint32_t number, GatheredProperties& result) {
  for (const VertexProperty& column : table.columns) {
    std::vector<VertexProperty>& known = result.properties.columns;
    std::size_t k = 0;
    while (k < known.size() && known[k].declaration.name != column.declaration.name) ++k;
    if (k == known.size()) {
      known.push_back({column.declaration, {}, {}});
    } else if (known[k].declaration != column.declaration) {
      result.conflicts.push_back({k, number});
    }
  }
}

void append_row(const VertexProperty& from, std::size_t row, VertexProperty& to) {
  const std::size_t size = size_of(from.declaration.type);
  if (!from.declaration.is_list) {
    to.values.append(from.values, row * size, size);
    return;
  }
  const std::size_t begin = row == 0 ? 0 : from.ends[row - 1];
  to.values.append(from.values, begin * size, (from.ends[row] - begin) * size);
  to.ends.push_back(to.values.size() / size);
}

void append_nothing_known(VertexProperty& to) {
  const std::size_t size = size_of(to.declaration.type);
  if (to.declaration.is_list) {
    to.ends.push_back(to.values.size() / size);
  } else if (to.declaration.type == PlyType::float32) {
    append_little_endian(to.values, std::numeric_limits<float>::quiet_NaN());
  } else if (to.declaration.type == PlyType::float64) {
    append_little_endian(to.values, std::numeric_limits<double>::quiet_NaN());
  } else {
    to.values.append(size, '\0');
  }
}

}  // namespace

VertexProperty property_of(std::string name, std::span<const double> values) {
  VertexProperty column{{std::move(name), PlyType::float64}, {}, {}};
  for (const double value : values) append_little_endian(column.values, value);
  return column;
}

VertexProperty property_of(std::string name, std::span<const std::uint8_t> values) {
  VertexProperty column{{std::move(name), PlyType::uint8}, {}, {}};
  for (const std::uint8_t value : values) append_little_endian(column.values, value);
  return column;
}

GatheredProperties gather_properties(std::span<const VertexProperties> tables,
                                     std::span<const RowOrigin> origins) {
  GatheredProperties result;
  for (std::size_t t = 0; t < tables.size(); ++t) {
    add_columns(tables[t], static_cast<std::uint32_t>(t), result);
  }
  result.properties.rows = origins.size();
  result.missing.resize(result.properties.columns.size(), 0);
  for (std::size_t k = 0; k < result.properties.columns.size(); ++k) {
    VertexProperty& column = result.properties.columns[k];
    std::vector<const VertexProperty*> sources;
    for (const VertexProperties& table : tables) {
      const std::optional<std::size_t> found = column_of(table, column.declaration);
      sources.push_back(found ? &table.columns[*found] : nullptr);
    }
    for (const RowOrigin& origin : origins) {
      const VertexProperty* source = sources[origin.table];
      if (source != nullptr) {
        append_row(*source, origin.row, column);
      } else {
        append_nothing_known(column);
        ++result.missing[k];
      }
    }
  }
  return result;
}

VertexProperties select_rows(const VertexProperties& table, std::span<const RowOrigin> origins) {
  GatheredProperties gathered = gather_properties({&table, 1}, origins);
  gathered.properties.left_out = table.left_out;
  return std::move(gathered.properties);
}

VertexProperties select_rows(const VertexProperties& table, std::span<const VertexId> vertices) {
  std::vector<RowOrigin> origins;
  origins.reserve(vertices.size());
  for (const VertexId v : vertices) origins.push_back({0, v.index()});
  return select_rows(table, origins);
}

VertexProperties select_properties(const VertexProperties& table,
                                   std::span<const std::uint8_t> kept) {
  std::vector<RowOrigin> origins;
  for (std::size_t row = 0; row < kept.size(); ++row) {
    if (kept[row] != 0) origins.push_back({0, row});
  }
  return select_rows(table, origins);
}

std::string type_text(const PlyProperty& declaration) {
  const std::string_view value = name_of(declaration.type);
  if (!declaration.is_list) return std::string(value);
  return "list " + std::string(name_of(declaration.count_type)) + " " + std::string(value);
}

}  // namespace cocoon
