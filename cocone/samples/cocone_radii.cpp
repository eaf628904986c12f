#include "cocone/samples/cocone_radii.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "cocone/samples/double_cone.h"
#include "cocone/samples/vertex_maxima.h"
#include "geom/parallel/parallel_fold.h"
#include "geom/parallel/parallel_list.h"

namespace cocoon {
namespace {

constexpr std::size_t facets_per_chunk = 2048;
constexpr double infinity = std::numeric_limits<double>::infinity();

// A dual edge relative to the sample; where that is far away, times `shrink` (double_cone.h).
struct RelativeEdge {
  Vec3 x;
  Vec3 y;  // the other end, or the direction of the ray
  bool is_ray = false;
};

// Largest squared |x + t d| at the crossings of the edge with the cone |x.n| = C |x|.
double squared_crossing_with_cone(RelativeEdge e, const Vec3& n, double squared_cosine) {
  // From the nearer end: seen from one that is far away, as those of slivers are, a crossing near
  // the sample is lost in roundings.
  if (!e.is_ray && squared_norm(e.y) < squared_norm(e.x)) std::swap(e.x, e.y);
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

// A facet of the list and the corners whose radius is asked for, as bits of its cell's vertices.
struct AskedFacet {
  FacetId facet;
  std::uint8_t corners;
};

// Calls visit(asked facet, its ends) for all of them.
template <class Visit>
void for_each_dual_edge(const Triangulation& triangulation, const Dual& dual,
                        std::span<const AskedFacet> facets, Visit visit) {
  constexpr std::size_t facets_per_block = max_block_cells / 2;
  std::array<CellId, max_block_cells> cells;
  CellBlock block;
  while (!facets.empty()) {
    const std::size_t count = std::min(facets_per_block, facets.size());
    for (std::size_t k = 0; k < count; ++k) {
      const FacetId f = facets[k].facet;
      const CellId behind = cell_of(triangulation.mirror(f));
      cells[2 * k] = cell_of(f);  // finite: the id is canonical
      cells[2 * k + 1] = triangulation.is_infinite(behind) ? cell_of(f) : behind;
    }
    load_cells(triangulation, dual, std::span(cells).first(2 * count), block);
    for (std::size_t k = 0; k < count; ++k) {
      const Point here = block.center(2 * k);
      const Point there = block.center(2 * k + 1);
      if (cells[2 * k] == cells[2 * k + 1]) {
        const CellId behind = cell_of(triangulation.mirror(facets[k].facet));
        visit(facets[k], DualEnds{here, center_of(triangulation, dual, behind), true});
      } else {
        visit(facets[k],
              there < here ? DualEnds{there, here, false} : DualEnds{here, there, false});
      }
    }
    facets = facets.subspan(count);
  }
}

double largest_coordinate(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// The radii of dual edges, as a maximum per sample. Nearly all are kept in squares; products of
// four lengths occur, so edges to the far centers of slivers are measured in larger units.
class Radii {
 public:
  Radii(const Cocones& cocones, RadiusMode mode, std::size_t num_vertices)
      : squared_cosine_(cocones.cosine * cocones.cosine), mode_(mode), squared_(num_vertices) {}

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
  // All that others have taken.
  void join(const Radii& others, const Execution& execution) {
    squared_.join(others.squared_, execution);
    far_.insert(far_.end(), others.far_.begin(), others.far_.end());
  }

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
    far_.emplace_back(v, std::sqrt(squared_radius(edge, normal)) / shrink);
  }

  double squared_radius(const RelativeEdge& edge, const Vec3& normal) const {
    return mode_ == RadiusMode::cocone ? squared_radius_in_cocone(edge, normal, squared_cosine_)
                                       : squared_radius_in_plane(edge, normal);
  }

  double squared_cosine_;
  RadiusMode mode_;
  VertexMaxima squared_;
  std::vector<std::pair<VertexId, double>> far_;
};

// The corners of facet k of `cocones` whose cocone it meets and that have a flag.
unsigned asked_corners(const Cocones& cocones, const VertexSet& samples, std::size_t k) {
  const int* const places = facet_corners[index_of(cocones.facets[k])];
  unsigned asked = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    asked |= (samples[cocones.corners[k][i]] != 0 ? 1U : 0U) << places[i];
  }
  return asked & cocones.rows[k];
}

}  // namespace

std::vector<VertexId> unbounded_in_plane(const Triangulation& triangulation, const Dual& dual,
                                         const Poles& poles) {
  std::vector<VertexId> unbounded;
  for (const CellId c : triangulation.infinite_cells()) {
    const Vec3 ray = center_of(triangulation, dual, c);
    for (unsigned j = 0; j < 3; ++j) {
      const VertexId p = triangulation.cell(c).vertices[j];
      if (!(dot(ray, poles.normals[p]) > 0)) unbounded.push_back(p);
    }
  }
  return unbounded;
}

IdVector<VertexId, double> cocone_radii(const Triangulation& triangulation, const Dual& dual,
                                        const Poles& poles, const Cocones& cocones, RadiusMode mode,
                                        const VertexSet& samples, const Execution& execution) {
  const std::vector<AskedFacet> facets = parallel_list<AskedFacet>(
      execution, cocones.facets.size(), facets_per_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<AskedFacet>& asked) {
        for (std::size_t k = begin; k < end; ++k) {
          const unsigned corners = asked_corners(cocones, samples, k);
          if (corners == 0) continue;
          asked.push_back({cocones.facets[k], static_cast<std::uint8_t>(corners)});
        }
      });
  Radii radii = parallel_fold(
      execution, facets.size(), facets_per_chunk,
      [&] { return Radii(cocones, mode, triangulation.num_vertices()); },
      [&](Radii& part, std::size_t begin, std::size_t end) {
        for_each_dual_edge(triangulation, dual, std::span(facets).subspan(begin, end - begin),
                           [&](const AskedFacet& asked, const DualEnds& ends) {
                             const Cell& cell = triangulation.cell(cell_of(asked.facet));
                             part.take(triangulation, poles, cell, asked.corners, ends);
                           });
      },
      [&](Radii& all, const Radii& others) { all.join(others, execution); });
  if (mode == RadiusMode::tangent_plane) {
    for (const VertexId p : unbounded_in_plane(triangulation, dual, poles)) {
      if (samples[p] != 0) radii.take_infinite(p);
    }
  }
  return std::move(radii).result();
}

IdVector<VertexId, double> cocone_radii(const Triangulation& triangulation, const Dual& dual,
                                        const Poles& poles, const Cocones& cocones, RadiusMode mode,
                                        const Execution& execution) {
  return cocone_radii(triangulation, dual, poles, cocones, mode,
                      VertexSet(triangulation.num_vertices(), 1), execution);
}

}  // namespace cocoon
