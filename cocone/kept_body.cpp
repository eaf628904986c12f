#include "cocone/kept_body.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "cocone/surface_walk.h"
#include "geom/visit_where.h"
#include "geom/zeroed_array.h"

namespace cocoon {
namespace {

constexpr std::uint8_t is_new = 2;

// With many of them a body is not worth keeping.
constexpr std::size_t most_not_good = 4096;

// A touched vertex, and a facet of the boundary there, seen from the body.
struct Touched {
  VertexId vertex;
  FacetId facet;
};

class BoundaryChange {
 public:
  BoundaryChange(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out)
      : triangulation_(triangulation), out_(out), is_touched_(triangulation.num_vertices()) {}

  void touch_at(CellId c) {
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      const FacetId behind = triangulation_.mirror(f);
      if (out_[c] == out_[cell_of(behind)]) continue;
      const FacetId inner = out_[c] == 0 ? f : behind;
      for (const VertexId v : triangulation_.facet_vertices(f)) {
        if (is_touched_[v] != 0) continue;
        is_touched_[v] = 1;
        touched_.push_back({v, inner});
      }
    }
  }

  KeptBody::Change result() const {
    KeptBody::Change change;
    constexpr std::size_t ahead = 8;  // vertices lie apart: their cells are asked for early
    for (std::size_t k = 0; k < touched_.size(); ++k) {
      if (k + ahead < touched_.size()) {
        __builtin_prefetch(&triangulation_.cell(cell_of(touched_[k + ahead].facet)));
      }
      change.touched.push_back(touched_[k].vertex);
      list_triangles(touched_[k], change.triangles);
    }
    return change;
  }

 private:
  // Around the vertex; each with the first of its touched corners.
  void list_triangles(const Touched& at, std::vector<std::array<VertexId, 3>>& triangles) const {
    const VertexId v = at.vertex;
    walk_around(triangulation_, out_, v, at.facet, [&](FacetId f, VertexId) {
      const std::array<VertexId, 3> corners = triangulation_.facet_vertices(f);
      const bool is_first = std::none_of(corners.begin(), corners.end(),
                                         [&](VertexId w) { return w < v && is_touched_[w] != 0; });
      if (is_first) triangles.push_back(corners);
      return true;
    });
  }

  const Triangulation& triangulation_;
  const IdVector<CellId, std::uint8_t>& out_;
  ZeroedArray<VertexId, std::uint8_t> is_touched_;
  std::vector<Touched> touched_;
};

// Whether each of the vertices, which have these stars, has a facet of the boundary with a good
// one.
bool are_beside_good(const Triangulation& triangulation, const CellMarks& marks,
                     std::span<const CellId> stars, std::span<const VertexId> vertices) {
  ZeroedArray<VertexId, std::uint8_t> is_beside(triangulation.num_vertices());
  for (const CellId c : stars) {
    for (int i = 0; i < 4; ++i) {
      if (marks.reached[c] == marks.reached[triangulation.neighbor(c, i)]) continue;
      const auto [a, b, d] = triangulation.facet_vertices(facet_id(c, i));
      if ((marks.good[a] | marks.good[b] | marks.good[d]) == 0) continue;
      is_beside[a] = is_beside[b] = is_beside[d] = 1;
    }
  }
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](VertexId v) { return is_beside[v] != 0; });
}

}  // namespace

void KeptBody::keep(const Triangulation& triangulation, const IdVector<VertexId, CellId>& cell_at,
                    const CellMarks& marks) {
  clear();
  std::vector<VertexId> not_good;
  for (const VertexId v : triangulation.vertices()) {
    if (marks.good[v] == 0) not_good.push_back(v);
  }
  if (not_good.size() > most_not_good) return;
  const std::span<const CellId> stars = stars_.stars(triangulation, cell_at, not_good);
  if (are_beside_good(triangulation, marks, stars, not_good)) out_ = marks.reached;
}

void KeptBody::update(const DynamicDelaunay& delaunay, const DelaunayChange& change) {
  out_.resize(delaunay.view().cell_records().size(), is_new);
  for (const CellId c : change.created) out_[c] = is_new;
}

void KeptBody::renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay) {
  for (const auto& [a, b] : renumbering.cells) std::swap(out_[a], out_[b]);
  out_.resize(delaunay.view().cell_records().size());
}

KeptBody::Change KeptBody::change_to(const Triangulation& triangulation,
                                     const IdVector<CellId, std::uint8_t>& out) const {
  BoundaryChange change(triangulation, out);
  visit_where(
      out.size(), [&](std::size_t c) { return out_[CellId(c)] != out[CellId(c)]; },
      [&](std::size_t c) { change.touch_at(CellId(c)); });
  return change.result();
}

}  // namespace cocoon
