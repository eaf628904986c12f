#include "docs/pictures/svg_canvas.h"

#include <cmath>
#include <fmt/format.h>

namespace cocoon::pictures {
namespace {

constexpr int legend_line = 20;
constexpr int letter_width = 7;

// Without the sign of a zero.
std::string number(double value) {
  const std::string text = fmt::format("{:.1f}", value);
  return text == "-0.0" ? "0.0" : text;
}

std::string attributes(const Style& style) {
  std::string text = fmt::format("fill=\"{}\"", style.fill);
  if (style.stroke != "none") {
    text += fmt::format(" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                        style.stroke, number(style.width));
  }
  if (style.dashed) text += " stroke-dasharray=\"5 4\"";
  return text;
}

}  // namespace

SvgCanvas::SvgCanvas(const Frame& frame) : frame_(frame) {}

std::string SvgCanvas::point(Planar p) const {
  const double x = frame_.width / 2.0 + frame_.scale * (p.x - frame_.center.x);
  const double y = frame_.height / 2.0 - frame_.scale * (p.y - frame_.center.y);
  return fmt::format("{},{}", number(x), number(y));
}

std::string SvgCanvas::path(std::span<const Planar> points) const {
  std::string text;
  for (const Planar& p : points) {
    if (!text.empty()) text += ' ';
    text += point(p);
  }
  return text;
}

void SvgCanvas::polygon(std::span<const Planar> corners, const Style& style) {
  shapes_ += fmt::format("<polygon points=\"{}\" {}/>\n", path(corners), attributes(style));
}

void SvgCanvas::polyline(std::span<const Planar> points, const Style& style) {
  shapes_ += fmt::format("<polyline points=\"{}\" {}/>\n", path(points), attributes(style));
}

void SvgCanvas::line(Planar from, Planar to, const Style& style) {
  const Planar ends[] = {from, to};
  polyline(ends, style);
}

void SvgCanvas::circle(Planar center, double radius, const Style& style) {
  dot(center, frame_.scale * radius, style);
}

void SvgCanvas::dot(Planar center, double radius, const Style& style) {
  const std::string at = point(center);
  const std::size_t comma = at.find(',');
  shapes_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", at.substr(0, comma),
                         at.substr(comma + 1), number(radius), attributes(style));
}

void SvgCanvas::arrow(Planar from, Planar to, const std::string& color) {
  line(from, to, {.stroke = color, .width = 1.6});
  const Planar way = to - from;
  const double length = std::hypot(way.x, way.y);
  if (length == 0) return;
  const Planar along = (6 / (frame_.scale * length)) * way;
  const Planar across = 0.5 * Planar{-along.y, along.x};
  const Planar head[] = {to, to - along + across, to - along - across};
  polygon(head, {.fill = color});
}

void SvgCanvas::text(Planar at, const std::string& words, const std::string& color) {
  const std::string place = point(at);
  const std::size_t comma = place.find(',');
  shapes_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" fill=\"{}\" stroke=\"white\" "
      "stroke-width=\"4\" paint-order=\"stroke\">{}</text>\n",
      place.substr(0, comma), place.substr(comma + 1), color, words);
}

std::string SvgCanvas::finish(std::initializer_list<Entry> legend) const {
  constexpr int margin = 12;
  int x = margin;
  int y = frame_.height;
  std::string words;
  for (const Entry& entry : legend) {
    const int width = 40 + letter_width * static_cast<int>(entry.words.size());
    if (x + width > frame_.width) {
      x = margin;
      y += legend_line;
    }
    words += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"14\" height=\"12\" fill=\"{}\" stroke=\"#999\" "
        "stroke-width=\"0.5\"/>\n<text x=\"{}\" y=\"{}\" fill=\"#222\">{}</text>\n",
        x, y + 4, entry.color, x + 20, y + 14, entry.words);
    x += width;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
      "<clipPath id=\"frame\"><rect width=\"{0}\" height=\"{2}\"/></clipPath>\n"
      "<g clip-path=\"url(#frame)\">\n{3}</g>\n{4}</svg>\n",
      frame_.width, y + legend_line + 4, frame_.height, shapes_, words);
}

}  // namespace cocoon::pictures
