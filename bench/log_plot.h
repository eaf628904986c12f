// Curves on logarithmic axes as SVG, for docs/performance.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace cocoon::bench {

struct Curve {
  std::string name;
  std::string color;
  std::vector<std::pair<double, double>> points;  // all positive
};

struct LogPlot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
};

class LogPlotWriter {
 public:
  // Plots side by side.
  static bool write(const std::string& file, const std::vector<LogPlot>& plots) {
    std::ofstream out(file);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width * plots.size() << ' '
        << height << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (std::size_t k = 0; k < plots.size(); ++k) {
      out << "<g transform=\"translate(" << width * k << " 0)\">\n"
          << LogPlotWriter(plots[k]).body() << "</g>\n";
    }
    out << "</svg>\n";
    return out.good();
  }

 private:
  static constexpr std::size_t width = 420;
  static constexpr std::size_t height = 320;
  static constexpr double left = 60;
  static constexpr double right = 25;  // half of the last label
  static constexpr double top = 30;
  static constexpr double bottom = 45;

  // Decades that hold all values.
  struct Axis {
    int low = 100;
    int high = -100;
    void hold(double value) {
      low = std::min(low, static_cast<int>(std::floor(std::log10(value))));
      high = std::max(high, static_cast<int>(std::ceil(std::log10(value))));
    }
    double share(double value) const { return (std::log10(value) - low) / (high - low); }
  };

  explicit LogPlotWriter(const LogPlot& plot) : plot_(plot) {
    for (const Curve& curve : plot.curves) {
      for (const auto& [x, y] : curve.points) {
        x_.hold(x);
        y_.hold(y);
      }
    }
  }

  double at_x(double x) const { return left + x_.share(x) * (width - left - right); }
  double at_y(double y) const { return height - bottom - y_.share(y) * (height - top - bottom); }

  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
  }
  static std::string line(double x1, double y1, double x2, double y2) {
    return "<path d=\"M" + number(x1) + ' ' + number(y1) + 'L' + number(x2) + ' ' + number(y2) +
           "\" stroke=\"#ccc\"/>\n";
  }
  static std::string text(double x, double y, const std::string& words,
                          const std::string& attributes) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + attributes + '>' + words +
           "</text>\n";
  }
  static std::string decade(int exponent) {
    char label[32];
    std::snprintf(label, sizeof label, exponent < 0 ? "%g" : "%.0f", std::pow(10.0, exponent));
    return label;
  }

  std::string body() const {
    std::string svg = text(width / 2.0, 18, plot_.title, "text-anchor=\"middle\"");
    for (int e = x_.low; e <= x_.high; ++e) {
      const double x = at_x(std::pow(10.0, e));
      svg += line(x, top, x, height - bottom);
      svg += text(x, height - bottom + 16, decade(e), "text-anchor=\"middle\"");
    }
    for (int e = y_.low; e <= y_.high; ++e) {
      const double y = at_y(std::pow(10.0, e));
      svg += line(left, y, width - right, y);
      svg += text(left - 6, y + 4, decade(e), "text-anchor=\"end\"");
    }
    svg += text(width / 2.0, height - 8, plot_.x_label, "text-anchor=\"middle\"");
    svg += "<g transform=\"translate(14 " + number(height / 2.0) + ") rotate(-90)\">" +
           text(0, 0, plot_.y_label, "text-anchor=\"middle\"") + "</g>\n";
    // Below the curves, where they have ended.
    double legend = height - bottom + 8 - 16.0 * static_cast<double>(plot_.curves.size());
    for (const Curve& curve : plot_.curves) {
      std::string path;
      for (const auto& [x, y] : curve.points) {
        path += path.empty() ? 'M' : 'L';
        path += number(at_x(x)) + ' ' + number(at_y(y));
        svg += "<circle cx=\"" + number(at_x(x)) + "\" cy=\"" + number(at_y(y)) +
               "\" r=\"3\" fill=\"" + curve.color + "\"/>\n";
      }
      svg += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + curve.color + "\"/>\n";
      svg += text(width - right - 8, legend, curve.name,
                  "text-anchor=\"end\" fill=\"" + curve.color + '"');
      legend += 16;
    }
    return svg;
  }

  const LogPlot& plot_;
  Axis x_;
  Axis y_;
};

}  // namespace cocoon::bench
