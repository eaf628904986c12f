// Reading and writing the vertex properties that are only kept, value by value.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/formats/ply_body.h"
#include "io/formats/ply_header.h"
#include "io/vertex_properties.h"

namespace cocoon {

// Collects the properties of one element while it is read.
class KeptProperties {
 public:
  // All properties of `element` that `taken` does not name, but a second one of the same name; none
  // unless `wanted`.
  KeptProperties(const PlyElement& element, const std::vector<bool>& taken, bool wanted);

  // Reads property k of the next element; false, and nothing is read, if it is not kept. A value
  // that is not of its property's type (ascii only) ends the keeping of that property.
  template <class Body>
  bool read(std::size_t k, Body& body) {
    if (slots_.empty() || slots_[k] == none) return false;
    VertexProperty& column = properties_.columns[slots_[k]];
    const PlyProperty& property = column.declaration;
    const std::size_t count =
        property.is_list ? body.list_length(property.count_type, property.type) : 1;
    const bool fits = !property.is_list || count <= largest_length(property.count_type);
    if (!body.append(property.type, count, column.values) || !fits) {
      leave_out(k, body.line());
    } else if (property.is_list) {
      column.ends.push_back(column.values.size() / size_of(property.type));
    }
    return true;
  }

  // What was kept; the collector is empty afterwards.
  VertexProperties take();

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  static std::size_t largest_length(PlyType count_type);
  void leave_out(std::size_t k, std::size_t line);

  std::vector<std::size_t> slots_;  // of each property of the element; empty: nothing is kept
  VertexProperties properties_;
};

// Appends row `row` as ascii, a blank before each value, or as little endian bytes.
void append_as_text(const VertexProperty& column, std::size_t row, std::string& text);
void append_as_bytes(const VertexProperty& column, std::size_t row, std::string& bytes);

}  // namespace cocoon
