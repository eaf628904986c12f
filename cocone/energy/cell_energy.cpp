#include "cocone/energy/cell_energy.h"

#include <algorithm>
#include <cmath>

#include "delaunay/circulate.h"
#include "delaunay/vertices_of_cells.h"

namespace cocoon {
namespace {

std::size_t extra(std::size_t count, std::size_t regular) {
  return count < regular ? 0 : count - regular;
}

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Of the edge between the corners i and j.
constexpr std::size_t edge_number[4][4] = {{6, 0, 1, 2}, {0, 6, 3, 4}, {1, 3, 6, 5}, {2, 4, 5, 6}};

// The two of 0 .. 3 that are neither i nor j.
std::array<int, 2> others(int i, int j) {
  int k = 0;
  while (k == i || k == j) ++k;
  return {k, 6 - i - j - k};
}

}  // namespace

// Rounded to the nearest integer, halves away from zero. The difference is exact.
Energy to_energy(double units) {
  constexpr auto most = static_cast<double>(most_energy);
  if (std::isnan(units)) return 0;  // a cost without limit, times zero
  const double scaled = std::clamp(units * 0x1p+20, -most, most);
  const auto whole = static_cast<Energy>(scaled);
  const double rest = scaled - static_cast<double>(whole);
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}

CellEnergy::CellEnergy(const Triangulation& triangulation, BallCosines& cosines, StarCache& stars,
                       SpacingCache& spacings, const CellMarks& marks,
                       const CleanUpOptions& options, IdVector<CellId, std::uint8_t>& out)
    : triangulation_(triangulation),
      cosines_(cosines),
      stars_(stars),
      spacings_(spacings),
      marks_(marks),
      out_(out),
      stretch_cost_(options.stretch_cost),
      stretch_ratio_(options.stretch_ratio),
      mark_weight_(to_energy(options.mark_weight)),
      defect_cost_(to_energy(options.defect_cost)),
      unused_cost_(to_energy(options.unused_cost)),
      half_handle_cost_(to_energy(options.handle_cost / 2)),
      idle_cost_(to_energy(options.idle_cost)),
      idle_(options.idle),
      own_preference_(triangulation.num_cells()),
      wanted_(triangulation.num_vertices(), 0),
      parts_(triangulation, stars, out),
      facet_costs_(4 * triangulation.num_cells()),
      places_now_(triangulation.num_cells()),
      at_(triangulation.num_vertices()),
      taken_(triangulation.num_cells()),
      listed_(triangulation.num_vertices()) {}

// A cost is the same from both sides, and never changes. Those beyond 2^32, with a stretch_cost of
// thousands, are computed each time.
Energy CellEnergy::ask_facet_cost(FacetId f) {
  const FacetId mirror = triangulation_.mirror(f);
  const double cosine = std::min(cosines_.of(f), cosines_.of(mirror));
  const Energy cost = to_energy(1 - cosine + stretch(f));
  if (cost < std::numeric_limits<std::uint32_t>::max()) {
    facet_costs_[std::min(f, mirror)] = static_cast<std::uint32_t>(cost + 1);
  }
  return cost;
}

// Flat cells see through others, which threads would have to remember.
void CellEnergy::prepare_facet_costs(std::span<const CellId> cells, const Execution& execution) {
  if (!spacings_.prepare(vertices_of(triangulation_, cells), execution)) return;
  constexpr std::size_t cells_per_chunk = 4096;
  for (const CellId c : cells) taken_[c] = 1;
  parallel_chunks(execution, cells.size(), cells_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (const CellId c : cells.subspan(begin, end - begin)) {
                      for (int i = 0; i < 4 && !cosines_.is_flat(c); ++i) {
                        const CellId behind = triangulation_.neighbor(c, i);
                        if (taken_[behind] != 0 && behind < c) continue;  // asked from there
                        if (!cosines_.is_flat(behind)) ask_facet_cost(facet_id(c, i));
                      }
                    }
                  });
  for (const CellId c : cells) taken_[c] = 0;
}

double CellEnergy::stretch(FacetId f) {
  if (stretch_cost_ == 0) return 0;
  const Triangle corners = triangulation_.facet_vertices(f);
  const Point& p = triangulation_.point(corners[0]);
  const Point& q = triangulation_.point(corners[1]);
  const Point& r = triangulation_.point(corners[2]);
  const double square =
      std::max({squared_distance(p, q), squared_distance(q, r), squared_distance(r, p)});
  double limit = stretch_ratio_ * spacings_.of(corners[0]);
  if (square < 0.5 * (limit * limit)) return 0;  // nearly always; with room for rounding
  const double longest = std::sqrt(square);
  limit = 0;
  for (const VertexId v : corners) {
    limit = std::max(limit, stretch_ratio_ * spacings_.of(v));
    if (longest <= limit) return 0;
  }
  return stretch_cost_ * (1 - limit / longest);
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

Energy CellEnergy::vertex_cost_after(VertexId v, std::span<const CellId> cells) {
  turn(cells);
  const Energy cost = vertex_cost(v);
  turn(cells);
  return cost;
}

// Surface sheets at the edge of vertices i and j of the cell, of which there are at most so many.
// O(degree).
int CellEnergy::sheets_at(CellId c, int i, int j, int most) const {
  const VertexId a = triangulation_.vertex(c, i);
  const VertexId b = triangulation_.vertex(c, j);
  int off = 0;  // a facet at the edge is opposite another vertex
  while (off == i || off == j) ++off;
  int changes = 0;
  std::uint8_t before = out_[c];
  const FacetId first = facet_id(c, off);
  FacetId f = first;
  do {
    f = next_facet_around_edge(triangulation_, f, a, b);
    const std::uint8_t here = out_[cell_of(f)];
    changes += here != before ? 1 : 0;
    before = here;
  } while (f != first && changes < 2 * most - 1);  // they come in pairs
  return (changes + 1) / 2;
}

// What it costs that an edge with so many sheets gets more, or less.
Energy CellEnergy::edge_change(int sheets, int more) const {
  const int after = sheets + more;
  const Energy extra_sheets = std::max(after - 1, 0) - std::max(sheets - 1, 0);
  const Energy edges = (after > 0 ? 1 : 0) - (sheets > 0 ? 1 : 0);
  return defect_cost_ * extra_sheets + half_handle_cost_ * edges;
}

// An edge with n sheets divides the stars of its ends into at least n + 1 parts (the link of a
// vertex is a sphere, on which the surface draws a graph): so mostly there is none, or one that is
// seen.
CellEnergy::Place CellEnergy::place_of(CellId c) {
  Place place{};
  place.change = out_[c] != 0 ? -preference(c) : preference(c);
  std::array<std::size_t, 4> parts;
  for (int i = 0; i < 4; ++i) {
    parts[at(i)] = parts_now(triangulation_.vertex(c, i));
    place.surface[at(i)] = out_[triangulation_.neighbor(c, i)] != out_[c];
    const Energy more = facet_cost(facet_id(c, i)) - half_handle_cost_;
    place.change += place.surface[at(i)] ? -more : more;
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const auto [k, l] = others(i, j);
      const bool on_surface = place.surface[at(k)] || place.surface[at(l)];
      const int most = static_cast<int>(std::min(parts[at(i)], parts[at(j)])) - 1;
      const bool is_known = most == 0 || (most == 1 && on_surface);
      const int sheets = is_known ? most : sheets_at(c, i, j, most);
      place.sheets[edge_number[i][j]] = sheets;
      if (place.surface[at(k)] != place.surface[at(l)]) continue;  // the surface only turns there
      place.change += edge_change(sheets, place.surface[at(k)] ? -1 : 1);
    }
  }
  return place;
}

// Remembered until cells at two of its corners change sides for good: those with one corner in
// common have no facet and no edge in common.
const CellEnergy::Place& CellEnergy::place_now(CellId c) {
  Place& place = places_now_[c];
  int changed = 0;
  for (const VertexId v : triangulation_.cell(c).vertices) {
    changed += at_[v].changed > place.state ? 1 : 0;
  }
  if (place.state == 0 || changed > 1) {
    place = place_of(c);
    place.state = state_;
  }
  return place;
}

// Remembers it until cells at the vertex change sides for good.
std::size_t CellEnergy::parts_now(VertexId v) {
  AtVertex& here = at_[v];
  if (here.parts_state == 0 || here.parts_state < here.changed) {
    const bool flawless = flawless_elsewhere_ && here.doubtful == 0 && here.changed == 0;
    here.parts = flawless ? 2 : static_cast<std::uint32_t>(parts_.count(v));
    here.parts_state = state_;
  }
  return here.parts;
}

// A pinched or unused vertex may come to lie on one disk, which costs least; an idle one be busy.
Energy CellEnergy::ask_least_vertex_change(VertexId v) {
  const Energy idle = idle_cost_ != 0 && is_idle(v) ? idle_cost_ : 0;
  AtVertex& here = at_[v];
  here.least = star_cost(v, 2) - star_cost(v, parts_now(v)) - idle;
  here.least_state = state_;
  return here.least;
}

// Without the vertices, of the cell of f and the one behind it, the first of which lies like that:
// the two flips in turn, but for the facet between them, which appears and goes again, and for its
// edges: there the second adds one sheet less than it would alone.
Energy CellEnergy::change_together(const Place& first, FacetId f) {
  const CellId c = cell_of(f);
  const CellId d = cell_of(triangulation_.mirror(f));
  const Place& second = place_now(d);
  Energy total = first.change + second.change - 2 * (facet_cost(f) - half_handle_cost_);
  for (int r = 0; r < 4; ++r) {
    if (r == index_of(f)) continue;
    // The edge of the facet that is not at the corner r.
    const auto [p, q] = others(index_of(f), r);
    const int there = index_of_vertex(triangulation_.cell(d), triangulation_.vertex(c, r));
    const int sheets = first.sheets[edge_number[p][q]];
    const int by_first = first.surface[at(r)] ? 0 : 1;
    const int by_second = second.surface[at(there)] ? 0 : 1;
    total += edge_change(sheets, by_first + by_second - 1) - edge_change(sheets, by_first) -
             edge_change(sheets, by_second);
  }
  return total;
}

// What the facets between these cells and others cost once they appear or go. Each takes half a
// sheet at its three edges along; before the edges are looked at, each half counts as little as it
// can: a sheet that comes costs an edge or a defect, one that goes saves one of them.
Energy CellEnergy::least_change(std::span<const CellId> cells, Energy limit) {
  list_boundary(cells);
  const Energy least_of_coming = 3 * std::min(half_handle_cost_, defect_cost_) / 2;
  const Energy most_of_going = 3 * std::max(half_handle_cost_, defect_cost_) / 2;
  Energy total = boundary_change(cells);
  Energy edges = 0;
  for (const FacetId f : boundary_) edges += is_on_surface(f) ? -most_of_going : least_of_coming;
  list_vertices(cells);
  for (const VertexId v : vertices_) total += least_vertex_change(v);
  return total + edges > limit ? total + edges : total + edge_changes();
}

// Of the cells and of the listed boundary.
Energy CellEnergy::boundary_change(std::span<const CellId> cells) {
  Energy total = 0;
  for (const CellId c : cells) total += out_[c] != 0 ? -preference(c) : preference(c);
  for (const FacetId f : boundary_) {
    const Energy more = facet_cost(f) - half_handle_cost_;
    total += is_on_surface(f) ? -more : more;
  }
  return total;
}

void CellEnergy::list_boundary(std::span<const CellId> cells) {
  for (const CellId c : cells) taken_[c] = 1;
  boundary_.clear();
  for (const CellId c : cells) {
    for (int i = 0; i < 4; ++i) {
      if (taken_[triangulation_.neighbor(c, i)] == 0) boundary_.push_back(facet_id(c, i));
    }
  }
  for (const CellId c : cells) taken_[c] = 0;
}

// At the edges of the listed boundary.
Energy CellEnergy::edge_changes() {
  facets_at_edges_.clear();
  for (const FacetId f : boundary_) {
    const CellId c = cell_of(f);
    const Place& place = place_now(c);
    const int more = is_on_surface(f) ? -1 : 1;
    for (int r = 0; r < 4; ++r) {
      if (r == index_of(f)) continue;
      const auto [p, q] = others(index_of(f), r);
      const VertexId a = triangulation_.vertex(c, p);
      const VertexId b = triangulation_.vertex(c, q);
      facets_at_edges_.push_back(
          {{std::min(a, b), std::max(a, b)}, place.sheets[edge_number[p][q]], more});
    }
  }
  std::sort(facets_at_edges_.begin(), facets_at_edges_.end(),
            [](const FacetAtEdge& a, const FacetAtEdge& b) { return a.edge < b.edge; });
  Energy total = 0;
  for (std::size_t k = 0; k < facets_at_edges_.size();) {
    const FacetAtEdge& first = facets_at_edges_[k];
    int more = 0;
    for (; k < facets_at_edges_.size() && facets_at_edges_[k].edge == first.edge; ++k) {
      more += facets_at_edges_[k].more;
    }
    total += edge_change(first.sheets, more / 2);
  }
  return total;
}

// Each once, in no particular order.
void CellEnergy::list_vertices(std::span<const CellId> cells) {
  vertices_.clear();
  for (const CellId c : cells) {
    for (const VertexId v : triangulation_.cell(c).vertices) {
      if (listed_[v] != 0) continue;
      listed_[v] = 1;
      vertices_.push_back(v);
    }
  }
  for (const VertexId v : vertices_) listed_[v] = 0;
}

bool CellEnergy::is_at_surface(CellId c) const {
  for (int i = 0; i < 4; ++i) {
    if (is_on_surface(facet_id(c, i))) return true;
  }
  return false;
}

// Remembers it until cells at the vertex change sides for good.
bool CellEnergy::is_idle(VertexId v) {
  std::uint32_t& known = at_[v].idle;
  if (!knows_idle(v)) known = 2 * state_ + (would_be_idle(v) ? 1 : 0);
  return known % 2 != 0;
}

void CellEnergy::ask_idle(std::span<const VertexId> samples, const Execution& execution) {
  std::vector<VertexId> asked;
  for (const VertexId v : samples) {
    if (!knows_idle(v)) asked.push_back(v);
  }
  visit_stars_in_parallel(triangulation_, stars_, asked, execution,
                          [&](VertexId v) { is_idle(v); });
}

// By their boundary and their vertices: the facets and edges between them stay what they are. First
// as little as the vertices can cost; then what they do cost, large stars last.
Energy CellEnergy::change(std::span<const CellId> cells, Energy limit) {
  list_boundary(cells);
  list_vertices(cells);
  Energy total = boundary_change(cells) + edge_changes();
  for (const VertexId v : vertices_) total += least_vertex_change(v);
  if (total > limit) return total;
  turn(cells);
  for (const VertexId v : vertices_) {
    if (total > limit || parts_.is_large(v)) continue;
    total += star_cost(v, parts_.count(v)) - star_cost(v, 2);
  }
  turn(cells);
  for (const VertexId v : vertices_) {
    if (total > limit || !parts_.is_large(v)) continue;
    total += star_cost(v, parts_.count_after(v, cells, parts_now(v))) - star_cost(v, 2);
  }
  turn(cells);
  for (const VertexId v : vertices_) {
    if (idle_cost_ == 0 || total > limit) break;
    total += would_be_idle(v) ? idle_cost_ : 0;
  }
  turn(cells);
  return total;
}

// What it costs at a vertex that the surface divides its star into so many parts.
Energy CellEnergy::star_cost(VertexId v, std::size_t parts) const {
  return defect_cost_ * static_cast<Energy>(extra(parts, 2)) + (parts > 1 ? cost_of_use(v) : 0);
}

void CellEnergy::turn(std::span<const CellId> cells) {
  for (const CellId c : cells) out_[c] ^= 1U;
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
  turn(cells);
  for (const CellId c : cells) {
    for (const VertexId v : triangulation_.cell(c).vertices) at_[v].changed = state_;
  }
}

}  // namespace cocoon
