#include "cocone/cell_energy.h"

#include <algorithm>
#include <cmath>

#include "delaunay/circulate.h"

namespace cocoon {

Energy to_energy(double units) { return std::llround(units * 0x1p+20); }

CellEnergy::CellEnergy(const Triangulation& triangulation, const Dual& dual, StarCache& stars,
                       const IdVector<CellId, CellLabel>& labels, const CleanUpOptions& options,
                       IdVector<CellId, std::uint8_t>& out)
    : triangulation_(triangulation),
      dual_(dual),
      stars_(stars),
      labels_(labels),
      out_(out),
      mark_weight_(to_energy(options.mark_weight)),
      defect_cost_(to_energy(options.defect_cost)),
      unused_cost_(to_energy(options.unused_cost)),
      handle_cost_(to_energy(options.handle_cost)),
      idle_cost_(to_energy(options.idle_cost)),
      idle_(options.idle),
      own_preference_(triangulation.num_cells()),
      wanted_(triangulation.num_vertices(), 0),
      stamp_(triangulation.num_cells()) {}

Energy CellEnergy::facet_cost(FacetId f) const {
  const double here = ball_cosine(triangulation_, dual_, f);
  const double behind = ball_cosine(triangulation_, dual_, triangulation_.mirror(f));
  return to_energy(1 - std::min(here, behind));
}

bool CellEnergy::is_unused(VertexId v) const {
  const std::span<const CellId> star = stars_.star(v);
  for (const CellId c : star) {
    if (out_[c] != out_[star.front()]) return false;
  }
  return true;
}

void CellEnergy::flood_star(VertexId v, CellId first, std::vector<CellId>& cells) {
  cells.assign(1, first);
  stamp_[first] = token_;
  for (std::size_t next = 0; next < cells.size(); ++next) {
    const CellId c = cells[next];
    const int opposite = index_of_vertex(triangulation_.cell(c), v);
    for (int i = 0; i < 4; ++i) {
      const CellId behind = triangulation_.neighbor(c, i);
      if (i == opposite || stamp_[behind] == token_ || out_[behind] != out_[first]) continue;
      stamp_[behind] = token_;
      cells.push_back(behind);
    }
  }
}

std::size_t CellEnergy::extra_fans(VertexId v) {
  ++token_;
  std::size_t parts = 0;
  for (const CellId c : stars_.star(v)) {
    if (stamp_[c] == token_) continue;
    ++parts;
    flood_star(v, c, component_);
  }
  return parts < 2 ? 0 : parts - 2;
}

std::size_t CellEnergy::sheets_at(FacetId f, VertexId a, VertexId b) const {
  std::size_t changes = 0;
  for_each_facet_around_edge(triangulation_, f, a, b, [&](FacetId g) {
    changes += out_[cell_of(g)] != out_[cell_of(triangulation_.mirror(g))];
  });
  return changes / 2;
}

Energy CellEnergy::vertex_cost(VertexId v) {
  if (is_unused(v)) return wanted_[v] != 0 ? unused_cost_ : 0;
  return defect_cost_ * static_cast<Energy>(extra_fans(v));
}

// The vertices, edges and facets of these cells, each once.
void CellEnergy::collect(std::span<const CellId> cells) {
  vertices_.clear();
  edges_.clear();
  facets_.clear();
  for (const CellId c : cells) {
    const Cell& cell = triangulation_.cell(c);
    for (std::size_t i = 0; i < 4; ++i) {
      vertices_.push_back(cell.vertices[i]);
      facets_.push_back(triangulation_.canonical(facet_id(c, static_cast<int>(i))));
      for (std::size_t j = i + 1; j < 4; ++j) {
        const int off = i == 0 ? (j == 1 ? 2 : 1) : 0;  // a facet at the edge: opposite another one
        const VertexId a = std::min(cell.vertices[i], cell.vertices[j]);
        const VertexId b = std::max(cell.vertices[i], cell.vertices[j]);
        edges_.push_back({a, b, facet_id(c, off)});
      }
    }
  }
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  std::sort(facets_.begin(), facets_.end());
  facets_.erase(std::unique(facets_.begin(), facets_.end()), facets_.end());
  std::sort(edges_.begin(), edges_.end(),
            [](const Edge& x, const Edge& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  const auto same = [](const Edge& x, const Edge& y) { return x.a == y.a && x.b == y.b; };
  edges_.erase(std::unique(edges_.begin(), edges_.end(), same), edges_.end());
}

Energy CellEnergy::sum(std::span<const CellId> cells) {
  Energy total = 0;
  Energy euler = 0;  // of what these cells can change
  for (const CellId c : cells) total += out_[c] != 0 ? preference(c) : 0;
  for (const FacetId f : facets_) {
    if (out_[cell_of(f)] == out_[cell_of(triangulation_.mirror(f))]) continue;
    total += facet_cost(f);
    ++euler;
  }
  for (const VertexId v : vertices_) {
    const bool unused = is_unused(v);
    euler += unused ? 0 : 1;
    if (unused) {
      total += wanted_[v] != 0 ? unused_cost_ : 0;
    } else {
      total += defect_cost_ * static_cast<Energy>(extra_fans(v));
      if (idle_cost_ != 0 && is_idle(v)) total += idle_cost_;
    }
  }
  for (const Edge& e : edges_) {
    const std::size_t sheets = sheets_at(e.facet, e.a, e.b);
    euler -= sheets > 0 ? 1 : 0;
    if (sheets > 1) total += defect_cost_ * static_cast<Energy>(sheets - 1);
  }
  return total - handle_cost_ * euler / 2;
}

Energy CellEnergy::change(std::span<const CellId> cells) {
  collect(cells);
  const Energy before = sum(cells);
  flip(cells);
  const Energy after = sum(cells);
  flip(cells);
  return after - before;
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
  for (const CellId c : cells) out_[c] ^= 1U;
}

}  // namespace cocoon
