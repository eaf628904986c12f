// Points on an ellipsoid that come and go, and the body that they bound, with dents: for tests of
// what is kept of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/random/random.h"
#include "geom/search/point_hash.h"
#include "tests/cocone/kept/lend.h"

namespace cocoon {

// Seen from outside, beginning with the smallest corner.
using CornerPoints = std::array<Point, 3>;

class LiveBody {
 public:
  explicit LiveBody(const std::vector<Point>& points)
      : delaunay_(cocoon::delaunay(points).triangulation) {
    delaunay_.close_gaps();
  }

  // follow(change) and follow(renumbering) are called when that has been done.
  template <class Follow>
  void change(const std::vector<VertexId>& removed, const std::vector<Point>& inserted,
              Follow follow) {
    follow(delaunay_.replace(removed, inserted));
    follow(delaunay_.close_gaps());
  }

  // Of the points of shapes::ellipsoid within `reach` of one of them half go, and as many come.
  template <class Follow>
  void change_nearby(double reach, Random& random, Follow follow) {
    const Point center = delaunay_.point(VertexId(random.below(delaunay_.num_vertices())));
    std::vector<VertexId> removed;
    std::vector<Point> inserted;
    for (const VertexId v : id_range<VertexId>(delaunay_.num_vertices())) {
      const Point& p = delaunay_.point(v);
      if (distance(p, center) > reach || random.below(2) == 0) continue;
      removed.push_back(v);
      const Vec3 u = unit(Vec3{p.x, p.y / 0.75, p.z / 0.5} + 0.2 * reach * random.on_unit_sphere());
      inserted.push_back({u.x, 0.75 * u.y, 0.5 * u.z});
    }
    change(removed, inserted, follow);
  }

  template <class Visit>
  void lend(Visit visit) {
    cocoon::lend(delaunay_, visit);
  }

  const DynamicDelaunay& delaunay() const { return delaunay_; }

  // 1: not of the body. That has all finite cells but some at the hull, the same ones whatever has
  // happened elsewhere: one of `dents` of those with two facets there, whose edge turns over, and
  // one of `holes` of those with one, which leaves no smooth boundary. 0: none.
  static IdVector<CellId, std::uint8_t> out(const Triangulation& triangulation, std::uint64_t dents,
                                            std::uint64_t holes) {
    IdVector<CellId, std::uint8_t> out(triangulation.num_cells(), 0);
    for (const CellId c : triangulation.cells()) {
      if (triangulation.is_infinite(c)) {
        out[c] = 1;
        continue;
      }
      int at_hull = 0;
      for (int i = 0; i < 4; ++i) {
        at_hull += triangulation.is_infinite(triangulation.neighbor(c, i)) ? 1 : 0;
      }
      std::uint64_t hash = 0;
      for (const VertexId v : triangulation.cell(c).vertices) {
        hash ^= point_hash(triangulation.point(v));
      }
      const std::uint64_t one_of = at_hull == 2 ? dents : at_hull == 1 ? holes : 0;
      out[c] = one_of != 0 && hash % one_of == 0 ? 1 : 0;
    }
    return out;
  }

  static CornerPoints corner_points(const Triangulation& triangulation, const Triangle& corners) {
    CornerPoints points;
    for (std::size_t k = 0; k < 3; ++k) points[k] = triangulation.point(corners[k]);
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    return points;
  }

  // visit(f) for the facets of the boundary, each seen from its cell of the body.
  template <class Visit>
  static void for_boundary(const Triangulation& triangulation,
                           const IdVector<CellId, std::uint8_t>& out, Visit visit) {
    for (const CellId c : triangulation.finite_cells()) {
      for (int i = 0; i < 4 && out[c] == 0; ++i) {
        if (out[triangulation.neighbor(c, i)] != 0) visit(facet_id(c, i));
      }
    }
  }

 private:
  DynamicDelaunay delaunay_;
};

}  // namespace cocoon
