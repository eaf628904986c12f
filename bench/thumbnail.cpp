#include "bench/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/encoding/byte_order.h"

namespace cocoon::bench {
namespace {

// Colors of the palette: the background, then shades of the two sides from dark to light.
constexpr int shades = 127;
constexpr std::uint8_t background = 0;
constexpr int outside = 1;
constexpr int inside = outside + shades;

// x, y: pixels; z: towards the viewer.
Vec3 seen_from_above(const Vec3& p) {
  static const Vec3 toward = unit(Vec3{0.5, -0.8, 0.55});
  static const Vec3 right = unit(cross(Vec3{0, 0, 1}, toward));
  static const Vec3 up = cross(toward, right);
  return {dot(p, right), dot(p, up), dot(p, toward)};
}

class Picture {
 public:
  explicit Picture(int size)
      : size_(size),
        pixels_(static_cast<std::size_t>(size * size), background),
        nearest_(pixels_.size(), -std::numeric_limits<double>::infinity()) {}

  // Corners in pixels.
  void draw(const std::array<Vec3, 3>& corners) {
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (normal.z == 0 || !is_finite(normal)) return;  // seen from the side
    const std::uint8_t color =
        shade(normal.z > 0 ? unit(normal) : -1.0 * unit(normal), normal.z > 0 ? outside : inside);
    const auto [low_x, high_x] = pixel_range(corners[0].x, corners[1].x, corners[2].x);
    const auto [low_y, high_y] = pixel_range(corners[0].y, corners[1].y, corners[2].y);
    for (int y = low_y; y <= high_y; ++y) {
      for (int x = low_x; x <= high_x; ++x) {
        const Vec3 at{x + 0.5, y + 0.5, 0};
        if (!is_within(corners, at, normal.z)) continue;
        const Vec3 off = at - corners[0];
        set(x, y, corners[0].z - (normal.x * off.x + normal.y * off.y) / normal.z, color);
      }
    }
  }

  // Rows from the bottom up, as y goes.
  std::string bmp() const {
    const auto width = static_cast<std::uint32_t>(size_);
    const std::uint32_t row = (width + 3) / 4 * 4;
    constexpr std::uint32_t header = 14 + 40 + 4 * 256;
    std::string file = "BM";
    append_little_endian(file, header + row * width);
    append_little_endian(file, std::uint32_t{0});
    append_little_endian(file, header);
    for (const std::uint32_t number : {std::uint32_t{40}, width, width}) {
      append_little_endian(file, number);
    }
    append_little_endian(file, std::uint16_t{1});  // planes
    append_little_endian(file, std::uint16_t{8});  // bits of a pixel
    for (const std::uint32_t number : {0U, row * width, 2835U, 2835U, 256U, 0U}) {
      append_little_endian(file, number);
    }
    append_palette(file);
    for (std::uint32_t y = 0; y < width; ++y) {
      file.append(reinterpret_cast<const char*>(pixels_.data()) + y * width, width);
      file.append(row - width, '\0');
    }
    return file;
  }

 private:
  std::array<int, 2> pixel_range(double a, double b, double c) const {
    const double last = size_ - 1;
    return {static_cast<int>(std::clamp(std::floor(std::min({a, b, c})), 0.0, last)),
            static_cast<int>(std::clamp(std::floor(std::max({a, b, c})), 0.0, last))};
  }

  static bool is_within(const std::array<Vec3, 3>& corners, const Vec3& at, double turn) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 side = corners[(i + 1) % 3] - corners[i];
      const Vec3 off = at - corners[i];
      if ((side.x * off.y - side.y * off.x) * turn < 0) return false;
    }
    return true;
  }

  static std::uint8_t shade(const Vec3& normal, int first) {
    static const Vec3 light = unit(Vec3{-0.4, 0.5, 0.75});
    const double brightness = 0.25 + 0.75 * std::max(0.0, dot(normal, light));
    return static_cast<std::uint8_t>(first + static_cast<int>(brightness * (shades - 1)));
  }

  void set(int x, int y, double z, std::uint8_t color) {
    const auto at = static_cast<std::size_t>(y * size_ + x);
    if (z <= nearest_[at]) return;
    nearest_[at] = z;
    pixels_[at] = color;
  }

  static void append_palette(std::string& file) {
    for (int i = 0; i < 256; ++i) {
      double brightness = 1;
      std::array<double, 3> tint = {255, 255, 255};  // blue, green, red
      if (i >= outside && i < inside + shades) {
        brightness = static_cast<double>((i - outside) % shades) / (shades - 1);
        tint =
            i < inside ? std::array<double, 3>{232, 222, 208} : std::array<double, 3>{60, 60, 225};
      }
      for (const double part : tint) file += static_cast<char>(static_cast<int>(brightness * part));
      file += '\0';
    }
  }

  int size_;
  std::vector<std::uint8_t> pixels_;
  std::vector<double> nearest_;
};

}  // namespace

std::string thumbnail_bmp(const TriangleMesh& mesh, const Box& frame, int size) {
  const double scale = 0.95 * size / norm(frame.size());
  const Vec3 middle{0.5 * size, 0.5 * size, 0};
  const Vec3 center = seen_from_above(frame.center());
  Picture picture(size);
  for (const Triangle& t : mesh.triangles) {
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = scale * (seen_from_above(mesh.points[t[i]]) - center) + middle;
    }
    picture.draw(corners);
  }
  return picture.bmp();
}

}  // namespace cocoon::bench
