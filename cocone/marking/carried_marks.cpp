#include "cocone/marking/carried_marks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <span>
#include <utility>

#include "cocone/facets/half_star.h"
#include "cocone/marking/pass_labels.h"
#include "geom/arrays/sort_ids.h"
#include "geom/mesh/edge_components.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {
namespace {

constexpr std::size_t elements_per_chunk = std::size_t{1} << 15;
constexpr std::size_t ahead = 16;  // cells lie here and there in memory: fetch those that come soon

class Carrying {
 public:
  Carrying(const Triangulation& triangulation, const LinkedFacets& surface,
           const IdVector<VertexId, Halfedge>& corner_at, CellMarks& marks,
           const Execution& execution)
      : triangulation_(triangulation),
        surface_(surface),
        corner_at_(corner_at),
        marks_(marks),
        execution_(execution) {}

  CarriedMarks run(const IdVector<CellId, CellLabel>& known) {
    find_sheets();
    see_from_hull();
    see_from_known_cells(known);
    visit_sheets();
    sheets_ = {};  // memory is short here
    marks_.labels = IdVector<CellId, CellLabel>(triangulation_.num_cells(), CellLabel::unmarked);
    for (const CellId c : triangulation_.infinite_cells()) marks_.labels[c] = CellLabel::out;
    label_sides();
    label_others();
    return std::move(result_);
  }

 private:
  // The parts of the surface that hang together around good vertices: all triangles at one are in
  // the same, since every edge there has two.
  void find_sheets() {
    sheets_ = edge_components(
        surface_.links, execution_,
        [&](Halfedge halfedge) {
          const auto [a, b] = surface_.ends(halfedge);
          return (marks_.good[a] | marks_.good[b]) != 0;
        },
        [&](Halfedge halfedge, Halfedge across) {
          return surface_.ends(halfedge)[0] == surface_.ends(across)[0];
        });
  }

  // Of each such part that the hull sees at a good vertex, on which side of its first triangle OUT
  // is.
  void see_from_hull() {
    outside_.assign(sheets_.components.size(), CarriedMarks::unknown);
    HalfStar half(triangulation_, surface_.set);
    for (const CellId c : triangulation_.infinite_cells()) {
      for (int i = 0; i < 3; ++i) see(half, triangulation_.vertex(c, i), c, CellLabel::out);
    }
  }

  void see_from_known_cells(const IdVector<CellId, CellLabel>& known) {
    if (known.empty()) return;
    HalfStar half(triangulation_, surface_.set);
    for (const CellId c : triangulation_.finite_cells()) {
      if (known[c] == CellLabel::unmarked) continue;
      for (const VertexId v : triangulation_.cell(c).vertices) see(half, v, c, known[c]);
    }
  }

  // What the label of a cell at v says of the part of the surface there, if nothing is known of it.
  void see(HalfStar& half, VertexId v, CellId c, CellLabel label) {
    if (marks_.good[v] == 0 || outside_[sheet_at(v)] != CarriedMarks::unknown) return;
    const FacetId seen = first_surface_facet(half.flood(v, c), v);
    const std::uint32_t t = triangle_of_facet(seen, v);
    const bool out_here = (seen == surface_.facets[t]) == (label == CellLabel::out);
    const auto side = static_cast<std::uint8_t>(out_here ? 0 : 1);
    outside_[sheet_at(v)] = side ^ sheets_.turned[t];
  }

  std::uint32_t sheet_at(VertexId good) const {
    return sheets_.component_of[triangle_of_halfedge(corner_at_[good])];
  }

  // Carries it to all triangles and good vertices of those parts.
  void visit_sheets() {
    out_side_.resize(surface_.size());
    parallel_chunks(execution_, surface_.size(), elements_per_chunk,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t t = begin; t < end; ++t) {
                        const std::uint8_t side = outside_[sheets_.component_of[t]];
                        out_side_[t] = side == CarriedMarks::unknown
                                           ? side
                                           : static_cast<std::uint8_t>(side ^ sheets_.turned[t]);
                      }
                    });
    marks_.visited = VertexSet(triangulation_.num_vertices(), 0);
    marks_.visited_vertices = parallel_reduce(
        execution_, triangulation_.num_vertices(), std::size_t{0},
        [&](std::size_t begin, std::size_t end) {
          std::size_t visited = 0;
          for (VertexId v(begin); v.index() < end; ++v) {
            if (marks_.good[v] == 0) continue;
            marks_.visited[v] = outside_[sheet_at(v)] != CarriedMarks::unknown ? 1 : 0;
            visited += marks_.visited[v];
          }
          return visited;
        },
        std::plus<>());
  }

  // Of half the star of a good vertex, a facet of the surface at it, seen from that side.
  FacetId first_surface_facet(std::span<const CellId> half, VertexId v) const {
    for (const CellId c : half) {
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        if (triangulation_.vertex(c, i) != v && surface_.set.contains(f)) return f;
      }
    }
    return {};  // never: the disk at v is the boundary of this half
  }

  // The position of a facet of the surface at the good vertex v.
  std::uint32_t triangle_of_facet(FacetId f, VertexId v) const {
    std::uint32_t found = 0;
    for_each_triangle_around(surface_, corner_at_[v], [&](std::uint32_t t) {
      if (surface_.facets[t] == f || surface_.mirrors[t] == f) found = t;
    });
    return found;
  }

  // Every triangle whose sides are known has a visited corner: it was reached from one.
  void label_sides() {
    for (std::uint32_t t = 0; t < surface_.size(); ++t) {
      if (t + ahead < surface_.size()) {
        __builtin_prefetch(&marks_.labels[cell_of(surface_.facets[t + ahead])]);
        __builtin_prefetch(&marks_.labels[cell_of(surface_.mirrors[t + ahead])]);
      }
      if (out_side_[t] == CarriedMarks::unknown) continue;
      const bool out_here = out_side_[t] == 0;
      const bool agrees_here = label(surface_.facets[t], out_here ? CellLabel::out : CellLabel::in);
      const bool agrees_behind =
          label(surface_.mirrors[t], out_here ? CellLabel::in : CellLabel::out);
      if (!agrees_here || !agrees_behind) dispute(surface_.facets[t]);
    }
  }

  // False if the cell of the facet has another label.
  bool label(FacetId f, CellLabel wanted) {
    CellLabel& known = marks_.labels[cell_of(f)];
    known = known == CellLabel::unmarked ? wanted : known;
    return known == wanted;
  }

  void dispute(FacetId f) {
    for (const VertexId v : triangulation_.facet_vertices(f)) {
      if (v != infinite_vertex && marks_.visited[v] != 0) result_.disputed.push_back(v);
    }
  }

  // Labels pass through facets at visited vertices; in the order of memory, as often as it takes:
  // in half a star there is one beside each triangle, and its cells hang together. Each cell is
  // compared with those around it when it has its label, so that of any two the second sees the
  // first.
  void label_others() {
    std::vector<CellId> left;
    for (const CellId c : triangulation_.cells()) {
      if (!take_label(c) && passing_facets(c) != 0) left.push_back(c);
    }
    pass_labels(left, [&](CellId c) { return take_label(c); });
    assert(left.empty());
  }

  // Bit i: facet i has a vertex that has had its turn. A branch only on whether all have.
  unsigned passing_facets(CellId c) const {
    if (marks_.visited_vertices == triangulation_.num_vertices()) return 15;
    const Cell& cell = triangulation_.cell(c);
    unsigned bits = 0;
    for (unsigned i = 0; i < (triangulation_.is_infinite(c) ? 3U : 4U); ++i) {
      bits |= static_cast<unsigned>(marks_.visited[cell.vertices[i]]) << i;
    }
    const bool is_one = (bits & (bits - 1)) == 0;
    return bits == 0 ? 0U : is_one ? 15U & ~bits : 15U;
  }

  // Gives the cell a label, if it has none, and looks whether it agrees with those around it, by
  // the bits of labels: a branch for each facet would be guessed wrong half of the time. Where the
  // cells around contradict each other it takes any of their labels. False if there is none yet.
  bool take_label(CellId c) {
    constexpr auto out = static_cast<unsigned>(CellLabel::out);
    static_assert(out == 1 && static_cast<unsigned>(CellLabel::in) == 2);
    const Cell& cell = triangulation_.cell(c);
    std::uint32_t labels = 0;  // of the cells around, one in each byte
    for (unsigned i = 0; i < 4; ++i) {
      labels |= static_cast<std::uint32_t>(marks_.labels[cell_of(cell.neighbors[i])]) << (8 * i);
    }
    const unsigned passing = passing_facets(c);
    const std::uint32_t told = labels & byte_of_bit[passing];
    const std::uint32_t closed = byte_of_bit[surface_.set.bits(c)];
    const unsigned same = any_byte(told & ~closed);     // told by cells that have the same label
    const unsigned opposite = any_byte(told & closed);  // by cells beyond the surface
    const auto known = static_cast<unsigned>(marks_.labels[c]);
    const unsigned label = known != 0 ? known : (same & out) != 0 ? out : same;
    const unsigned all = same | opposite >> 1 | (opposite << 1 & 2U);  // these bits change places
    marks_.labels[c] = static_cast<CellLabel>(label);
    if (label != 0 && (all & ~label) != 0) dispute_around(c, passing);
    return label != 0;
  }

  // Byte i: whether bit i is set, in both bits of a label.
  static constexpr std::array<std::uint32_t, 16> byte_of_bit = [] {
    std::array<std::uint32_t, 16> masks{};
    for (std::uint32_t bits = 0; bits < 16; ++bits) {
      for (unsigned i = 0; i < 4; ++i) masks[bits] |= 3 * ((bits >> i) & 1U) << (8 * i);
    }
    return masks;
  }();
  // The bits of a label that are set in any of four bytes.
  static unsigned any_byte(std::uint32_t bytes) {
    bytes |= bytes >> 16;
    return (bytes | bytes >> 8) & 3U;
  }

  // At the facets of the cell where labels do not fit the surface.
  void dispute_around(CellId c, unsigned passing) {
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const CellLabel behind = marks_.labels[triangulation_.neighbor(c, i)];
      if (((passing >> i) & 1U) == 0 || behind == CellLabel::unmarked) continue;
      if ((behind != marks_.labels[c]) != surface_.set.contains(f)) dispute(f);
    }
  }

  const Triangulation& triangulation_;
  const LinkedFacets& surface_;
  const IdVector<VertexId, Halfedge>& corner_at_;
  CellMarks& marks_;
  const Execution& execution_;
  EdgeComponents sheets_;
  std::vector<std::uint8_t> outside_;  // per sheet: as out_side_ of its first triangle
  CarriedMarks result_;
  std::vector<std::uint8_t>& out_side_ = result_.out_side;
};

}  // namespace

CarriedMarks carry_marks(const Triangulation& triangulation, const LinkedFacets& surface,
                         const IdVector<VertexId, Halfedge>& corner_at,
                         const IdVector<CellId, CellLabel>& known, CellMarks& marks,
                         const Execution& execution) {
  CarriedMarks carried = Carrying(triangulation, surface, corner_at, marks, execution).run(known);
  make_set(carried.disputed);
  return carried;
}

}  // namespace cocoon
