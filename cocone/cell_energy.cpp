#include "cocone/cell_energy.h"

#include <algorithm>
#include <cmath>

#include "delaunay/circulate.h"

namespace cocoon {
namespace {

std::size_t extra(std::size_t count, std::size_t regular) {
  return count < regular ? 0 : count - regular;
}

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The two of 0 .. 3 that are neither i nor j.
std::array<int, 2> others(int i, int j) {
  int k = 0;
  while (k == i || k == j) ++k;
  return {k, 6 - i - j - k};
}

}  // namespace

Energy to_energy(double units) { return std::llround(units * 0x1p+20); }

CellEnergy::CellEnergy(const Triangulation& triangulation, BallCosines& cosines, StarCache& stars,
                       const IdVector<CellId, CellLabel>& labels, const CleanUpOptions& options,
                       IdVector<CellId, std::uint8_t>& out)
    : triangulation_(triangulation),
      cosines_(cosines),
      stars_(stars),
      labels_(labels),
      out_(out),
      mark_weight_(to_energy(options.mark_weight)),
      defect_cost_(to_energy(options.defect_cost)),
      unused_cost_(to_energy(options.unused_cost)),
      half_handle_cost_(to_energy(options.handle_cost / 2)),
      idle_cost_(to_energy(options.idle_cost)),
      idle_(options.idle),
      own_preference_(triangulation.num_cells()),
      wanted_(triangulation.num_vertices(), 0),
      parts_(triangulation, stars, out),
      flips_now_(triangulation.num_cells()),
      idle_now_(triangulation.num_vertices()),
      changed_(triangulation.num_vertices()) {}

Energy CellEnergy::facet_cost(FacetId f) {
  return to_energy(1 - std::min(cosines_.of(f), cosines_.of(triangulation_.mirror(f))));
}

bool CellEnergy::is_unused(VertexId v) const {
  const std::span<const CellId> star = stars_.star(v);
  for (const CellId c : star) {
    if (out_[c] != out_[star.front()]) return false;
  }
  return true;
}

std::size_t CellEnergy::extra_fans(VertexId v) { return extra(parts_.count(v), 2); }

Energy CellEnergy::vertex_cost(VertexId v) {
  if (is_unused(v)) return wanted_[v] != 0 ? unused_cost_ : 0;
  return defect_cost_ * static_cast<Energy>(extra_fans(v));
}

// Surface sheets at the edge of vertices i and j of the cell. O(degree).
std::size_t CellEnergy::sheets_at(CellId c, int i, int j) const {
  const VertexId a = triangulation_.vertex(c, i);
  const VertexId b = triangulation_.vertex(c, j);
  int off = 0;  // a facet at the edge is opposite another vertex
  while (off == i || off == j) ++off;
  std::size_t changes = 0;
  std::uint8_t before = out_[c];
  const FacetId first = facet_id(c, off);
  FacetId f = first;
  do {
    f = next_facet_around_edge(triangulation_, f, a, b);
    const std::uint8_t here = out_[cell_of(f)];
    changes += here != before ? 1U : 0U;
    before = here;
  } while (f != first);
  return changes / 2;
}

// The cell's flip changes what the surface is at its vertex i. In the link of the vertex, a sphere,
// the cell is a triangle, whose corners are the cell's edges there. Where all cells around such an
// edge but this one are on one side, they hang together without it; if that is so at each edge that
// matters, the parts of the star can be told from the three facets. Else they are counted.
Energy CellEnergy::vertex_change(CellId c, int i, const Place& place) {
  const VertexId v = triangulation_.vertex(c, i);
  int kept = 0;  // facets at v with the same side behind them
  bool regular = true;
  for (int j = 0; j < 4; ++j) {
    if (j == i) continue;
    const auto [k, l] = others(i, j);
    kept += place.surface[at(j)] ? 0 : 1;
    if (place.surface[at(k)] != place.surface[at(l)]) continue;
    regular = regular && place.sheets[at(i)][at(j)] == (place.surface[at(k)] ? 1U : 0U);
  }
  // One or two: the cell goes from a part that stays whole to one that it borders.
  if (regular && (kept == 1 || kept == 2)) return 0;
  // Three: it becomes a part of its own. None: it was one, and the others are one part.
  if (regular) {
    const Energy more = kept == 3 ? 1 : -1;
    if (kept == 0) out_[c] ^= 1U;
    const bool unused = is_unused(v);
    if (kept == 0) out_[c] ^= 1U;
    return unused ? more * cost_of_use(v) : more * defect_cost_;
  }
  const auto [before, after] = parts_.count_change(v, c);
  const Energy more = static_cast<Energy>(extra(after, 2)) - static_cast<Energy>(extra(before, 2));
  const Energy used = (after > 1 ? 1 : 0) - (before > 1 ? 1 : 0);
  return more * defect_cost_ + used * cost_of_use(v);
}

// Without what idle samples cost.
Energy CellEnergy::flip_change(CellId c) {
  Place place{};
  Energy total = out_[c] != 0 ? -preference(c) : preference(c);
  Energy euler = 0;
  for (int i = 0; i < 4; ++i) {
    const FacetId f = facet_id(c, i);
    place.surface[at(i)] = out_[triangulation_.neighbor(c, i)] != out_[c];
    total += place.surface[at(i)] ? -facet_cost(f) : facet_cost(f);
    euler += place.surface[at(i)] ? -1 : 1;
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const auto [k, l] = others(i, j);
      if (place.surface[at(k)] != place.surface[at(l)]) continue;  // the surface only turns there
      const std::size_t before = sheets_at(c, i, j);
      const std::size_t after = place.surface[at(k)] ? before - 1 : before + 1;
      place.sheets[at(i)][at(j)] = place.sheets[at(j)][at(i)] = before;
      euler += (before > 0 ? 1 : 0) - (after > 0 ? 1 : 0);
      total += defect_cost_ *
               (static_cast<Energy>(extra(after, 1)) - static_cast<Energy>(extra(before, 1)));
    }
  }
  total -= half_handle_cost_ * euler;
  for (int i = 0; i < 4; ++i) total += vertex_change(c, i, place);
  return total;
}

// The same, remembered until cells at its vertices change sides for good: many sets begin with the
// same cell.
Energy CellEnergy::flip_change_now(CellId c) {
  FlipNow& flip = flips_now_[c];
  const auto& vertices = triangulation_.cell(c).vertices;
  const bool known =
      flip.state != 0 && std::all_of(vertices.begin(), vertices.end(),
                                     [&](VertexId v) { return changed_[v] <= flip.state; });
  if (!known) {
    flip = {flip_change(c), state_};
  }
  return flip.change;
}

// Remembers it until cells at the vertex change sides for good.
bool CellEnergy::is_idle_now(VertexId v) {
  std::uint32_t& known = idle_now_[v];
  if (known == 0 || known / 2 < changed_[v]) known = 2 * state_ + (is_idle(v) ? 1 : 0);
  return known % 2 != 0;
}

Energy CellEnergy::change(std::span<const CellId> cells, Energy limit) {
  Energy total = 0;
  for (const CellId c : cells) {
    total += c == cells.front() ? flip_change_now(c) : flip_change(c);
    out_[c] ^= 1U;
  }
  const auto undo = [&] {
    for (const CellId c : cells) out_[c] ^= 1U;
  };
  undo();
  if (idle_cost_ == 0) return total;
  vertices_.clear();
  for (const CellId c : cells) {
    for (const VertexId v : triangulation_.cell(c).vertices) vertices_.push_back(v);
  }
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  for (const VertexId v : vertices_) total -= is_idle_now(v) ? idle_cost_ : 0;
  if (total > limit) return total;
  undo();
  for (const VertexId v : vertices_) total += is_idle(v) ? idle_cost_ : 0;
  undo();
  return total;
}

bool CellEnergy::leaves_out(std::span<const CellId> cells) {
  std::vector<VertexId> used;
  for (const CellId c : cells) {
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (!is_unused(v)) used.push_back(v);
    }
  }
  flip(cells);
  const bool lost = std::any_of(used.begin(), used.end(), [&](VertexId v) { return is_unused(v); });
  flip(cells);
  return lost;
}

void CellEnergy::flip(std::span<const CellId> cells) {
  ++state_;
  for (const CellId c : cells) {
    out_[c] ^= 1U;
    for (const VertexId v : triangulation_.cell(c).vertices) changed_[v] = state_;
  }
}

}  // namespace cocoon
