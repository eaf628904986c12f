// A report as one HTML page that a browser opens from disk, without a network: 3D views of layers,
// one pane for each stage, and tables. What is shown is composed elsewhere (update_report.h); the
// page itself is report_template.html, its viewer is app/viewer/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "app/json_report.h"
#include "app/report/page_view.h"
#include "geom/point.h"

namespace cocoon::app {

// A text for each element (point, triangle, line): what picking it says beside its id.
struct PageLabels {
  std::vector<std::string> texts;
  std::vector<std::uint32_t> of_element;  // index of its text; empty: no labels
};

// Points from `first` on that have a name in common and are numbered from 0: "initial model".
struct PagePart {
  std::string name;
  std::size_t first = 0;
  std::size_t count = 0;
};

// A number for each point. Layers can be colored by it: blue below 0, white, red above 0.
struct PageField {
  std::string name;
  std::vector<double> values;
};

// All points of the page: each once, whatever geometries use it.
struct PagePoints {
  std::vector<Point> positions;
  std::vector<PagePart> parts;
  PageLabels labels;
  std::vector<PageField> fields;
};

// What joins the points: three indices a triangle, two a line segment, one a point.
struct PageGeometry {
  enum class Kind { triangles, lines, points };

  std::string id;    // unique
  std::string name;  // for people: picking says "facet 12 of <name>"
  Kind kind = Kind::triangles;
  std::vector<std::uint32_t> indices;
  PageLabels labels;
};

// The elements of a geometry with one of the given labels (none given: all of them) in one color.
struct PageLayer {
  std::string id;        // unique
  std::string name;      // for people
  std::string geometry;  // id of its geometry
  std::string color;     // "#rrggbb"
  std::vector<std::size_t> labels;
  std::string field;  // not empty: colored by this field instead
  double opacity = 1;
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
  bool bars = false;  // draw the last column's numbers as bars, too
};

struct ReportPage {
  std::string title;
  std::string subtitle;
  std::vector<std::string> verdicts;  // a few words each, shown under the title: "closed"
  PageView view;
  PagePoints points;
  std::vector<PageGeometry> geometries;
  std::vector<PageLayer> layers;
  std::vector<PageStage> stages;
  std::vector<PageTable> tables;
  std::vector<std::string> warnings;
  std::vector<std::string> papers;
};

// The whole page. Positions are stored as float32 relative to the center of all points, so that
// large coordinates do not lose the shape, and in a unit other than 1 if their size or its square
// is no float; so are fields. `numbers` is shown in full at the end. Errors: std::logic_error for a
// geometry with an index beyond the points. Complexity: linear; about 5 bytes of page for each
// index and 16 for each point.
std::string html_page(const ReportPage& page, const JsonReport& numbers);

}  // namespace cocoon::app
