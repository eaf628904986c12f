#include "io/formats/ply_properties.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "io/encoding/byte_order.h"
#include "io/encoding/number_text.h"

namespace cocoon {

namespace {

// Where the values of a row lie in a column.
struct ValueRange {
  std::size_t begin;
  std::size_t end;
};

ValueRange values_of(const VertexProperty& column, std::size_t row) {
  if (!column.declaration.is_list) return {row, row + 1};
  return {row == 0 ? 0 : column.ends[row - 1], column.ends[row]};
}

template <class T>
void append_value(const char* value, std::string& text) {
  const T number = load_number<T>(value, std::endian::little);
  if constexpr (std::is_floating_point_v<T>) {
    append_number(text, number);
  } else if constexpr (std::is_signed_v<T>) {
    append_number(text, std::int64_t{number});
  } else {
    append_number(text, std::size_t{number});
  }
}

void append_value(PlyType type, const char* value, std::string& text) {
  switch (type) {
    case PlyType::int8:
      return append_value<std::int8_t>(value, text);
    case PlyType::uint8:
      return append_value<std::uint8_t>(value, text);
    case PlyType::int16:
      return append_value<std::int16_t>(value, text);
    case PlyType::uint16:
      return append_value<std::uint16_t>(value, text);
    case PlyType::int32:
      return append_value<std::int32_t>(value, text);
    case PlyType::uint32:
      return append_value<std::uint32_t>(value, text);
    case PlyType::int64:
      return append_value<std::int64_t>(value, text);
    case PlyType::uint64:
      return append_value<std::uint64_t>(value, text);
    case PlyType::float32:
      return append_value<float>(value, text);
    case PlyType::float64:
      return append_value<double>(value, text);
  }
}

// The length of a list in the bytes of its type, which can hold it: the reader checked that.
void append_length(std::size_t length, PlyType type, std::string& bytes) {
  std::string wide;
  append_little_endian(wide, std::uint64_t{length});
  bytes.append(wide, 0, size_of(type));
}

}  // namespace

KeptProperties::KeptProperties(const PlyElement& element, const std::vector<bool>& taken,
                               bool wanted) {
  properties_.rows = element.count;
  if (!wanted) return;
  slots_.resize(element.properties.size(), none);
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    if (taken[k]) continue;
    const PlyProperty& property = element.properties[k];
    const auto same_name = [&](const VertexProperty& column) {
      return column.declaration.name == property.name;
    };
    if (std::any_of(properties_.columns.begin(), properties_.columns.end(), same_name)) {
      properties_.left_out.push_back(property.name + " comes a second time");
      continue;
    }
    slots_[k] = properties_.columns.size();
    properties_.columns.push_back({property, {}, {}});
  }
}

std::size_t KeptProperties::largest_length(PlyType count_type) {
  const bool has_sign = count_type == PlyType::int8 || count_type == PlyType::int16 ||
                        count_type == PlyType::int32 || count_type == PlyType::int64;
  const std::size_t bits = 8 * size_of(count_type) - (has_sign ? 1 : 0);
  return std::numeric_limits<std::size_t>::max() >> (64 - bits);
}

void KeptProperties::leave_out(std::size_t k, std::size_t line) {
  const std::size_t slot = slots_[k];
  const PlyProperty& property = properties_.columns[slot].declaration;
  properties_.left_out.push_back(property.name + " is no " + type_text(property) + " in line " +
                                 std::to_string(line));
  properties_.columns.erase(properties_.columns.begin() + static_cast<std::ptrdiff_t>(slot));
  for (std::size_t& other : slots_) {
    if (other != none && other > slot) --other;
  }
  slots_[k] = none;
}

VertexProperties KeptProperties::take() { return std::exchange(properties_, {}); }

void append_as_text(const VertexProperty& column, std::size_t row, std::string& text) {
  const std::size_t size = size_of(column.declaration.type);
  const ValueRange values = values_of(column, row);
  if (column.declaration.is_list) {
    text += ' ';
    append_number(text, values.end - values.begin);
  }
  for (std::size_t i = values.begin; i < values.end; ++i) {
    text += ' ';
    append_value(column.declaration.type, column.values.data() + i * size, text);
  }
}

void append_as_bytes(const VertexProperty& column, std::size_t row, std::string& bytes) {
  const std::size_t size = size_of(column.declaration.type);
  const ValueRange values = values_of(column, row);
  if (column.declaration.is_list) {
    append_length(values.end - values.begin, column.declaration.count_type, bytes);
  }
  bytes.append(column.values, values.begin * size, (values.end - values.begin) * size);
}

}  // namespace cocoon
