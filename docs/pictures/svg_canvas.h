// Drawings in a plane as SVG text.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace cocoon::pictures {

struct Planar {
  double x = 0;
  double y = 0;

  friend bool operator==(const Planar&, const Planar&) = default;
};
inline Planar operator+(Planar a, Planar b) { return {a.x + b.x, a.y + b.y}; }
inline Planar operator-(Planar a, Planar b) { return {a.x - b.x, a.y - b.y}; }
inline Planar operator*(double s, Planar a) { return {s * a.x, s * a.y}; }
inline double dot(Planar a, Planar b) { return a.x * b.x + a.y * b.y; }

// Colors as SVG knows them; widths and radii in pixels.
struct Style {
  std::string fill = "none";
  std::string stroke = "none";
  double width = 1;
  bool dashed = false;
};

// What of the plane a picture shows: pixels for each unit, and the place in its middle.
struct Frame {
  Planar center;
  double scale = 100;
  int width = 640;
  int height = 400;
};

// Later shapes cover earlier ones. Coordinates are those of the plane, y upward; each shape takes
// O(its points). Numbers are written with one decimal, so equal shapes give equal bytes.
class SvgCanvas {
 public:
  explicit SvgCanvas(const Frame& frame);

  void polygon(std::span<const Planar> corners, const Style& style);
  void line(Planar from, Planar to, const Style& style);
  void polyline(std::span<const Planar> points, const Style& style);
  void circle(Planar center, double radius, const Style& style);  // radius in units of the plane
  void dot(Planar center, double radius, const Style& style);     // radius in pixels
  void arrow(Planar from, Planar to, const std::string& color);
  void text(Planar at, const std::string& words, const std::string& color = "#222");

  // A word of the legend below the picture: a patch of color and what it means.
  struct Entry {
    std::string color;
    std::string words;
  };
  // The whole file.
  std::string finish(std::initializer_list<Entry> legend) const;

 private:
  std::string point(Planar p) const;
  std::string path(std::span<const Planar> points) const;

  Frame frame_;
  std::string shapes_;
};

}  // namespace cocoon::pictures
