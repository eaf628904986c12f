#include "cocone/kept/kept_body.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "cocone/facets/edge_cycle.h"
#include "cocone/facets/good_parts.h"
#include "cocone/facets/surface_fan.h"
#include "delaunay/vertices_of_cells.h"
#include "geom/arrays/disjoint_sets.h"
#include "geom/arrays/sort_by_vertex.h"
#include "geom/arrays/visit_where.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/parallel/parallel_reduce.h"

namespace cocoon {
namespace {

constexpr unsigned is_out = 16;
constexpr unsigned is_new = 32;

// What is kept of a cell.
std::uint8_t byte_of(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                     CellId c) {
  unsigned byte = out[c] != 0 ? is_out : 0;
  for (unsigned i = 0; i < 4; ++i) {
    const CellId behind = triangulation.neighbor(c, static_cast<int>(i));
    byte |= (out[behind] != out[c] ? 1U : 0U) << i;
  }
  return static_cast<std::uint8_t>(byte);
}

// visit(f) for the facets of the boundary of one of its cells.
template <class Visit>
void for_facets(CellId c, unsigned byte, const Visit& visit) {
  if ((byte & is_out) != 0) return;
  for (int i = 0; i < 4; ++i) {
    if (((byte >> i) & 1U) != 0) visit(facet_id(c, i));
  }
}

// The edge opposite to a vertex in a triangle.
struct OppositeEdge {
  VertexId from;
  VertexId to;
};

// Whether the vertices of triangles hang together by their edges: of those that
// for_triangles(visit) has visit(corners) called for.
template <class ForTriangles>
bool hang_together(std::size_t num_vertices, const ForTriangles& for_triangles) {
  DisjointSets sets(num_vertices);
  ZeroedArray<VertexId, std::uint8_t> met(num_vertices);
  std::size_t parts = 0;
  for_triangles([&](const Triangle& corners) {
    const auto is_first = [&](VertexId v) { return std::exchange(met[v], std::uint8_t{1}) == 0; };
    for (const VertexId v : corners) parts += is_first(v) ? 1U : 0U;
    parts -= join_good(sets, corners, [](VertexId) { return true; });
  });
  return parts <= 1;
}

}  // namespace

void KeptBody::resume(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                      const Execution& execution) {
  is_smooth_ = may_be_smooth_ = false;
  cells_.resize(out.size());
  renew_all(triangulation, out, execution);
}

IdVector<CellId, std::uint8_t> KeptBody::out() const {
  IdVector<CellId, std::uint8_t> out(cells_.size());
  for (const CellId c : cells_.ids()) out[c] = (cells_[c] & is_out) != 0 ? 1 : 0;
  return out;
}

std::optional<KeptBody::Change> KeptBody::take(const Triangulation& triangulation,
                                               const IdVector<VertexId, CellId>& cell_at,
                                               const IdVector<CellId, std::uint8_t>& out,
                                               bool may_be_smooth, const Execution& execution) {
  if (!exists()) cells_.resize(out.size(), is_new);
  const std::vector<CellId> changed = changed_cells(out);
  if (std::exchange(is_smooth_, false) && may_be_smooth) {
    return go_on(triangulation, cell_at, out, changed, execution);
  }
  renew(triangulation, out, changed, execution);
  may_be_smooth_ = may_be_smooth;
  return {};
}

void KeptBody::look_if_smooth(const Triangulation& triangulation, const Execution& execution) {
  if (!std::exchange(may_be_smooth_, false)) return;
  is_smooth_ = has_umbrellas(triangulation, execution) && is_connected(triangulation);
}

void KeptBody::update(const DynamicDelaunay& delaunay, const DelaunayChange& change) {
  cells_.resize(delaunay.view().cell_records().size(), is_new);
  for (const CellId c : change.created) cells_[c] = is_new;
  may_be_smooth_ = false;
}

void KeptBody::renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay) {
  for (const auto& [a, b] : renumbering.cells) std::swap(cells_[a], cells_[b]);
  cells_.resize(delaunay.view().cell_records().size());
}

BodyBefore KeptBody::before(const Triangulation& triangulation) const {
  constexpr auto label_of = [](unsigned byte) {
    const CellLabel side = (byte & is_out) != 0 ? CellLabel::out : CellLabel::in;
    return (byte & is_new) != 0 ? CellLabel::unmarked : side;
  };
  BodyBefore body;
  body.labels.resize(cells_.size());
  for (const CellId c : cells_.ids()) body.labels[c] = label_of(cells_[c]);
  for (const CellId c : triangulation.infinite_cells()) body.labels[c] = CellLabel::unmarked;
  visit_where(
      cells_.size(), [&](std::size_t c) { return (cells_[CellId(c)] & is_new) != 0; },
      [&](std::size_t c) { body.created.push_back(CellId(c)); });
  return body;
}

std::optional<KeptBody::Change> KeptBody::go_on(const Triangulation& triangulation,
                                                const IdVector<VertexId, CellId>& cell_at,
                                                const IdVector<CellId, std::uint8_t>& out,
                                                std::span<const CellId> changed,
                                                const Execution& execution) {
  const std::vector<VertexId> corners = vertices_of(triangulation, changed);
  ZeroedArray<VertexId, SurfaceFan> fans(triangulation.num_vertices());
  ZeroedArray<VertexId, std::uint8_t> is_touched(triangulation.num_vertices());
  std::vector<std::pair<FacetId, bool>> facets;  // at the corners, and whether it came
  for (const CellId c : stars_.stars(triangulation, cell_at, corners)) {
    for_facets(c, byte_of(triangulation, out, c), [&](FacetId f) {
      const bool came = !is_old(triangulation, out, f);
      facets.emplace_back(f, came);
      for (const VertexId v : triangulation.facet_vertices(f)) {
        fans[v].add(f);
        if (came) is_touched[v] = 1;
      }
    });
  }
  Change change;
  std::vector<VertexId> edge_ends;
  const bool has_umbrellas = std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
    if (is_touched[v] == 0) return fans[v].facets != 0;
    change.touched.push_back(v);
    return is_one_umbrella(triangulation, out, v, fans[v], edge_ends);
  });
  bool meets_old = change.touched.empty();
  for (const auto& [f, came] : facets) {
    const Triangle t = triangulation.facet_vertices(f);
    if ((is_touched[t[0]] | is_touched[t[1]] | is_touched[t[2]]) == 0) continue;
    change.triangles.push_back(t);
    meets_old = meets_old || !came;
  }
  renew(triangulation, out, changed, execution);
  const auto is_connected_here = [&] {
    return hang_together(triangulation.num_vertices(), [&](const auto& visit) {
      for (const auto& triangle : change.triangles) visit(triangle);
    });
  };
  is_smooth_ = has_umbrellas && ((meets_old && is_connected_here()) || is_connected(triangulation));
  if (!is_smooth_) return {};
  return change;
}

// New ones, and those that are on another side now.
std::vector<CellId> KeptBody::changed_cells(const IdVector<CellId, std::uint8_t>& out) const {
  std::vector<CellId> changed;
  visit_where(
      out.size(),
      [&](std::size_t c) {
        return (cells_[CellId(c)] & (is_out | is_new)) != (out[CellId(c)] != 0 ? is_out : 0U);
      },
      [&](std::size_t c) { changed.push_back(CellId(c)); });
  return changed;
}

// Whether a facet of the boundary was one before the change.
bool KeptBody::is_old(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                      FacetId f) const {
  const auto had = [&](FacetId half) {
    const unsigned byte = cells_[cell_of(half)];
    const unsigned side = out[cell_of(half)] != 0 ? is_out : 0U;
    return (byte & (is_out | is_new)) == side && ((byte >> index_of(half)) & 1U) != 0;
  };
  return had(f) || had(triangulation.mirror(f));
}

// What is kept becomes that of the body of the cells that are not `out`.
void KeptBody::renew(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                     std::span<const CellId> changed, const Execution& execution) {
  // Each once, instead of those around changed ones.
  if (changed.size() > cells_.size() / 8) return renew_all(triangulation, out, execution);
  for (const CellId c : changed) {
    cells_[c] = byte_of(triangulation, out, c);
    for (int i = 0; i < 4; ++i) {
      const CellId behind = triangulation.neighbor(c, i);
      cells_[behind] = byte_of(triangulation, out, behind);
    }
  }
}

void KeptBody::renew_all(const Triangulation& triangulation,
                         const IdVector<CellId, std::uint8_t>& out, const Execution& execution) {
  const std::size_t cells = cells_.size();
  parallel_chunks(execution, cells, coarse_grain(cells), [&](std::size_t begin, std::size_t end) {
    for (CellId c(begin); c.index() < end; ++c) cells_[c] = byte_of(triangulation, out, c);
  });
}

// Whether each vertex has one closed umbrella of the boundary.
bool KeptBody::has_umbrellas(const Triangulation& triangulation, const Execution& execution) const {
  const std::size_t vertices = triangulation.num_vertices();
  OverwriteVector<OppositeEdge> edges;
  const std::vector<std::uint32_t> begins = sort_by_vertex(
      triangulation.num_finite_cells(), vertices, execution,
      [&](std::size_t count) { edges.resize(count); },
      [&](std::size_t begin, std::size_t end, const auto& put) {
        for (CellId c(begin); c.index() < end; ++c) {
          for_facets(c, cells_[c], [&](FacetId f) {
            const Triangle corners = triangulation.facet_vertices(f);
            for (std::size_t i = 0; i < 3; ++i) {
              const OppositeEdge edge = {corners[(i + 1) % 3], corners[(i + 2) % 3]};
              put(corners[i], [&, edge](std::uint32_t place) { edges[place] = edge; });
            }
          });
        }
      });
  return vertices == first_failing(execution, vertices, [&](std::size_t v) {
           const std::span<const OppositeEdge> all(edges);
           return is_one_cycle(all.subspan(begins[v], begins[v + 1] - begins[v]));
         });
}

bool KeptBody::is_connected(const Triangulation& triangulation) const {
  return hang_together(triangulation.num_vertices(), [&](const auto& visit) {
    for (const CellId c : triangulation.finite_cells()) {
      for_facets(c, cells_[c], [&](FacetId f) { visit(triangulation.facet_vertices(f)); });
    }
  });
}

}  // namespace cocoon
