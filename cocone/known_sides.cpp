#include "cocone/known_sides.h"

#include <algorithm>
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

// Tells at once of most facets that they are no old triangles: an edge of them is no old edge.
class EdgeFilter {
 public:
  EdgeFilter(const Fans& fans, std::size_t num_vertices, const Execution& execution)
      : ends_(num_vertices, 0) {
    parallel_chunks(execution, num_vertices, coarse_grain(num_vertices),
                    [&](std::size_t begin, std::size_t end) {
                      for (VertexId v(begin); v.index() < end; ++v) {
                        for (const Spoke& s : fans.at(v)) ends_[v] |= flag(s.from) | flag(s.to);
                      }
                    });
  }

  // Bit i: facet i of the finite cell may be an old triangle.
  unsigned facets(const Cell& cell) const {
    const auto& [a, b, c, d] = cell.vertices;
    const unsigned ab = may_be_edge(a, b);
    const unsigned ac = may_be_edge(a, c);
    const unsigned ad = may_be_edge(a, d);
    const unsigned bc = may_be_edge(b, c);
    const unsigned bd = may_be_edge(b, d);
    const unsigned cd = may_be_edge(c, d);
    return (bc & cd & bd) | (ac & cd & ad) << 1 | (ab & bd & ad) << 2 | (ab & bc & ac) << 3;
  }

 private:
  static unsigned place(VertexId v) { return (v.value * 0x9E3779B1U) >> 26; }
  static std::uint64_t flag(VertexId v) { return std::uint64_t{1} << place(v); }
  unsigned may_be_edge(VertexId a, VertexId b) const {
    return static_cast<unsigned>(ends_[a] >> place(b)) & 1U;
  }

  IdVector<VertexId, std::uint64_t> ends_;  // flags of all ends of old edges at each vertex
};

class Telling {
 public:
  Telling(const Triangulation& triangulation, std::span<const KnownTriangle> triangles,
          const Execution& execution)
      : triangulation_(triangulation),
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
  enum AtVertex : std::uint8_t { corner = 1, intact = 2 };
  enum Told : std::uint8_t { out = 1, in = 2, both = 3, passed_on = 4 };

  struct Found {
    FacetId facet;  // seen from behind the triangle
    std::uint32_t triangle;
  };

  // The old triangles that are facets.
  void find_facets() {
    const EdgeFilter edges(fans_, triangulation_.num_vertices(), execution_);
    const std::size_t cells = triangulation_.num_finite_cells();
    const auto found =
        parallel_list<Found>(execution_, cells, coarse_grain(cells),
                             [&](std::size_t begin, std::size_t end, std::vector<Found>& facets) {
                               for (CellId c(begin); c.index() < end; ++c) {
                                 for (unsigned left = edges.facets(triangulation_.cell(c));
                                      left != 0; left &= left - 1) {
                                   list_triangles(facet_id(c, std::countr_zero(left)), facets);
                                 }
                               }
                             });
    for (const auto& [f, t] : found) {
      facet_of_[t] = f;
      facets_.insert(triangulation_, f);
    }
  }

  // Those with the corners of f, if that is its smaller id. None has an infinite cell behind it.
  void list_triangles(FacetId f, std::vector<Found>& found) const {
    const FacetId mirror = triangulation_.mirror(f);
    if (mirror < f) return;
    const auto [x, y, z] = triangulation_.facet_vertices(f);
    fans_.visit_triangles(x, y, z, [&](std::uint32_t t, bool is_seen_from_behind) {
      const FacetId behind = is_seen_from_behind ? f : mirror;
      if (!triangulation_.is_infinite(cell_of(behind))) found.push_back({behind, t});
    });
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
    const auto count = [&](VertexId Spoke::*end, VertexId w) {
      return std::count_if(fan.begin(), fan.end(), [&](const Spoke& s) { return s.*end == w; });
    };
    return !fan.empty() && std::all_of(fan.begin(), fan.end(), [&](const Spoke& s) {
      return !facet_of_[s.triangle].is_none() &&
             count(&Spoke::from, s.to) == count(&Spoke::to, s.to);
    });
  }

  // Bit i: vertex i of the cell is intact.
  unsigned intact_vertices(const Cell& cell) const {
    unsigned found = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const VertexId v = cell.vertices[i];
      if (v != infinite_vertex && (at_[v] & intact) != 0) found |= 1U << i;
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
    return std::none_of(told_.begin(), told_.end(), [](std::uint8_t t) { return t == both; }) &&
           pass_on();
  }

  bool has_intact_vertex(FacetId f) const {
    const auto [x, y, z] = triangulation_.facet_vertices(f);
    return ((at_[x] | at_[y] | at_[z]) & intact) != 0;
  }

  // In the order of memory, as far as it goes.
  bool pass_on() {
    std::vector<CellId> open;
    for (const CellId c : triangulation_.cells()) {
      if (told_[c] == 0) continue;
      open.push_back(c);
      while (!open.empty()) {
        const CellId next = open.back();
        open.pop_back();
        if (!pass_on_from(next, c, open)) return false;
      }
    }
    return true;
  }

  // Cells after `at` have their turn later. False if a neighbor was told otherwise.
  bool pass_on_from(CellId c, CellId at, std::vector<CellId>& open) {
    if ((told_[c] & passed_on) != 0) return true;
    const unsigned side = told_[c];
    told_[c] = static_cast<std::uint8_t>(side | passed_on);
    const Cell& cell = triangulation_.cell(c);
    const unsigned intact_ones = intact_vertices(cell);
    for (unsigned i = 0; i < 4; ++i) {
      const bool is_old = ((unsigned{facets_.bits(c)} >> i) & 1U) != 0;
      if (is_old || (intact_ones & ~(1U << i)) == 0) continue;
      const CellId behind = cell_of(cell.neighbors[i]);
      std::uint8_t& told = told_[behind];
      if (told == 0) {
        told = static_cast<std::uint8_t>(side);
        if (behind < at) open.push_back(behind);
      } else if ((told & both) != side) {
        return false;
      }
    }
    return true;
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
      const unsigned told = told_[c] & both;
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
  const Execution& execution_;
  Fans fans_;
  std::vector<FacetId> facet_of_;  // each old triangle seen from behind; none if it is no facet
  FacetSet facets_;
  IdVector<VertexId, std::uint8_t> at_;  // flags
  IdVector<CellId, std::uint8_t> told_;
};

}  // namespace

KnownSides known_sides(const Triangulation& triangulation, std::span<const KnownTriangle> triangles,
                       const Execution& execution) {
  if (triangles.empty()) return {};
  return Telling(triangulation, triangles, execution).run();
}

}  // namespace cocoon
