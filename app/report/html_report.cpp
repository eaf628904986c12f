#include "app/report/html_report.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "app/report/report_template.h"
#include "geom/box.h"
#include "io/encoding/base64.h"

namespace cocoon::app {

namespace {

std::string base64_of(const std::string& bytes) {
  std::string text;
  append_base64(text, bytes);
  return text;
}

// Little endian, as JavaScript's typed arrays are on every machine that runs a browser.
void append_float(std::string& bytes, double value) {
  const auto word = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFFU);
}

std::string packed(const std::vector<Point>& points, const Point& origin, double unit) {
  std::string bytes;
  bytes.reserve(12 * points.size());
  for (const Point& p : points) {
    const Vec3 relative = (p - origin) / unit;
    for (int axis = 0; axis < 3; ++axis) append_float(bytes, relative[axis]);
  }
  return base64_of(bytes);
}

std::string packed(const std::vector<double>& values, double unit) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const double value : values) append_float(bytes, value / unit);
  return base64_of(bytes);
}

// What lengths of up to `most` are stored in: 1, but for sizes that are no floats, or whose squares
// are none, which viewers compute, a power of two near them.
double unit_of(double most) {
  constexpr double largest = 0x1p40;
  if (!(most > 0) || (most <= largest && most >= 1 / largest)) return 1;
  return std::ldexp(1.0, std::ilogb(most));
}

// Differences of successive numbers (modulo 2^32), small ones of either sign made small unsigned
// ones, in groups of seven bits from the lowest with the eighth bit set on all but the last: one or
// two bytes for most indices of a mesh instead of four.
std::string packed(const std::vector<std::uint32_t>& numbers) {
  std::string bytes;
  bytes.reserve(2 * numbers.size());
  std::uint32_t last = 0;
  for (const std::uint32_t number : numbers) {
    const std::uint32_t difference = number - last;
    last = number;
    std::uint32_t code = difference << 1 ^ (difference >> 31 != 0 ? 0xFFFFFFFFU : 0U);
    for (; code >= 0x80U; code >>= 7) bytes += static_cast<char>(code | 0x80U);
    bytes += static_cast<char>(code);
  }
  return base64_of(bytes);
}

const char* name_of(PageGeometry::Kind kind) {
  switch (kind) {
    case PageGeometry::Kind::triangles:
      return "triangles";
    case PageGeometry::Kind::lines:
      return "lines";
    case PageGeometry::Kind::points:
      return "points";
  }
  throw std::logic_error("unknown kind of geometry");
}

void set_labels(JsonReport& data, const PageLabels& labels) {
  data.set("texts", labels.texts);
  data.set("labels", packed(labels.of_element));
}

void add_points(const PagePoints& points, JsonReport& data) {
  const Point origin = box_of(points.positions).center();
  data.set("origin", std::vector<double>{origin.x, origin.y, origin.z});
  double reach = 0;
  for (const Point& p : points.positions) reach = std::max(reach, max_norm(p - origin));
  const double unit = unit_of(reach);
  data.set("unit", unit);
  JsonReport entry;
  entry.set("positions", packed(points.positions, origin, unit));
  set_labels(entry, points.labels);
  entry.set_empty_array("parts");
  for (const PagePart& part : points.parts) {
    JsonReport range;
    range.set("name", part.name);
    range.set("first", part.first);
    range.set("count", part.count);
    entry.append("parts", range);
  }
  entry.set_empty_array("fields");
  for (const PageField& field : points.fields) {
    JsonReport numbers;
    numbers.set("name", field.name);
    double most = 0;
    for (const double value : field.values) most = std::max(most, std::fabs(value));
    const double field_unit = unit_of(most);
    numbers.set("unit", field_unit);
    numbers.set("values", packed(field.values, field_unit));
    entry.append("fields", numbers);
  }
  data.set("points", entry);
}

void add_geometries(const ReportPage& page, JsonReport& data) {
  data.set_empty_array("geometries");
  for (const PageGeometry& geometry : page.geometries) {
    const bool inside = std::all_of(geometry.indices.begin(), geometry.indices.end(),
                                    [&](auto i) { return i < page.points.positions.size(); });
    if (!inside) throw std::logic_error("page geometry " + geometry.id + " names no point");
    JsonReport entry;
    entry.set("id", geometry.id);
    entry.set("name", geometry.name);
    entry.set("kind", name_of(geometry.kind));
    entry.set("indices", packed(geometry.indices));
    set_labels(entry, geometry.labels);
    data.append("geometries", entry);
  }
}

void add_layers_and_stages(const ReportPage& page, JsonReport& data) {
  data.set_empty_array("layers");
  for (const PageLayer& layer : page.layers) {
    JsonReport entry;
    entry.set("id", layer.id);
    entry.set("name", layer.name);
    entry.set("geometry", layer.geometry);
    entry.set("color", layer.color);
    entry.set("labels", layer.labels);
    entry.set("field", layer.field);
    entry.set("opacity", layer.opacity);
    data.append("layers", entry);
  }
  data.set_empty_array("stages");
  for (const PageStage& stage : page.stages) {
    JsonReport entry;
    entry.set("name", stage.name);
    entry.set("caption", stage.caption);
    entry.set("layers", stage.layers);
    data.append("stages", entry);
  }
}

void add_view(const PageView& view, JsonReport& data) {
  JsonReport entry;
  entry.set("azimuth_deg", view.azimuth_deg);
  entry.set("elevation_deg", view.elevation_deg);
  data.set("view", entry);
}

JsonReport table_data(const PageTable& table) {
  JsonReport data;
  data.set("title", table.title);
  data.set("columns", table.columns);
  data.set("bars", table.bars);
  data.set_empty_array("rows");
  for (const auto& row : table.rows) {
    JsonReport cells;
    cells.set_empty_array("cells");
    for (const PageTable::Cell& cell : row) {
      std::visit([&](const auto& value) { cells.append("cells", value); }, cell);
    }
    data.append("rows", cells);
  }
  return data;
}

void replace_mark(std::string& text, std::string_view mark, std::string_view by) {
  text.replace(text.find(mark), mark.size(), by);
}

}  // namespace

std::string html_page(const ReportPage& page, const JsonReport& numbers) {
  JsonReport data;
  data.set("title", page.title);
  data.set("subtitle", page.subtitle);
  data.set("verdicts", page.verdicts);
  add_view(page.view, data);
  add_points(page.points, data);
  add_geometries(page, data);
  add_layers_and_stages(page, data);
  data.set_empty_array("tables");
  for (const PageTable& table : page.tables) data.append("tables", table_data(table));
  data.set("warnings", page.warnings);
  data.set("papers", page.papers);
  data.set("json", numbers);

  std::string text = report_template;
  replace_mark(text, "{{viewer}}", report_viewer);
  replace_mark(text, "{{report}}", data.script_text());
  return text;
}

}  // namespace cocoon::app
