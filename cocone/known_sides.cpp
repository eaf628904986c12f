#include "cocone/known_sides.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cocone/half_star.h"
#include "geom/parallel_list.h"
#include "geom/parallel_reduce.h"
#include "geom/sort_by_vertex.h"
#include "geom/triangle_mesh.h"

namespace cocoon {
namespace {

// An old triangle at one of its corners.
struct Spoke {
  VertexId from;  // the other two corners, counterclockwise
  VertexId to;
  std::uint32_t triangle;
};

// The old triangles at each vertex.
class Fans {
 public:
  Fans(const Triangulation& triangulation, std::span<const KnownTriangle> triangles,
       const Execution& execution) {
    begins_ = sort_by_vertex(
        triangles.size(), triangulation.num_vertices(), execution,
        [&](std::size_t count) { spokes_.resize(count); },
        [&](std::size_t begin, std::size_t end, const auto& put) {
          for (std::size_t t = begin; t < end; ++t) {
            Triangle corners;
            std::transform(triangles[t].begin(), triangles[t].end(), corners.begin(),
                           [&](PointId p) { return triangulation.vertex_of_point()[p]; });
            for (std::size_t k = 0; k < 3; ++k) {
              put(corners[k], [&](std::uint32_t place) {
                spokes_[place] = {corners[(k + 1) % 3], corners[(k + 2) % 3],
                                  static_cast<std::uint32_t>(t)};
              });
            }
          }
        });
  }

  std::span<const Spoke> at(VertexId v) const {
    const std::uint32_t begin = begins_[v.index()];
    return std::span(spokes_).subspan(begin, begins_[v.index() + 1] - begin);
  }
  bool is_corner(VertexId v) const {
    return v != infinite_vertex && begins_[v.index()] != begins_[v.index() + 1];
  }
  // visit(triangle, is_counterclockwise) for the first triangle with these corners, in each order.
  template <class Visit>
  void visit_triangles(VertexId x, VertexId y, VertexId z, Visit visit) const {
    bool found[2] = {};
    for (const Spoke& spoke : at(x)) {
      const bool ahead = spoke.from == y && spoke.to == z;
      if (!ahead && (spoke.from != z || spoke.to != y)) continue;
      if (!std::exchange(found[ahead ? 1 : 0], true)) visit(spoke.triangle, ahead);
    }
  }

 private:
  std::vector<std::uint32_t> begins_;
  std::vector<Spoke> spokes_;
};

class Telling {
 public:
  Telling(const Triangulation& triangulation, std::span<const KnownTriangle> triangles,
          const FacetSet& likely, const Execution& execution)
      : triangulation_(triangulation),
        triangles_(triangles),
        likely_(likely),
        execution_(execution),
        fans_(triangulation, triangles, execution),
        facet_of_(triangles.size()),
        facets_(triangulation.num_cells()),
        at_(triangulation.num_vertices(), 0) {}

  KnownSides run() {
    find_facets();
    find_intact();
    if (!tell_at_once()) tell_by_vertices();
    return labels();
  }

 private:
  enum AtVertex : std::uint8_t { corner = 1, intact = 2, missing = 4 };
  enum Told : std::uint8_t { out = 1, in = 2, both = 3 };

  struct Found {
    FacetId facet;  // seen from behind the triangle
    std::uint32_t triangle;
  };

  // The old triangles that are facets: most of them are likely ones.
  void find_facets() {
    find_facets([&](std::size_t begin, std::size_t end, std::vector<Found>& found) {
      likely_.for_each(triangulation_, begin, end, [&](FacetId f) { list_triangles(f, found); });
    });
    if (list_corners_of_missing()) {
      find_facets([&](std::size_t begin, std::size_t end, std::vector<Found>& found) {
        for (CellId c(begin); c.index() < end; ++c) list_missing_triangles(c, found);
      });
    }
  }

  // find(begin, end, found): among the facets of these cells.
  template <class Find>
  void find_facets(const Find& find) {
    const std::size_t cells = triangulation_.num_finite_cells();
    for (const auto& [f, t] : parallel_list<Found>(execution_, cells, coarse_grain(cells), find)) {
      facet_of_[t] = f;
      facets_.insert(triangulation_, f);
    }
  }

  // Those with the corners of f. None has an infinite cell behind it.
  void list_triangles(FacetId f, std::vector<Found>& found) const {
    const auto [x, y, z] = triangulation_.facet_vertices(f);
    fans_.visit_triangles(x, y, z, [&](std::uint32_t t, bool is_seen_from_behind) {
      const FacetId behind = is_seen_from_behind ? f : triangulation_.mirror(f);
      if (!triangulation_.is_infinite(cell_of(behind))) found.push_back({behind, t});
    });
  }

  // Of those that have not been found. False if there are none.
  bool list_corners_of_missing() {
    bool any = false;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!facet_of_[t].is_none()) continue;
      for (const PointId p : triangles_[t]) at_[triangulation_.vertex_of_point()[p]] = missing;
      any = true;
    }
    return any;
  }

  void list_missing_triangles(CellId c, std::vector<Found>& found) const {
    const Cell& cell = triangulation_.cell(c);
    const unsigned corners = vertices_with(missing, cell);
    if (std::popcount(corners) < 3) return;
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const bool has_corners = (corners | 1U << i) == 15U;
      if (has_corners && f < triangulation_.mirror(f) && !likely_.contains(f)) {
        list_triangles(f, found);
      }
    }
  }

  void find_intact() {
    const std::size_t count = at_.size();
    parallel_chunks(execution_, count, coarse_grain(count),
                    [&](std::size_t begin, std::size_t end) {
                      for (VertexId v(begin); v.index() < end; ++v) {
                        at_[v] = static_cast<std::uint8_t>((fans_.is_corner(v) ? corner : 0) |
                                                           (is_intact(v) ? intact : 0));
                      }
                    });
  }

  bool is_intact(VertexId v) const {
    const std::span<const Spoke> fan = fans_.at(v);
    return !fan.empty() && std::all_of(fan.begin(), fan.end(), [&](const Spoke& s) {
      return !facet_of_[s.triangle].is_none();
    }) && (is_one_cycle(fan) || is_balanced(fan));
  }

  // Whether one triangle after the other leads through all of them, as around nearly all vertices.
  static bool is_one_cycle(std::span<const Spoke> fan) {
    VertexId at = fan.front().to;
    for (std::size_t count = 1; count < fan.size(); ++count) {
      const auto next =
          std::find_if(fan.begin(), fan.end(), [&](const Spoke& s) { return s.from == at; });
      if (next == fan.begin() || next == fan.end()) return false;
      at = next->to;
    }
    return at == fan.front().from;
  }

  static bool is_balanced(std::span<const Spoke> fan) {
    const auto count = [&](VertexId Spoke::*end, VertexId w) {
      return std::count_if(fan.begin(), fan.end(), [&](const Spoke& s) { return s.*end == w; });
    };
    return std::all_of(fan.begin(), fan.end(), [&](const Spoke& s) {
      return count(&Spoke::from, s.to) == count(&Spoke::to, s.to);
    });
  }

  // Bit i: vertex i of the cell has this flag.
  unsigned vertices_with(unsigned flag, const Cell& cell) const {
    unsigned found = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const VertexId v = cell.vertices[i];
      if (v != infinite_vertex && (at_[v] & flag) != 0) found |= 1U << i;
    }
    return found;
  }

  // If no cell is told both. Then two cells at an intact vertex, with a facet there between them
  // that is no old triangle, are told the same. So what is told goes from cell to cell, once
  // through each; and if it never meets what was told otherwise, each intact vertex has told just
  // that.
  bool tell_at_once() {
    told_ = IdVector<CellId, std::uint8_t>(triangulation_.num_cells(), 0);
    for (const FacetId f : facet_of_) {
      if (f.is_none() || !has_intact_vertex(f)) continue;
      const CellId behind = cell_of(f);
      const CellId before = cell_of(triangulation_.mirror(f));
      told_[behind] = static_cast<std::uint8_t>(told_[behind] | in);
      told_[before] = static_cast<std::uint8_t>(told_[before] | out);
    }
    pass_on();
    return std::none_of(told_.begin(), told_.end(), [](std::uint8_t t) { return t == both; });
  }

  bool has_intact_vertex(FacetId f) const {
    const auto [x, y, z] = triangulation_.facet_vertices(f);
    return ((at_[x] | at_[y] | at_[z]) & intact) != 0;
  }

  // Each cell that is told passes it on once: in the order of memory, and in the end those that
  // were told when their turn was over.
  void pass_on() {
    std::vector<CellId> late;
    for (const CellId c : triangulation_.cells()) {
      if (told_[c] != 0) pass_on_from(c, c, late);
    }
    const CellId end(triangulation_.num_cells());
    while (!late.empty()) {
      const CellId c = late.back();
      late.pop_back();
      pass_on_from(c, end, late);
    }
  }

  // Appends those before `turn` that had not been told anything. No branch depends on what a cell
  // was told.
  void pass_on_from(CellId c, CellId turn, std::vector<CellId>& late) {
    const Cell& cell = triangulation_.cell(c);
    const unsigned intact_ones = vertices_with(intact, cell);
    const unsigned side = told_[c];
    std::array<CellId, 4> news;
    std::size_t count = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const bool is_old = ((unsigned{facets_.bits(c)} >> i) & 1U) != 0;
      const bool is_passed = !is_old && (intact_ones & ~(1U << i)) != 0;
      const CellId behind = cell_of(cell.neighbors[i]);
      const unsigned before = told_[behind];
      told_[behind] = static_cast<std::uint8_t>(before | (is_passed ? side : 0U));
      news[count] = behind;
      count += is_passed && before == 0 && behind < turn ? 1U : 0U;
    }
    late.insert(late.end(), news.begin(), news.begin() + static_cast<std::ptrdiff_t>(count));
  }

  void tell_by_vertices() {
    told_ = IdVector<CellId, std::uint8_t>(triangulation_.num_cells(), 0);
    HalfStar half(triangulation_, facets_);
    for (const VertexId v : triangulation_.vertices()) {
      if ((at_[v] & intact) == 0) continue;
      tell_around(v, in, half);
      tell_around(v, out, half);
    }
  }

  // The cells at an intact vertex that lie on that side of a triangle there.
  void tell_around(VertexId v, Told side, HalfStar& half) {
    bool any = false;
    for (const Spoke& spoke : fans_.at(v)) {
      const FacetId f = facet_of_[spoke.triangle];
      const CellId c = cell_of(side == in ? f : triangulation_.mirror(f));
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
      const unsigned told = told_[c];
      if (told == both) ++known.contradictions;
      if (told != out && told != in) continue;
      const auto& [v0, v1, v2, v3] = triangulation_.cell(c).vertices;
      if ((at_[v0] & at_[v1] & at_[v2] & at_[v3] & corner) == 0) continue;
      known.labels[c] = told == out ? CellLabel::out : CellLabel::in;
      ++known.cells;
    }
    return known;
  }

  const Triangulation& triangulation_;
  std::span<const KnownTriangle> triangles_;
  const FacetSet& likely_;
  const Execution& execution_;
  Fans fans_;
  std::vector<FacetId> facet_of_;  // each old triangle seen from behind; none if it is no facet
  FacetSet facets_;
  IdVector<VertexId, std::uint8_t> at_;  // flags
  IdVector<CellId, std::uint8_t> told_;
};

}  // namespace

KnownSides known_sides(const Triangulation& triangulation, std::span<const KnownTriangle> triangles,
                       const FacetSet& likely, const Execution& execution) {
  if (triangles.empty()) return {};
  return Telling(triangulation, triangles, likely, execution).run();
}

}  // namespace cocoon
