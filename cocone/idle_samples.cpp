#include "cocone/idle_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cocone/cell_order.h"
#include "cocone/facet_size.h"
#include "delaunay/circulate.h"

namespace cocoon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Of a facet, unoriented: the same bits from both sides. Its length is twice the area.
Vec3 normal_of(const Triangulation& triangulation, FacetId f) {
  const std::array<Point, 3> p = sorted_corners(triangulation, f);
  return cross(p[1] - p[0], p[2] - p[0]);
}

// Whether holds(f) for all facets of the surface at v; asked until one fails.
template <class Holds>
bool all_of_surface_facets_at(const Triangulation& triangulation, std::span<const CellId> star,
                              const IdVector<CellId, std::uint8_t>& out, VertexId v, Holds holds) {
  for (const CellId c : star) {
    if (out[c] != 0) continue;
    const int opposite = index_of_vertex(triangulation.cell(c), v);
    for (int i = 0; i < 4; ++i) {
      if (i == opposite || out[triangulation.neighbor(c, i)] == 0) continue;
      if (!holds(facet_id(c, i))) return false;
    }
  }
  return true;
}

// The two nearest of the vertices it is told, each of which may come several times.
class TwoNearest {
 public:
  void add(VertexId w, double distance) {
    if (w == first_ || w == second_ || !(distance < second_distance_)) return;
    second_ = w;
    second_distance_ = distance;
    if (second_distance_ < first_distance_) {
      std::swap(first_, second_);
      std::swap(first_distance_, second_distance_);
    }
  }
  double second() const { return second_distance_; }

 private:
  VertexId first_;
  VertexId second_;
  double first_distance_ = infinity;
  double second_distance_ = infinity;
};

// Two facets lie in no common plane if their normals differ by more than twice the angle allowed.
bool is_bent(const Vec3& a, const Vec3& b, double flat_cosine) {
  const double twice = 2 * flat_cosine * flat_cosine - 1 - 1e-9;  // with room for rounding
  const double along = dot(a, b);
  return twice > 0 && along * along < twice * twice * squared_norm(a) * squared_norm(b);
}

}  // namespace

bool is_idle(const Triangulation& triangulation, std::span<const CellId> star,
             const IdVector<CellId, std::uint8_t>& out, VertexId v, const IdleOptions& options) {
  // The plane is that of the largest facet.
  Vec3 plane;
  double largest = 0;
  const bool may_be_flat = all_of_surface_facets_at(triangulation, star, out, v, [&](FacetId f) {
    const Vec3 normal = normal_of(triangulation, f);
    const double area = squared_norm(normal);
    if (largest > 0 && is_bent(normal, plane, options.flat_cosine)) return false;
    if (area < largest || (area == largest && !(plane < normal))) return true;
    largest = area;
    plane = normal;
    return true;
  });
  if (largest == 0 || !may_be_flat) return false;  // 0: not on the surface
  plane = unit(plane);
  double narrowest = infinity;
  TwoNearest nearest;
  const Point& p = triangulation.point(v);
  const bool flat = all_of_surface_facets_at(triangulation, star, out, v, [&](FacetId f) {
    const double cosine = dot(unit(normal_of(triangulation, f)), plane);
    if (!(std::abs(cosine) >= options.flat_cosine)) return false;
    narrowest = std::min(narrowest, size_of_facet(triangulation, f).squared_circumradius);
    for (const VertexId w : triangulation.facet_vertices(f)) {
      if (w != v) nearest.add(w, squared_norm(triangulation.point(w) - p));
    }
    return true;
  });
  return flat && narrowest >= options.ratio * options.ratio * nearest.second();
}

}  // namespace cocoon
