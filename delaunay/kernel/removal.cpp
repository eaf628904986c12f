#include "delaunay/kernel/removal.h"

#include <algorithm>
#include <array>

#include "delaunay/kernel/first_cells.h"
#include "geom/arrays/sort_ids.h"

namespace cocoon {

RemovalCounters& RemovalCounters::operator+=(const RemovalCounters& other) {
  holes += other.holes;
  largest_hole = std::max(largest_hole, other.largest_hole);
  border_vertices += other.border_vertices;
  flat_borders += other.flat_borders;
  cells_deleted += other.cells_deleted;
  cells_created += other.cells_created;
  filling += other.filling;
  return *this;
}

VertexRemover::VertexRemover(CellPool& pool, const IdVector<VertexId, Point>& points)
    : pool_(pool), points_(points) {}

// Whether it is removed; lists the vertices that stay.
bool VertexRemover::loses(VertexId v) {
  if (v == infinite_vertex) return false;
  if (fate_[v] == Fate::stays) {
    fate_[v] = Fate::stays_and_is_listed;
    hole_vertices_.push_back(v);
  }
  return fate_[v] == Fate::is_removed;
}

// --- Holes -----------------------------------------------------------------------------------

// One hole, by a flood through facets that lose a vertex.
void VertexRemover::collect_hole(CellId start) {
  Hole hole{.first_cell = hole_cells_.size(),
            .first_border = border_.size(),
            .first_vertex = hole_vertices_.size()};
  hole_cells_.push_back(start);
  in_hole_[start] = 1;
  for (std::size_t k = hole.first_cell; k < hole_cells_.size(); ++k) {
    const CellId c = hole_cells_[k];
    const Cell& cell = pool_.cells[c];
    std::array<int, 4> is_lost{};
    for (std::size_t i = 0; i < 4; ++i) is_lost[i] = loses(cell.vertices[i]) ? 1 : 0;
    const int lost = is_lost[0] + is_lost[1] + is_lost[2] + is_lost[3];
    for (std::size_t i = 0; i < 4; ++i) {
      const FacetId outer = cell.neighbors[i];
      if (lost == is_lost[i]) {
        border_.push_back({.inner = facet_id(c, static_cast<int>(i)), .outer = outer});
      } else if (in_hole_[cell_of(outer)] == 0) {
        in_hole_[cell_of(outer)] = 1;
        hole_cells_.push_back(cell_of(outer));
      }
    }
  }
  hole.end_cell = hole_cells_.size();
  hole.end_border = border_.size();
  hole.end_vertex = hole_vertices_.size();
  for (std::size_t k = hole.first_vertex; k < hole.end_vertex; ++k) {
    fate_[hole_vertices_[k]] = Fate::stays;
  }
  holes_.push_back(hole);
}

void VertexRemover::collect_holes(std::span<const VertexId> vertices,
                                  const IdVector<VertexId, CellId>& cell_at) {
  holes_.clear();
  hole_cells_.clear();
  hole_vertices_.clear();
  border_.clear();
  for (const VertexId v : vertices) fate_[v] = Fate::is_removed;
  // The star of a vertex lies in one hole, so one of its cells tells whether it was found.
  for (const VertexId v : vertices) {
    if (in_hole_[cell_at[v]] == 0) collect_hole(cell_at[v]);
  }
  for (BorderFacet& facet : border_) facet.is_seam = in_hole_[cell_of(facet.outer)] != 0;
  for (const CellId c : hole_cells_) in_hole_[c] = 0;
}

// Chooses four remaining vertices that span space: those of a finite cell that stays. Finite cells
// are connected through facets, so if one stays, one lies behind the border of a hole. If none
// does, the vertices around the holes are all that remain.
bool VertexRemover::find_anchor() {
  for (const BorderFacet& facet : border_) {
    const Cell& cell = pool_.cells[cell_of(facet.outer)];
    if (facet.is_seam || is_infinite(cell)) continue;
    anchor_ = cell.vertices;
    return true;
  }
  filler_.clear();
  for (const Hole& hole : holes_) link_border_vertices(hole);
  order_.clear();
  for (const VertexId v : link_) order_.push_back(v.value);
  forget_link();
  if (bring_simplex_to_front(points_, order_) < 3) return false;
  for (std::size_t i = 0; i < 4; ++i) anchor_[i] = VertexId(order_[i]);
  return true;
}

// --- Filling ---------------------------------------------------------------------------------

void VertexRemover::link_vertex(VertexId v) {
  if (!number_of_[v].is_none()) return;
  number_of_[v] = filler_.add_point(points_[v]);
  link_.push_back(v);
}

void VertexRemover::link_border_vertices(const Hole& hole) {
  for (std::size_t k = hole.first_vertex; k < hole.end_vertex; ++k) {
    link_vertex(hole_vertices_[k]);
  }
}

void VertexRemover::forget_link() {
  for (const VertexId v : link_) number_of_[v] = VertexId();
  link_.clear();
}

void VertexRemover::fill_hole(const Hole& hole) {
  filler_.clear();
  link_border_vertices(hole);
  ++counters_.holes;
  counters_.border_vertices += link_.size();
  counters_.largest_hole = std::max(counters_.largest_hole, hole.end_cell - hole.first_cell);
  if (!filler_.spans_space()) {
    ++counters_.flat_borders;
    for (const VertexId v : anchor_) link_vertex(v);
    filler_.spans_space();
  }
  const auto number = [&](VertexId v) { return v == infinite_vertex ? v : number_of_[v]; };
  triangles_.clear();
  for (std::size_t b = hole.first_border; b < hole.end_border; ++b) {
    const FacetId inner = border_[b].inner;
    Triangle& triangle =
        triangles_.emplace_back(facet_vertices(pool_.cells[cell_of(inner)], index_of(inner)));
    for (VertexId& v : triangle) v = number(v);
  }
  const HoleFilling& filling = filler_.fill(triangles_, counters_.filling);

  // Back to the vertices of the triangulation, and behind the cells of the holes before.
  const auto offset = static_cast<std::uint32_t>(4 * fill_cells_.size());
  const auto moved = [&](FacetId f) { return f.is_none() ? f : FacetId(f.value + offset); };
  for (Cell cell : filling.cells) {
    for (VertexId& v : cell.vertices) v = v == infinite_vertex ? v : link_[v.index()];
    for (FacetId& neighbor : cell.neighbors) neighbor = moved(neighbor);
    fill_cells_.push_back(cell);
  }
  for (std::size_t b = hole.first_border; b < hole.end_border; ++b) {
    border_[b].filled = moved(filling.facet_at_border[b - hole.first_border]);
  }
  forget_link();
}

bool VertexRemover::plan(std::span<const VertexId> vertices,
                         const IdVector<VertexId, CellId>& cell_at) {
  fate_.resize(std::max(fate_.size(), points_.size()), Fate::stays);
  number_of_.resize(std::max(number_of_.size(), points_.size()));
  in_hole_.resize(std::max(in_hole_.size(), pool_.cells.size()), 0);
  counters_ = {};
  fill_cells_.clear();
  slots_.clear();
  collect_holes(vertices, cell_at);
  const bool spans_space = find_anchor();
  if (spans_space) {
    for (const Hole& hole : holes_) fill_hole(hole);
  }
  for (const VertexId v : vertices) fate_[v] = Fate::stays;
  counters_.cells_deleted = hole_cells_.size();
  counters_.cells_created = fill_cells_.size();
  return spans_space;
}

// --- Writing ---------------------------------------------------------------------------------

// A facet of fill_cells_ as the pool numbers it.
FacetId VertexRemover::placed(FacetId filled) const {
  return facet_id(slots_[cell_of(filled).index()], index_of(filled));
}

// Links the two new facets at each facet between two deleted cells.
void VertexRemover::join_seams() {
  struct Seam {
    FacetId old;  // canonical
    FacetId placed;
  };
  std::vector<Seam> seams;
  for (const BorderFacet& facet : border_) {
    if (facet.is_seam) seams.push_back({std::min(facet.inner, facet.outer), placed(facet.filled)});
  }
  std::sort(seams.begin(), seams.end(), [](const Seam& a, const Seam& b) { return a.old < b.old; });
  const auto link = [&](FacetId from, FacetId to) {
    pool_.cells[cell_of(from)].neighbors[static_cast<std::size_t>(index_of(from))] = to;
  };
  for (std::size_t i = 0; i < seams.size(); i += 2) {
    link(seams[i].placed, seams[i + 1].placed);
    link(seams[i + 1].placed, seams[i].placed);
  }
}

void VertexRemover::commit() {
  // In the order of memory: what is inserted next takes the free places from the lowest on, and
  // cells that are made one after the other lie together.
  sort_ids(hole_cells_);
  take_places(pool_, pool_.free, hole_cells_, fill_cells_.size(), slots_);
  for (std::size_t k = 0; k < fill_cells_.size(); ++k) {
    Cell cell = fill_cells_[k];
    for (FacetId& neighbor : cell.neighbors) {
      if (!neighbor.is_none()) neighbor = placed(neighbor);
    }
    pool_.cells[slots_[k]] = cell;
  }
  for (const BorderFacet& facet : border_) {
    if (facet.is_seam) continue;
    const FacetId inner = placed(facet.filled);
    pool_.cells[cell_of(inner)].neighbors[static_cast<std::size_t>(index_of(inner))] = facet.outer;
    pool_.cells[cell_of(facet.outer)].neighbors[static_cast<std::size_t>(index_of(facet.outer))] =
        inner;
  }
  join_seams();
}

}  // namespace cocoon
