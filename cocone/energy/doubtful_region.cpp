#include "cocone/energy/doubtful_region.h"

#include <algorithm>

#include "geom/arrays/disjoint_sets.h"

namespace cocoon {
namespace {

std::vector<CellId> poor_cells(const Triangulation& triangulation, const CellMarks& marks,
                               StarCache& stars) {
  std::vector<VertexId> poor;
  for (const VertexId v : triangulation.vertices()) {
    if (marks.good[v] == 0) poor.push_back(v);
  }
  std::vector<CellId> cells = stars.cells_at(poor);
  std::erase_if(cells, [&](CellId c) {
    return triangulation.is_infinite(c) || !is_poor(triangulation, marks.good, c) ||
           is_known(marks, c);
  });
  return cells;
}

// Of each cell: how many hang together with it.
std::vector<std::uint32_t> sizes_of_clumps(const Triangulation& triangulation,
                                           const std::vector<CellId>& cells) {
  ZeroedArray<CellId, std::uint32_t> place(triangulation.num_cells());  // 1 + that in `cells`
  DisjointSets clumps(cells.size());
  for (std::uint32_t k = 0; k < cells.size(); ++k) {
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t earlier = place[triangulation.neighbor(cells[k], i)];
      if (earlier != 0) clumps.join(earlier - 1, k);
    }
    place[cells[k]] = k + 1;
  }
  std::vector<std::uint32_t> sizes(cells.size(), 0);
  for (std::uint32_t k = 0; k < cells.size(); ++k) ++sizes[clumps.root(k)];
  for (std::uint32_t k = 0; k < cells.size(); ++k) sizes[k] = sizes[clumps.root(k)];
  return sizes;
}

void leave_large_clumps(const Triangulation& triangulation, std::size_t most_cells,
                        DoubtfulRegion& region) {
  const std::vector<std::uint32_t> sizes = sizes_of_clumps(triangulation, region.undecided);
  std::vector<CellId> kept;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const CellId c = region.undecided[k];
    if (sizes[k] <= most_cells) {
      kept.push_back(c);
      continue;
    }
    if (region.left_cells++ == 0) region.left = VertexSet(triangulation.num_vertices(), 0);
    for (const VertexId v : triangulation.cell(c).vertices) region.left[v] = 1;
  }
  for (const CellId c : kept) {
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (region.left_cells != 0) region.left[v] = 0;
    }
  }
  region.undecided = std::move(kept);
}

int num_good(const Triangulation& triangulation, const CellMarks& marks, CellId c) {
  const auto& [v0, v1, v2, v3] = triangulation.cell(c).vertices;
  return marks.good[v0] + marks.good[v1] + marks.good[v2] + marks.good[v3];
}

// Good vertices whose labels contradict the surface.
std::vector<VertexId> contradicted_vertices(const Triangulation& triangulation,
                                            const CellMarks& marks) {
  std::vector<VertexId> vertices;
  if (marks.conflicts == 0) return vertices;
  for (const VertexId v : triangulation.vertices()) {
    if (is_contradicted(marks, v)) vertices.push_back(v);
  }
  return vertices;
}

// Takes in the thin cells at these vertices and those that hang together with undecided ones, but
// for those at what is left.
void add_thin_cells(const Triangulation& triangulation, const CellMarks& marks, StarCache& stars,
                    std::span<const VertexId> at, int thin_support, DoubtfulRegion& region) {
  std::vector<CellId>& cells = region.undecided;
  const std::size_t poor = cells.size();
  ZeroedArray<CellId, std::uint8_t> is_met(triangulation.num_cells());
  for (const CellId c : cells) is_met[c] = 1;
  const auto meet = [&](CellId c) {
    if (is_met[c] != 0 || triangulation.is_infinite(c) || is_known(marks, c)) return;
    is_met[c] = 1;
    const int good = num_good(triangulation, marks, c);
    if (good == 0 || good > thin_support || has_left_vertex(triangulation, region, c)) return;
    cells.push_back(c);
  };
  for (const CellId c : stars.cells_at(at)) meet(c);
  for (std::size_t next = 0; next < cells.size(); ++next) {
    for (int i = 0; i < 4; ++i) meet(triangulation.neighbor(cells[next], i));
  }
  region.thin_cells = cells.size() - poor;
  std::sort(cells.begin(), cells.end());
}

// By SpacingCache::precedes, from the first of these on; those before it are.
void sort_from(std::size_t first, SpacingCache& spacings, std::vector<VertexId>& vertices) {
  const auto precedes = [&](VertexId a, VertexId b) { return spacings.precedes(a, b); };
  const auto middle = vertices.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(middle, vertices.end(), precedes);
  std::inplace_merge(vertices.begin(), middle, vertices.end(), precedes);
}

void rank_vertices(DoubtfulRegion& region) {
  for (std::uint32_t k = 0; k < region.vertices.size(); ++k) {
    region.rank[region.vertices[k]] = k + 1;
  }
}

std::vector<VertexId> doubtful_vertices(const Triangulation& triangulation, const CellMarks& marks,
                                        const DoubtfulRegion& region) {
  VertexSet is_corner(triangulation.num_vertices(), 0);  // of an undecided cell
  for (const CellId c : region.undecided) {
    for (const VertexId v : triangulation.cell(c).vertices) is_corner[v] = 1;
  }
  std::vector<VertexId> vertices;
  for (const VertexId v : triangulation.vertices()) {
    const bool doubtful = marks.good[v] == 0 || is_corner[v] != 0 || is_contradicted(marks, v);
    if (doubtful && !region.is_left(v)) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace

DoubtfulRegion find_doubtful_region(const Triangulation& triangulation, const CellMarks& marks,
                                    StarCache& stars, SpacingCache& spacings,
                                    std::size_t most_cells, int thin_support,
                                    const Execution& execution) {
  DoubtfulRegion region;
  region.undecided = poor_cells(triangulation, marks, stars);
  if (region.undecided.size() > most_cells) leave_large_clumps(triangulation, most_cells, region);
  const std::vector<VertexId> contradicted = contradicted_vertices(triangulation, marks);
  if (thin_support > 0 && region.undecided.size() + contradicted.size() > 0) {
    add_thin_cells(triangulation, marks, stars, contradicted, thin_support, region);
  }
  region.vertices = doubtful_vertices(triangulation, marks, region);
  spacings.prepare(region.vertices, execution);
  sort_from(0, spacings, region.vertices);
  region.rank = ZeroedArray<VertexId, std::uint32_t>(triangulation.num_vertices());
  rank_vertices(region);
  region.cells = stars.cells_at(region.vertices);
  return region;
}

void extend_region(StarCache& stars, SpacingCache& spacings, std::span<const VertexId> vertices,
                   DoubtfulRegion& region) {
  const std::size_t before = region.vertices.size();
  for (const VertexId v : vertices) {
    if (region.contains(v) || region.is_left(v)) continue;
    region.vertices.push_back(v);
    region.rank[v] = 1;
  }
  if (region.vertices.size() == before) return;
  const std::vector<CellId> more = stars.cells_at(std::span(region.vertices).subspan(before));
  const auto middle = static_cast<std::ptrdiff_t>(region.cells.size());
  region.cells.insert(region.cells.end(), more.begin(), more.end());
  std::inplace_merge(region.cells.begin(), region.cells.begin() + middle, region.cells.end());
  region.cells.erase(std::unique(region.cells.begin(), region.cells.end()), region.cells.end());
  sort_from(before, spacings, region.vertices);
  rank_vertices(region);
}

bool has_left_vertex(const Triangulation& triangulation, const DoubtfulRegion& region, CellId c) {
  const auto& vertices = triangulation.cell(c).vertices;
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](VertexId v) { return region.is_left(v); });
}

}  // namespace cocoon
