#include "cocone/cocone_radii.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "cocone/double_cone.h"
#include "cocone/shared_maxima.h"

namespace cocoon {
namespace {

constexpr std::size_t facets_per_chunk = 2048;
constexpr double infinity = std::numeric_limits<double>::infinity();

// A dual edge relative to the sample, in units of 1 / scale.
struct RelativeEdge {
  Vec3 x;
  Vec3 y;  // the other end, or the direction of the ray
  bool is_ray = false;
};

// Largest squared |x + t d| at the crossings of the edge with the cone |x.n| = C |x|.
double squared_crossing_with_cone(const RelativeEdge& e, const Vec3& n, double squared_cosine) {
  const Vec3 d = e.is_ray ? e.y : e.y - e.x;
  // a t^2 + 2 b t + c = 0 for the difference of the squares of both sides
  const double xn = dot(e.x, n);
  const double dn = dot(d, n);
  const double a = dn * dn - squared_cosine * squared_norm(d);
  const double b = xn * dn - squared_cosine * dot(e.x, d);
  const double c = xn * xn - squared_cosine * squared_norm(e.x);
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  const double q = -(b + std::copysign(root, b));
  const double last = e.is_ray ? infinity : 1.0;
  double largest = 0;
  for (const double t : {q / a, c / q}) {
    if (!(t >= 0 && t <= last) || !std::isfinite(t)) continue;
    largest = std::max(largest, squared_norm(e.x + t * d));
  }
  // Rounding must not carry a crossing beyond the ends of a segment.
  return e.is_ray ? largest : std::min(largest, std::max(squared_norm(e.x), squared_norm(e.y)));
}

double squared_radius_in_cocone(const RelativeEdge& e, const Vec3& n, double squared_cosine) {
  const ConeSide from = cone_side(e.x, n, squared_cosine);
  const ConeSide to = cone_side(e.y, n, squared_cosine);
  double largest = 0;
  if (in_cocone(from)) largest = squared_norm(e.x);
  if (in_cocone(to)) largest = e.is_ray ? infinity : std::max(largest, squared_norm(e.y));
  if (in_cocone(from) && in_cocone(to)) return largest;
  return std::max(largest, squared_crossing_with_cone(e, n, squared_cosine));
}

double squared_radius_in_plane(const RelativeEdge& e, const Vec3& n) {
  const double xn = dot(e.x, n);
  const double yn = dot(e.y, n);
  if (xn == 0) return squared_norm(e.x);
  if (yn == 0) return e.is_ray ? infinity : squared_norm(e.y);
  const bool crosses = (xn < 0) != (yn < 0);
  if (e.is_ray) return crosses ? squared_norm(e.x - (xn / yn) * e.y) : 0;
  // Which segments cross the plane cannot be foreseen: computed in any case, without a branch.
  const double squared = squared_norm((1 / (yn - xn)) * (yn * e.x - xn * e.y));
  return crosses ? squared : 0;
}

// The two ends of a dual edge: the lexicographically smaller Voronoi vertex first, or the origin of
// the ray.
struct DualEnds {
  Point from;
  Vec3 to;
  bool is_ray = false;
};

// Calls visit(k, ends) for the facets begin ... end - 1 of `cocones`.
template <class Visit>
void for_each_dual_edge(const Triangulation& triangulation, const Dual& dual,
                        const Cocones& cocones, std::size_t begin, std::size_t end, Visit visit) {
  constexpr std::size_t facets_per_block = max_block_cells / 2;
  std::array<CellId, max_block_cells> cells;
  CellBlock block;
  for (std::size_t first = begin; first < end; first += facets_per_block) {
    const std::size_t count = std::min(facets_per_block, end - first);
    for (std::size_t k = 0; k < count; ++k) {
      const FacetId f = cocones.facets[first + k];
      const CellId behind = cell_of(triangulation.mirror(f));
      cells[2 * k] = cell_of(f);  // finite: the id is canonical
      cells[2 * k + 1] = triangulation.is_infinite(behind) ? cell_of(f) : behind;
    }
    load_cells(triangulation, dual, std::span(cells).first(2 * count), block);
    for (std::size_t k = 0; k < count; ++k) {
      const Point here = block.center(2 * k);
      const Point there = block.center(2 * k + 1);
      if (cells[2 * k] == cells[2 * k + 1]) {
        const CellId behind = cell_of(triangulation.mirror(cocones.facets[first + k]));
        visit(first + k, DualEnds{here, center_of(triangulation, dual, behind), true});
      } else {
        visit(first + k,
              there < here ? DualEnds{there, here, false} : DualEnds{here, there, false});
      }
    }
  }
}

double largest_coordinate(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// The radii of dual edges, as a maximum per sample. Nearly all are kept in squares; products of
// four lengths occur, so edges to the far centers of slivers are measured in larger units.
class Radii {
 public:
  Radii(const Cocones& cocones, RadiusMode mode, std::size_t num_vertices,
        const Execution& execution)
      : squared_cosine_(cocones.cosine * cocones.cosine),
        mode_(mode),
        squared_(num_vertices, execution) {}

  // Of the corners of `cell` whose bits are set in `row`.
  void take(const Triangulation& triangulation, const Poles& poles, const Cell& cell, unsigned row,
            const DualEnds& ends) {
    const double reach =
        std::max(largest_coordinate(ends.from), ends.is_ray ? 0 : largest_coordinate(ends.to));
    const bool is_far = reach > largest_safe_length;
    for (; row != 0; row &= row - 1) {
      const VertexId v = cell.vertices[static_cast<std::size_t>(std::countr_zero(row))];
      const Point& p = triangulation.point(v);
      if (is_far) {
        take_far(v, ends, p, poles.normals[v]);
      } else {
        const RelativeEdge edge{ends.from - p, ends.is_ray ? ends.to : ends.to - p, ends.is_ray};
        squared_.raise(v, squared_radius(edge, poles.normals[v]));
      }
    }
  }
  void take_infinite(VertexId v) { squared_.raise(v, infinity); }

  IdVector<VertexId, double> result() && {
    IdVector<VertexId, double> radii = std::move(squared_).take();
    for (double& radius : radii) radius = std::sqrt(radius);
    for (const auto& [v, radius] : far_) radii[v] = std::max(radii[v], radius);
    return radii;
  }

 private:
  void take_far(VertexId v, const DualEnds& ends, const Point& p, const Vec3& normal) {
    const RelativeEdge edge{shrink * (ends.from - p),
                            ends.is_ray ? ends.to : shrink * (ends.to - p), ends.is_ray};
    const double radius = std::sqrt(squared_radius(edge, normal)) / shrink;
    const std::lock_guard lock(mutex_);
    far_.emplace_back(v, radius);
  }

  double squared_radius(const RelativeEdge& edge, const Vec3& normal) const {
    return mode_ == RadiusMode::cocone ? squared_radius_in_cocone(edge, normal, squared_cosine_)
                                       : squared_radius_in_plane(edge, normal);
  }

  double squared_cosine_;
  RadiusMode mode_;
  SharedMaxima squared_;
  std::mutex mutex_;
  std::vector<std::pair<VertexId, double>> far_;
};

}  // namespace

IdVector<VertexId, double> cocone_radii(const Triangulation& triangulation, const Dual& dual,
                                        const Poles& poles, const Cocones& cocones, RadiusMode mode,
                                        const Execution& execution) {
  Radii radii(cocones, mode, triangulation.num_vertices(), execution);
  const std::size_t facets = cocones.facets.size();
  parallel_chunks(execution, facets, facets_per_chunk, [&](std::size_t begin, std::size_t end) {
    for_each_dual_edge(triangulation, dual, cocones, begin, end,
                       [&](std::size_t k, const DualEnds& ends) {
                         const Cell& cell = triangulation.cell(cell_of(cocones.facets[k]));
                         radii.take(triangulation, poles, cell, cocones.rows[k], ends);
                       });
  });
  if (mode == RadiusMode::tangent_plane) {
    for (const CellId c : triangulation.infinite_cells()) {
      const Vec3 ray = center_of(triangulation, dual, c);
      for (unsigned j = 0; j < 3; ++j) {
        const VertexId p = triangulation.cell(c).vertices[j];
        if (!(dot(ray, poles.normals[p]) > 0)) radii.take_infinite(p);
      }
    }
  }
  return std::move(radii).result();
}

}  // namespace cocoon
