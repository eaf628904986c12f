#include "cocone/cocones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cocone/double_cone.h"
#include "delaunay/circulate.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 16384;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Side of a Voronoi vertex, or of the direction of a ray, in the double cone of v.
ConeSide side_of_dual(const Triangulation& triangulation, const Dual& dual, const Poles& poles,
                      double squared_cosine, CellId c, VertexId v) {
  const Point& center = dual.centers[c];
  const Vec3 x = triangulation.is_infinite(c) ? center : center - triangulation.point(v);
  return cone_side(x, poles.normals[v], squared_cosine);
}

// Two bits per corner of a cell: the side of its Voronoi vertex in the double cone of the corner.
using CornerSides = std::uint8_t;

constexpr ConeSide side_at(CornerSides sides, int corner) {
  return static_cast<ConeSide>((static_cast<unsigned>(sides) >> (2 * corner)) & 3U);
}

CornerSides sides_of_cell(const Triangulation& triangulation, const Dual& dual, const Poles& poles,
                          double squared_cosine, CellId c) {
  unsigned sides = 0;
  for (int j = 0; j < (triangulation.is_infinite(c) ? 3 : 4); ++j) {
    const VertexId v = triangulation.vertex(c, j);
    const ConeSide side = side_of_dual(triangulation, dual, poles, squared_cosine, c, v);
    sides |= static_cast<unsigned>(side) << (2 * j);
  }
  return static_cast<CornerSides>(sides);
}

// Asks for what bits_of_cell is soon to read: most of its time went into waiting for that.
void fetch_neighbors(const Triangulation& triangulation, const IdVector<CellId, CornerSides>& sides,
                     CellId c) {
  for (const FacetId neighbor : triangulation.cell(c).neighbors) {
    __builtin_prefetch(&triangulation.cell(cell_of(neighbor)));
    __builtin_prefetch(&sides[cell_of(neighbor)]);
  }
}

// The sixteen bits of a cell: both ends of its dual edges are looked up.
unsigned bits_of_cell(const Triangulation& triangulation,
                      const IdVector<CellId, CornerSides>& sides, CellId c) {
  const Cell& cell = triangulation.cell(c);
  unsigned bits = 0;
  for (int i = triangulation.is_infinite(c) ? 3 : 0; i < 4; ++i) {
    const CellId behind = cell_of(cell.neighbors[static_cast<std::size_t>(i)]);
    const Cell& cell_behind = triangulation.cell(behind);
    for (const int j : facet_corners[i]) {
      const VertexId v = cell.vertices[static_cast<std::size_t>(j)];
      const ConeSide other = side_at(sides[behind], index_of_vertex(cell_behind, v));
      bits |= static_cast<unsigned>(meets_cocone(side_at(sides[c], j), other)) << (4 * i + j);
    }
  }
  return bits;
}

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
  if ((xn < 0) == (yn < 0)) return 0;
  if (e.is_ray) return squared_norm(e.x - (xn / yn) * e.y);
  return squared_norm((1 / (yn - xn)) * (yn * e.x - xn * e.y));
}

// The dual edge of f relative to p, from the lexicographically smaller end.
RelativeEdge relative_edge(const Triangulation& triangulation, const Dual& dual, FacetId f,
                           const Point& p, double scale) {
  CellId from = cell_of(f);
  CellId to = cell_of(triangulation.mirror(f));
  if (triangulation.is_infinite(from)) std::swap(from, to);
  if (triangulation.is_infinite(to)) {
    return {scale * (dual.centers[from] - p), dual.centers[to], true};
  }
  if (dual.centers[to] < dual.centers[from]) std::swap(from, to);
  return {scale * (dual.centers[from] - p), scale * (dual.centers[to] - p), false};
}

struct RadiusQuery {
  const Triangulation& triangulation;
  const Dual& dual;
  std::span<const CellId> star;
  const Cocones& cocones;
  VertexId p;
  Vec3 normal;
  RadiusMode mode;
};

double squared_radius(const RadiusQuery& query, double scale) {
  const Triangulation& triangulation = query.triangulation;
  const double squared_cosine = query.cocones.cosine * query.cocones.cosine;
  double largest = 0;
  for (const CellId c : query.star) {
    if (triangulation.is_infinite(c) && query.mode == RadiusMode::tangent_plane &&
        !(dot(query.dual.centers[c], query.normal) > 0)) {
      return infinity;
    }
    if (query.cocones.meets[c] == 0) continue;
    const int corner = index_of_vertex(triangulation.cell(c), query.p);
    const unsigned met = query.cocones.meets[c] & (0x1111U << corner);
    if (met == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      if (((met >> (4 * i)) & 15U) == 0 || triangulation.mirror(f) < f) continue;
      const RelativeEdge edge =
          relative_edge(triangulation, query.dual, f, triangulation.point(query.p), scale);
      largest = std::max(largest, query.mode == RadiusMode::cocone
                                      ? squared_radius_in_cocone(edge, query.normal, squared_cosine)
                                      : squared_radius_in_plane(edge, query.normal));
    }
  }
  return largest;
}

// Of the Voronoi vertices that squared_radius reads: the two ends of an edge both have bits.
double largest_coordinate(const RadiusQuery& query) {
  double largest = 0;
  for (const CellId c : query.star) {
    if (query.cocones.meets[c] == 0) continue;
    const Point& center = query.dual.centers[c];
    largest = std::max({largest, std::abs(center.x), std::abs(center.y), std::abs(center.z)});
  }
  return largest;
}

}  // namespace

Cocones intersect_cocones(const Triangulation& triangulation, const Dual& dual, const Poles& poles,
                          const CoconeOptions& options, const Execution& execution) {
  report_progress(execution, "intersect_cocones", 0);
  const double squared_cosine = options.cosine * options.cosine;
  const std::size_t count = triangulation.num_cells();
  IdVector<CellId, CornerSides> sides(count);
  parallel_chunks(execution, count, cells_per_chunk, [&](std::size_t begin, std::size_t end) {
    for (CellId c(begin); c.index() < end; ++c) {
      sides[c] = sides_of_cell(triangulation, dual, poles, squared_cosine, c);
    }
  });
  report_progress(execution, "intersect_cocones", 0.6);
  Cocones cocones{IdVector<CellId, std::uint16_t>(count), options.cosine};
  parallel_chunks(execution, count, cells_per_chunk, [&](std::size_t begin, std::size_t end) {
    for (CellId c(begin); c.index() < end; ++c) {
      constexpr std::size_t ahead = 16;
      if (c.index() + ahead < end) {
        fetch_neighbors(triangulation, sides, CellId(c.index() + ahead));
      }
      cocones.meets[c] = static_cast<std::uint16_t>(bits_of_cell(triangulation, sides, c));
    }
  });
  report_progress(execution, "intersect_cocones", 1);
  return cocones;
}

double cocone_radius(const Triangulation& triangulation, const Dual& dual, const VertexStars& stars,
                     const Poles& poles, const Cocones& cocones, VertexId p, RadiusMode mode) {
  const RadiusQuery query{triangulation, dual, stars.star(p), cocones, p, poles.normals[p], mode};
  // Products of four lengths occur: far centers are measured in larger units.
  const double scale = largest_coordinate(query) > largest_safe_length ? shrink : 1.0;
  return std::sqrt(squared_radius(query, scale)) / scale;
}

}  // namespace cocoon
