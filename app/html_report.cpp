#include "app/html_report.h"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string_view>

#include "app/report_template.h"
#include "io/base64.h"

namespace cocoon::app {

namespace {

// Little endian, as JavaScript's typed arrays are on every machine that runs a browser.
void append_word(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFFU);
}

std::string packed(const std::vector<Point>& points, const Point& origin) {
  std::string bytes;
  bytes.reserve(12 * points.size());
  for (const Point& p : points) {
    const Vec3 relative = p - origin;
    for (int axis = 0; axis < 3; ++axis) {
      append_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(relative[axis])));
    }
  }
  std::string text;
  append_base64(text, bytes);
  return text;
}

std::string packed(const std::vector<std::uint32_t>& indices) {
  std::string bytes;
  bytes.reserve(4 * indices.size());
  for (const std::uint32_t index : indices) append_word(bytes, index);
  std::string text;
  append_base64(text, bytes);
  return text;
}

Point center_of(const std::vector<PageGeometry>& geometries) {
  bool any = false;
  Point low;
  Point high;
  for (const PageGeometry& geometry : geometries) {
    for (const Point& p : geometry.points) {
      if (!any) low = high = p;
      any = true;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return low + 0.5 * (high - low);
}

const char* name_of(PageLayer::Kind kind) {
  switch (kind) {
    case PageLayer::Kind::triangles:
      return "triangles";
    case PageLayer::Kind::lines:
      return "lines";
    case PageLayer::Kind::points:
      return "points";
  }
  throw std::logic_error("unknown kind of layer");
}

void add_scene(const ReportPage& page, JsonReport& data) {
  const Point origin = center_of(page.geometries);
  data.set("origin", std::vector<double>{origin.x, origin.y, origin.z});
  for (const PageGeometry& geometry : page.geometries) {
    const std::string path = "geometries/" + geometry.name;
    data.set(path + "/positions", packed(geometry.points, origin));
    if (!geometry.indices.empty()) data.set(path + "/indices", packed(geometry.indices));
  }
  data.set_empty_array("layers");
  for (const PageLayer& layer : page.layers) {
    JsonReport entry;
    entry.set("id", layer.id);
    entry.set("name", layer.name);
    entry.set("geometry", layer.geometry);
    entry.set("kind", name_of(layer.kind));
    entry.set("color", layer.color);
    entry.set("opacity", layer.opacity);
    entry.set("first", layer.first);
    entry.set("count", layer.count);
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

JsonReport table_data(const PageTable& table) {
  JsonReport data;
  data.set("title", table.title);
  data.set("columns", table.columns);
  data.set_empty_array("rows");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    JsonReport cells;
    cells.set_empty_array("cells");
    for (const PageTable::Cell& cell : table.rows[row]) {
      std::visit([&](const auto& value) { cells.append("cells", value); }, cell);
    }
    data.append("rows", cells);
  }
  return data;
}

}  // namespace

std::string html_page(const ReportPage& page, const JsonReport& numbers) {
  JsonReport data;
  data.set("title", page.title);
  data.set("subtitle", page.subtitle);
  add_scene(page, data);
  data.set_empty_array("tables");
  for (const PageTable& table : page.tables) data.append("tables", table_data(table));
  data.set("warnings", page.warnings);
  data.set("papers", page.papers);
  data.set("json", numbers);

  constexpr std::string_view mark = "{{report}}";
  std::string text = report_template;
  text.replace(text.find(mark), mark.size(), data.script_text());
  return text;
}

}  // namespace cocoon::app
