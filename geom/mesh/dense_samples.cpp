#include "geom/mesh/dense_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <sstream>
#include <string>

#include "geom/errors.h"
#include "geom/mesh/linked_mesh.h"
#include "geom/mesh/sharp_edges.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/messages/require_number.h"
#include "geom/random/mixed_bits.h"
#include "geom/random/random.h"
#include "geom/random/random_point.h"
#include "geom/triangle_normal.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

// The samples that there are, by cells of a grid; cells with one hash share a list.
class SampleGrid {
 public:
  SampleGrid(double closest, std::size_t expected)
      : closest_(closest), heads_(std::bit_ceil(expected + 1), none) {}

  // The normal of the triangle it is in; zero: it is close to all others.
  void add(const Point& p, const Vec3& normal) {
    std::uint32_t& head = heads_[slot(place(p.x), place(p.y), place(p.z))];
    samples_.push_back({p, normal, head});
    head = static_cast<std::uint32_t>(samples_.size() - 1);
  }

  bool has_room(const Point& p, const Vec3& normal) const {
    for (std::int64_t x = place(p.x - closest_); x <= place(p.x + closest_); ++x) {
      for (std::int64_t y = place(p.y - closest_); y <= place(p.y + closest_); ++y) {
        for (std::int64_t z = place(p.z - closest_); z <= place(p.z + closest_); ++z) {
          if (is_close(p, normal, heads_[slot(x, y, z)])) return false;
        }
      }
    }
    return true;
  }

 private:
  struct Sample {
    Point point;
    Vec3 normal;
    std::uint32_t next;
  };

  std::int64_t place(double x) const {
    constexpr double farthest = 1e18;  // where doubles lie farther apart than cells anyway
    return static_cast<std::int64_t>(
        std::clamp(std::floor(x / (2 * closest_)), -farthest, farthest));
  }
  std::size_t slot(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const auto word = [](std::int64_t i) { return static_cast<std::uint64_t>(i); };
    return mixed_bits(mixed_bits(mixed_bits(word(x)) ^ word(y)) ^ word(z)) & (heads_.size() - 1);
  }
  bool is_close(const Point& p, const Vec3& normal, std::uint32_t first) const {
    for (std::uint32_t k = first; k != none; k = samples_[k].next) {
      const Sample& s = samples_[k];
      const bool faces_away = dot(s.normal, normal) <= 0 && s.normal != Vec3{};
      if (!faces_away && squared_distance(p, s.point) < closest_ * closest_) return true;
    }
    return false;
  }

  double closest_;
  std::vector<std::uint32_t> heads_;
  std::vector<Sample> samples_;
};

// A message for who wants more samples than there can be.
[[noreturn]] void refuse(double spacing, const std::string& count, double possible) {
  std::ostringstream text;
  text << "samples " << spacing << " apart would be " << count << " on this mesh, more than "
       << most_dense_samples << "; choose a spacing of " << possible << " or more";
  throw InputError(text.str());
}

// The area in squares of one spacing. Throws InputError if these are too many. `scale`: what
// coordinates and spacing were multiplied by.
double squares_of(double spacing, double area, double scale) {
  const double squares = area / spacing / spacing;
  if (squares <= most_dense_samples) return squares;
  std::ostringstream count;
  count << "about " << squares;
  refuse(spacing / scale, count.str(), std::sqrt(area / most_dense_samples) / scale);
}

// Evenly along all sharp edges, without their ends.
std::vector<Point> samples_of_sharp_edges(const TriangleMesh& mesh,
                                          const DenseSampleOptions& options, double scale,
                                          const Execution& execution) {
  const LinkedMesh linked = link_mesh(mesh, execution);
  const std::vector<Halfedge> sharp = sharp_edges(linked, options.smooth_cosine);
  double length = 0;
  for (const Halfedge halfedge : sharp) {
    length += distance(linked.points[linked.from(halfedge)], linked.points[linked.to(halfedge)]);
  }
  if (length / options.spacing > most_dense_samples) {
    refuse(options.spacing / scale, "too many along the sharp edges",
           length / most_dense_samples / scale);
  }
  std::vector<Point> samples;
  for (const Halfedge halfedge : sharp) {
    // From the lexicographically smaller end, so that the direction of the halfedge does not
    // matter.
    const auto [a, b] =
        std::minmax(linked.points[linked.from(halfedge)], linked.points[linked.to(halfedge)]);
    const double parts = std::ceil(distance(a, b) / options.spacing);
    for (double k = 1; k < parts; ++k) samples.push_back(a + (k / parts) * (b - a));
  }
  return samples;
}

// Random places in triangles, where there is room.
class Darts {
 public:
  Darts(const DenseSampleOptions& options, double all_squares, const Execution& execution,
        SampleGrid& grid, std::vector<Point>& samples)
      : square_(options.spacing * options.spacing),
        all_squares_(all_squares),
        execution_(execution),
        trials_(static_cast<double>(options.trials)),
        random_(options.seed),
        grid_(grid),
        samples_(samples) {}

  // Large triangles are cut in four, again and again: so places that follow each other are close,
  // and what is asked of the grid is at hand.
  void throw_into(const Point& a, const Point& b, const Point& c) {
    constexpr double most_squares = 4;
    const double squares = norm(area_normal(a, b, c)) / 2 / square_;
    if (squares > most_squares) {
      const Point ab = 0.5 * (a + b);
      const Point bc = 0.5 * (b + c);
      const Point ca = 0.5 * (c + a);
      throw_into(a, ab, ca);
      throw_into(ab, bc, ca);
      throw_into(ab, b, bc);
      throw_into(ca, bc, c);
      return;
    }
    done_squares_ += squares;
    if (++leaves_ % leaves_per_report == 0) {
      report_progress(execution_, "dense_samples", std::min(done_squares_ / all_squares_, 1.0));
    }
    const Vec3 normal = area_normal(a, b, c);
    const double count = std::floor(trials_ * squares + random_.uniform());
    for (double k = 0; k < count; ++k) {
      const Point p = random_point_in(a, b, c, random_);
      if (!grid_.has_room(p, normal)) continue;
      grid_.add(p, normal);
      samples_.push_back(p);
    }
  }

 private:
  static constexpr std::size_t leaves_per_report = 256;

  double square_;
  double all_squares_;
  double done_squares_ = 0;
  std::size_t leaves_ = 0;  // triangles that were not cut
  const Execution& execution_;
  double trials_;
  Random random_;
  SampleGrid& grid_;
  std::vector<Point>& samples_;
};

// `scale`: what coordinates and spacing were multiplied by.
std::vector<Point> samples_of(const TriangleMesh& mesh, const DenseSampleOptions& options,
                              double scale, const Execution& execution) {
  const double squares = squares_of(options.spacing, TrianglesByArea(mesh).area(), scale);
  report_progress(execution, "dense_samples", 0);
  std::vector<Point> samples = samples_of_sharp_edges(mesh, options, scale, execution);
  SampleGrid grid(options.closest * options.spacing,
                  mesh.points.size() + samples.size() + static_cast<std::size_t>(squares));
  for (const Point& p : mesh.points) grid.add(p, {});
  for (const Point& p : samples) grid.add(p, {});
  Darts darts(options, squares, execution, grid, samples);
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto [a, b, c] = corners_of(mesh, t);
    darts.throw_into(a, b, c);
  }
  report_progress(execution, "dense_samples", 1);
  return samples;
}

}  // namespace

// Areas take fourth powers of lengths: beyond working sizes they would overflow or vanish.
std::vector<Point> dense_samples(const TriangleMesh& mesh, const DenseSampleOptions& options,
                                 const Execution& execution) {
  require_valid_triangles(mesh);
  if (!(options.spacing > 0) || !std::isfinite(options.spacing)) {
    throw InputError("dense_samples: the spacing of samples must be a positive number");
  }
  if (!(options.closest > 0) || !std::isfinite(options.closest * options.spacing)) {
    throw InputError(
        "dense_samples: how close samples may come must be a positive number of spacings");
  }
  require_cosines("dense_samples", {{"smooth_cosine", options.smooth_cosine}});
  const double scale = working_scale(mesh.points.raw());
  if (scale == 1) return samples_of(mesh, options, 1, execution);
  DenseSampleOptions scaled_options = options;
  scaled_options.spacing *= scale;
  std::vector<Point> samples = samples_of(scaled(mesh, scale), scaled_options, scale, execution);
  for (Point& p : samples) p = p / scale;
  return samples;
}

}  // namespace cocoon
