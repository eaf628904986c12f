// A report as one HTML page that a browser opens from disk, without a network: a 3D view of layers
// that stages show and hide, and tables. What is shown is composed elsewhere (update_report.h);
// the page itself is report_template.html.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "app/json_report.h"
#include "geom/point.h"

namespace cocoon::app {

// Points, and what joins them: three indices a triangle, two a line segment, none for points.
struct PageGeometry {
  std::string name;
  std::vector<Point> points;
  std::vector<std::uint32_t> indices;
};

// A range of a geometry's indices (of its points, for points) in one color.
struct PageLayer {
  enum class Kind { triangles, lines, points };

  std::string id;        // unique
  std::string name;      // for people
  std::string geometry;  // name of its geometry
  Kind kind = Kind::triangles;
  std::string color;  // "#rrggbb"
  double opacity = 1;
  std::size_t first = 0;
  std::size_t count = 0;
};

struct PageStage {
  std::string name;
  std::string caption;
  std::vector<std::string> layers;  // ids of what it shows
};

struct PageTable {
  using Cell = std::variant<std::string, double>;

  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
};

struct ReportPage {
  std::string title;
  std::string subtitle;
  std::vector<PageGeometry> geometries;
  std::vector<PageLayer> layers;
  std::vector<PageStage> stages;
  std::vector<PageTable> tables;
  std::vector<std::string> warnings;
  std::vector<std::string> papers;
};

// The whole page. Positions are stored as float32 relative to the center of all geometry, so that
// large coordinates do not lose the shape; `numbers` is shown in full at the end.
std::string html_page(const ReportPage& page, const JsonReport& numbers);

}  // namespace cocoon::app
