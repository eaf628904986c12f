#include "cocone/energy/idle_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cocone/facets/cell_order.h"
#include "cocone/facets/facet_size.h"
#include "delaunay/circulate.h"
#include "geom/triangle_normal.h"

namespace cocoon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Of a facet, unoriented: the same bits from both sides. Its length is twice the area.
Vec3 normal_of(const Triangulation& triangulation, FacetId f) {
  const std::array<Point, 3> p = sorted_corners(triangulation, f);
  return area_normal(p[0], p[1], p[2]);
}

// A list whose first elements need no memory of their own.
class FacetList {
 public:
  void add(FacetId f) {
    if (count_ < few_.size()) {
      few_[count_++] = f;
      return;
    }
    if (many_.empty()) many_.assign(few_.begin(), few_.end());
    many_.push_back(f);
  }
  std::span<const FacetId> all() const {
    return many_.empty() ? std::span(few_).first(count_) : std::span(many_);
  }

 private:
  std::array<FacetId, 32> few_;
  std::size_t count_ = 0;
  std::vector<FacetId> many_;  // all, if they are more
};

// The facets of the surface at v, each seen from its cell with out = 0; asked about until
// visit(f) is false. Whether it never was.
template <class Visit>
bool list_surface_facets(const Triangulation& triangulation, std::span<const CellId> star,
                         const IdVector<CellId, std::uint8_t>& out, VertexId v, FacetList& facets,
                         Visit visit) {
  for (const CellId c : star) {
    if (out[c] != 0) continue;
    const int opposite = index_of_vertex(triangulation.cell(c), v);
    for (int i = 0; i < 4; ++i) {
      if (i == opposite || out[triangulation.neighbor(c, i)] == 0) continue;
      if (!visit(facet_id(c, i))) return false;
      facets.add(facet_id(c, i));
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
  // The plane is that of the largest facet. Most samples are not flat, told by their first facets.
  Vec3 plane;
  double largest = 0;
  FacetList list;
  const auto may_be_flat = [&](FacetId f) {
    const Vec3 normal = normal_of(triangulation, f);
    const double area = squared_norm(normal);
    if (largest > 0 && is_bent(normal, plane, options.flat_cosine)) return false;
    if (area < largest || (area == largest && !(plane < normal))) return true;
    largest = area;
    plane = normal;
    return true;
  };
  if (!list_surface_facets(triangulation, star, out, v, list, may_be_flat)) return false;
  if (largest == 0) return false;  // not on the surface
  const std::span<const FacetId> facets = list.all();
  TwoNearest nearest;
  const Point& p = triangulation.point(v);
  for (const FacetId f : facets) {
    for (const VertexId w : triangulation.facet_vertices(f)) {
      if (w != v) nearest.add(w, squared_norm(triangulation.point(w) - p));
    }
  }
  // Most flat ones have a facet that is well shaped.
  const double too_wide = options.ratio * options.ratio * nearest.second();
  for (const FacetId f : facets) {
    if (size_of_facet(triangulation, f).squared_circumradius < too_wide) return false;
  }
  plane = unit(plane);
  return std::all_of(facets.begin(), facets.end(), [&](FacetId f) {
    const double cosine = dot(unit(normal_of(triangulation, f)), plane);
    return std::abs(cosine) >= options.flat_cosine;
  });
}

}  // namespace cocoon
