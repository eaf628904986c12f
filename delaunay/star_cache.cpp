#include "delaunay/star_cache.h"

#include <algorithm>
#include <atomic>

#include "delaunay/circulate.h"
#include "geom/arrays/sort_ids.h"

namespace cocoon {

namespace {
constexpr std::uint32_t not_found = 0xFFFFFFFFU;
constexpr std::size_t few = 1024;
}  // namespace

std::span<const CellId> StarCache::star(VertexId v) {
  if (all_.has_value()) return all_->star(v);
  if (place_.empty()) begin();
  if (place_[v] == not_found) {
    place_[v] = static_cast<std::uint32_t>(stars_.size());
    stars_.push_back(collect(v));
    cells_of_stars_ += stars_.back().size();
    if (are_many(stars_.size()) || are_many_cells(cells_of_stars_)) {
      all_ = vertex_stars(triangulation_, execution_);
      return all_->star(v);
    }
  }
  return stars_[place_[v]];
}

bool StarCache::are_many(std::size_t count) const {
  return 16 * count > triangulation_.num_vertices() + few;
}

bool StarCache::are_many_cells(std::size_t count) const {
  return 3 * count > triangulation_.num_cells() + few;
}

bool StarCache::expect(std::size_t count) {
  if (!all_.has_value() && are_many(count)) all_ = vertex_stars(triangulation_, execution_);
  return all_.has_value();
}

std::vector<CellId> StarCache::cells_at(std::span<const VertexId> vertices) {
  std::vector<CellId> cells;
  bool pass = are_many(vertices.size());
  for (std::size_t k = 0; k < vertices.size() && !pass; ++k) {
    const std::span<const CellId> at_v = star(vertices[k]);
    cells.insert(cells.end(), at_v.begin(), at_v.end());
    pass = are_many_cells(cells.size());
  }
  if (!pass) {
    make_set(cells);
    return cells;
  }
  cells.clear();
  IdVector<VertexId, std::uint8_t> asked(triangulation_.num_vertices(), 0);
  for (const VertexId v : vertices) asked[v] = 1;
  for (const CellId c : triangulation_.cells()) {
    const auto& corners = triangulation_.cell(c).vertices;
    const auto is_asked = [&](VertexId v) { return v != infinite_vertex && asked[v] != 0; };
    if (std::any_of(corners.begin(), corners.end(), is_asked)) cells.push_back(c);
  }
  return cells;
}

void StarCache::begin() {
  place_.resize(triangulation_.num_vertices(), not_found);
  seen_ = ZeroedArray<CellId, std::uint8_t>(triangulation_.num_cells());
  if (cell_at_ == nullptr) find_first_cells();
}

void StarCache::find_first_cells() {
  constexpr std::size_t cells_per_chunk = std::size_t{1} << 14;
  first_cell_.resize(triangulation_.num_vertices());
  parallel_chunks(
      execution_, triangulation_.num_finite_cells(), cells_per_chunk,
      [&](std::size_t begin, std::size_t end) {
        for (CellId c(begin); c.index() < end; ++c) {
          for (const VertexId v : triangulation_.cell(c).vertices) {
            // Which of its cells it is does not show: stars come out sorted.
            std::atomic_ref(first_cell_[v].value).store(c.value, std::memory_order_relaxed);
          }
        }
      });
}

// From cell to cell through the facets at v.
std::vector<CellId> StarCache::collect(VertexId v) {
  std::vector<CellId> cells{cell_at_ != nullptr ? (*cell_at_)[v] : first_cell_[v]};
  seen_[cells[0]] = 1;
  for (std::size_t next = 0; next < cells.size(); ++next) {
    const Cell& cell = triangulation_.cell(cells[next]);
    const int opposite = index_of_vertex(cell, v);
    for (int i = 0; i < 4; ++i) {
      const CellId behind = cell_of(cell.neighbors[static_cast<std::size_t>(i)]);
      if (i == opposite || seen_[behind] != 0) continue;
      seen_[behind] = 1;
      cells.push_back(behind);
    }
  }
  for (const CellId c : cells) seen_[c] = 0;
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace cocoon
