#include "cocone/known_sides.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "cocone/half_star.h"
#include "geom/sort_by_vertex.h"
#include "geom/triangle_mesh.h"

namespace cocoon {
namespace {

// An old triangle at one of its corners.
struct Spoke {
  VertexId from;  // the other two corners, counterclockwise
  VertexId to;
  FacetId facet;  // seen from behind; none if it is no facet
};

// The old triangles at each vertex.
class Fans {
 public:
  Fans(const Triangulation& triangulation, std::span<const KnownTriangle> triangles) {
    begins_ = sort_by_vertex(
        triangles.size(), triangulation.num_vertices(), {},
        [&](std::size_t count) { spokes_.resize(count); },
        [&](std::size_t begin, std::size_t end, const auto& put) {
          for (std::size_t t = begin; t < end; ++t) {
            Triangle corners;
            std::transform(triangles[t].begin(), triangles[t].end(), corners.begin(),
                           [&](PointId p) { return triangulation.vertex_of_point()[p]; });
            for (std::size_t k = 0; k < 3; ++k) {
              put(corners[k], [&](std::uint32_t place) {
                spokes_[place] = {corners[(k + 1) % 3], corners[(k + 2) % 3], {}};
              });
            }
          }
        });
  }

  std::span<Spoke> at(VertexId v) {
    const std::uint32_t begin = begins_[v.index()];
    return std::span(spokes_).subspan(begin, begins_[v.index() + 1] - begin);
  }
  bool is_corner(VertexId v) const {
    return v != infinite_vertex && begins_[v.index()] != begins_[v.index() + 1];
  }
  // That of a triangle at v, or null.
  Spoke* find(VertexId v, VertexId from, VertexId to) {
    for (Spoke& spoke : at(v)) {
      if (spoke.from == from && spoke.to == to) return &spoke;
    }
    return nullptr;
  }

 private:
  std::vector<std::uint32_t> begins_;
  std::vector<Spoke> spokes_;
};

class Telling {
 public:
  Telling(const Triangulation& triangulation, std::span<const KnownTriangle> triangles)
      : triangulation_(triangulation),
        fans_(triangulation, triangles),
        facets_(triangulation.num_cells()),
        told_(triangulation.num_cells(), 0) {}

  KnownSides run() {
    find_facets();
    HalfStar half(triangulation_, facets_);
    for (const VertexId v : triangulation_.vertices()) {
      if (!is_intact(v)) continue;
      tell_around(v, in, half);
      tell_around(v, out, half);
    }
    return labels();
  }

 private:
  enum Side : std::uint8_t { out = 1, in = 2 };

  // The old triangles that are facets.
  void find_facets() {
    for (const CellId c : triangulation_.finite_cells()) {
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        const auto [x, y, z] = triangulation_.facet_vertices(f);
        if (!fans_.is_corner(x)) continue;
        Spoke* at_x = fans_.find(x, y, z);
        if (at_x == nullptr) continue;
        at_x->facet = fans_.find(y, z, x)->facet = fans_.find(z, x, y)->facet = f;
        facets_.insert(triangulation_, f);
      }
    }
  }

  bool is_intact(VertexId v) {
    if (!fans_.is_corner(v)) return false;
    const std::span<const Spoke> fan = fans_.at(v);
    const auto count = [&](VertexId Spoke::*end, VertexId w) {
      return std::count_if(fan.begin(), fan.end(), [&](const Spoke& s) { return s.*end == w; });
    };
    return std::all_of(fan.begin(), fan.end(), [&](const Spoke& s) {
      return !s.facet.is_none() && count(&Spoke::from, s.to) == count(&Spoke::to, s.to);
    });
  }

  // The cells at an intact vertex that lie on that side of a triangle there.
  void tell_around(VertexId v, Side side, HalfStar& half) {
    bool any = false;
    for (const Spoke& spoke : fans_.at(v)) {
      const CellId c = cell_of(side == in ? spoke.facet : triangulation_.mirror(spoke.facet));
      if (any && half.contains(c)) continue;  // one of those told last
      any = true;
      for (const CellId d : half.flood(v, c)) {
        told_[d] = static_cast<std::uint8_t>(told_[d] | side);
      }
    }
  }

  KnownSides labels() const {
    KnownSides known;
    known.labels = IdVector<CellId, CellLabel>(triangulation_.num_cells(), CellLabel::unmarked);
    for (const CellId c : triangulation_.finite_cells()) {
      if (told_[c] == (out | in)) ++known.contradictions;
      if (told_[c] != out && told_[c] != in) continue;
      const auto& vertices = triangulation_.cell(c).vertices;
      if (!std::all_of(vertices.begin(), vertices.end(),
                       [&](VertexId v) { return fans_.is_corner(v); })) {
        continue;
      }
      known.labels[c] = told_[c] == out ? CellLabel::out : CellLabel::in;
      ++known.cells;
    }
    return known;
  }

  const Triangulation& triangulation_;
  Fans fans_;
  FacetSet facets_;
  IdVector<CellId, std::uint8_t> told_;
};

}  // namespace

KnownSides known_sides(const Triangulation& triangulation,
                       std::span<const KnownTriangle> triangles) {
  if (triangles.empty()) return {};
  return Telling(triangulation, triangles).run();
}

}  // namespace cocoon
