#include "delaunay/dynamic_delaunay.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "delaunay/circulate.h"
#include "delaunay/kernel/cavity.h"
#include "delaunay/kernel/cell_pool.h"
#include "delaunay/kernel/first_cells.h"
#include "delaunay/kernel/insertion_order.h"
#include "delaunay/require_points.h"
#include "geom/arrays/room_to_grow.h"
#include "geom/arrays/sort_ids.h"
#include "geom/errors.h"
#include "geom/spatial_order.h"

namespace cocoon {
namespace {

constexpr std::size_t progress_interval = std::size_t{1} << 12;

}  // namespace

// The triangulation, and the scratch memory of its operations.
struct DynamicDelaunay::State {
  IdVector<VertexId, Point> points{1};  // the last element is no vertex: the kernel reads there
  IdVector<VertexId, CellId> cell_at;   // a cell at each vertex, none for free ids
  std::vector<VertexId> free_vertices;
  std::size_t num_vertices = 0;
  CellPool pool;
  CellId last_created;                          // live, unless empty
  std::optional<std::size_t> finite_cells = 0;  // that come first; none after a change
  CavityInserter inserter{pool, points};
  VertexRemover remover{pool, points};

  // The journal of the current operation.
  IdVector<CellId, std::uint8_t> is_touched;
  std::vector<CellId> touched;  // slots that were written
  std::vector<CellId> deleted;  // those of them that held a cell before

  void adopt(Triangulation triangulation);
  void require_vertices(std::span<const VertexId> vertices) const;

  void note_corners(CellId c);

  void begin_journal();
  void touch(std::span<const CellId> gone, std::span<const CellId> fresh);
  void update_cells_at_vertices();
  void write_journal(DelaunayChange& change);

  CellId start_near(const Point& p) const;
  VertexId vertex_at(CellId c, const Point& p) const;
  VertexId take_vertex(const Point& p);
  CellId insert_vertex(VertexId v, CellId start, DelaunayCounters& counters);
  void insert_points(Points given, const Execution& execution, DelaunayChange& change);
  bool plan_removal(std::span<const VertexId> vertices) { return remover.plan(vertices, cell_at); }
  void commit_removal(std::span<const VertexId> vertices, DelaunayChange& change);
  void undo(DelaunayChange& change);
  bool remove_inserted(DelaunayChange& change);

  void follow(const CellExchange& exchange);
  void rename(VertexId from, VertexId to);

  void rebuild(Points given, const Execution& execution, DelaunayChange& change);
  void remove_then_insert(Points given, const Execution& execution, DelaunayChange& change);
  void insert_then_remove(Points given, const Execution& execution, DelaunayChange& change);
};

// --- The whole -------------------------------------------------------------------------------

void DynamicDelaunay::State::adopt(Triangulation triangulation) {
  finite_cells = triangulation.num_finite_cells();
  TriangulationArrays arrays = std::move(triangulation).release();
  num_vertices = arrays.points.size();
  points = std::move(arrays.points);
  points.push_back({});
  pool.cells = std::move(arrays.cells);
  pool.marks.clear();
  pool.marks.reserve(with_room_to_grow(pool.cells.size()));
  pool.marks.resize(pool.cells.size(), CellMark::untested);
  pool.free.clear();
  free_vertices.clear();
  cell_at.clear();
  cell_at.reserve(with_room_to_grow(num_vertices));
  cell_at.resize(num_vertices);
  for (const CellId c : pool.cells.ids()) note_corners(c);
  last_created = pool.cells.empty() ? CellId() : CellId(pool.cells.size() - 1);
  inserter.read_points_again();
}

// c is a cell at each of its vertices.
void DynamicDelaunay::State::note_corners(CellId c) {
  for (const VertexId v : pool.cells[c].vertices) {
    if (v != infinite_vertex) cell_at[v] = c;
  }
}

void DynamicDelaunay::State::require_vertices(std::span<const VertexId> vertices) const {
  for (const VertexId v : vertices) {
    if (v.index() < cell_at.size() && !cell_at[v].is_none()) continue;
    throw InputError("vertex " + std::to_string(v.value) +
                     " is not in the triangulation: it cannot be removed; remove vertices only "
                     "once, by the ids that insertion gave them");
  }
}

// --- Journal ---------------------------------------------------------------------------------

void DynamicDelaunay::State::begin_journal() {
  for (const CellId c : touched) is_touched[c] = 0;
  touched.clear();
  deleted.clear();
}

// Cells that are gone, or are to go, and new ones.
void DynamicDelaunay::State::touch(std::span<const CellId> gone, std::span<const CellId> fresh) {
  if (is_touched.size() < pool.cells.size()) is_touched.resize(pool.cells.size(), 0);
  for (const CellId c : gone) {
    if (std::exchange(is_touched[c], 1) != 0) continue;
    touched.push_back(c);
    deleted.push_back(c);
  }
  for (const CellId c : fresh) {
    if (std::exchange(is_touched[c], 1) == 0) touched.push_back(c);
  }
}

// A vertex whose cell was deleted is in one of the cells that came in its place.
void DynamicDelaunay::State::update_cells_at_vertices() {
  for (const CellId c : touched) {
    if (!pool.is_free(c)) note_corners(c);
  }
}

void DynamicDelaunay::State::write_journal(DelaunayChange& change) {
  change.deleted = deleted;
  for (const CellId c : touched) {
    if (!pool.is_free(c)) change.created.push_back(c);
  }
}

// --- Insertion -------------------------------------------------------------------------------

// A cell near p: of the last one created and a sample of the vertices, the nearest (jump and walk:
// Muecke, Saias & Zhu 1996). The square root of the square root of n vertices, since their stars
// are found without search.
CellId DynamicDelaunay::State::start_near(const Point& p) const {
  const std::size_t slots = cell_at.size();
  const auto samples =
      static_cast<std::size_t>(std::sqrt(std::sqrt(static_cast<double>(slots)))) + 1;
  CellId best = last_created;
  double nearest = squared_distance(points[pool.cells[best].vertices[0]], p);
  for (std::size_t i = 0; i < samples; ++i) {
    const VertexId v(i * slots / samples);
    if (cell_at[v].is_none()) continue;
    const double squared = squared_distance(points[v], p);
    if (!(squared < nearest)) continue;
    nearest = squared;
    best = cell_at[v];
  }
  return best;
}

// The vertex of c at p, none if there is none. A vertex at p is a vertex of every cell that
// contains p.
VertexId DynamicDelaunay::State::vertex_at(CellId c, const Point& p) const {
  for (const VertexId v : pool.cells[c].vertices) {
    if (v != infinite_vertex && points[v] == p) return v;
  }
  return {};
}

VertexId DynamicDelaunay::State::take_vertex(const Point& p) {
  VertexId v;
  if (!free_vertices.empty()) {
    v = free_vertices.back();
    free_vertices.pop_back();
  } else {
    v = VertexId(points.size() - 1);
    points.push_back({});
    cell_at.push_back({});
  }
  points[v] = p;
  inserter.admit(p);
  return v;
}

CellId DynamicDelaunay::State::insert_vertex(VertexId v, CellId start, DelaunayCounters& counters) {
  last_created = inserter.insert(v, start, counters);
  touch(inserter.removed_cells(), inserter.new_cells());
  cell_at[v] = last_created;
  ++num_vertices;
  return last_created;
}

void DynamicDelaunay::State::insert_points(Points given, const Execution& execution,
                                           DelaunayChange& change) {
  change.vertex_of_point.assign(given.size(), VertexId());
  const std::vector<std::uint32_t> order = insertion_order(given);
  CellId hint = order.empty() ? CellId() : start_near(given[order[0]]);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % progress_interval == 0) {
      report_progress(execution, "delaunay",
                      static_cast<double>(i) / static_cast<double>(order.size()));
    }
    const Point& p = given[order[i]];
    const CellId start = inserter.find_start(p, hint, change.insertion);
    VertexId v = vertex_at(start, p);
    if (v.is_none()) {
      v = take_vertex(p);
      change.inserted.push_back(v);
      hint = insert_vertex(v, start, change.insertion);
    } else {
      hint = start;
      ++change.duplicates;
    }
    change.vertex_of_point[order[i]] = v;
  }
  update_cells_at_vertices();
}

// --- Removal ---------------------------------------------------------------------------------

// Does what was planned. The ids become free at the end of the operation only, so that it can be
// undone.
void DynamicDelaunay::State::commit_removal(std::span<const VertexId> vertices,
                                            DelaunayChange& change) {
  remover.commit();
  touch(remover.deleted_cells(), remover.new_cells());
  for (const VertexId v : vertices) cell_at[v] = CellId();
  num_vertices -= vertices.size();
  last_created = remover.new_cells().back();
  update_cells_at_vertices();
  change.removal += remover.counters();
}

// Takes back insertions and removals so far. The triangulation is a function of the points, so
// this leads to the cells that were there before.
void DynamicDelaunay::State::undo(DelaunayChange& change) {
  update_cells_at_vertices();
  // Where removed points have come again the new vertices have to go first. Where what stays does
  // not span space without the removed ones, these have to come first: none has come again then.
  const bool took_back = remove_inserted(change);
  for (const VertexId v : change.removed) {
    if (!cell_at[v].is_none()) continue;
    insert_vertex(v, inserter.find_start(points[v], last_created, change.insertion),
                  change.insertion);
  }
  update_cells_at_vertices();
  if (!took_back) remove_inserted(change);
  free_vertices.insert(free_vertices.end(), change.inserted.rbegin(), change.inserted.rend());
}

// False, and nothing was done, if the others do not span space.
bool DynamicDelaunay::State::remove_inserted(DelaunayChange& change) {
  std::vector<VertexId> inserted;
  for (const VertexId v : change.inserted) {
    if (!cell_at[v].is_none()) inserted.push_back(v);
  }
  if (inserted.empty()) return true;
  if (!plan_removal(inserted)) return false;
  commit_removal(inserted, change);
  return true;
}

// --- Operations ------------------------------------------------------------------------------

void DynamicDelaunay::State::rebuild(Points given, const Execution& execution,
                                     DelaunayChange& change) {
  Triangulation fresh;
  if (!given.empty()) {
    DelaunayResult result = delaunay(given, {}, execution);
    change.insertion = result.counters;
    fresh = std::move(result.triangulation);
  }
  std::vector<CellId> gone;
  for (const CellId c : pool.cells.ids()) {
    if (!pool.is_free(c)) gone.push_back(c);
  }
  touch(gone, {});
  change.duplicates = fresh.num_duplicates();
  change.vertex_of_point = fresh.vertex_of_point().raw();
  for (const VertexId v : fresh.vertices()) change.inserted.push_back(v);
  adopt(std::move(fresh));
  change.deleted = deleted;
  for (const CellId c : pool.cells.ids()) change.created.push_back(c);
  begin_journal();
}

void DynamicDelaunay::State::remove_then_insert(Points given, const Execution& execution,
                                                DelaunayChange& change) {
  if (!change.removed.empty()) commit_removal(change.removed, change);
  insert_points(given, execution, change);
}

// For a removal that is possible only once the new points are there. Vertices to be removed that
// are among the new points stay.
void DynamicDelaunay::State::insert_then_remove(Points given, const Execution& execution,
                                                DelaunayChange& change) {
  insert_points(given, execution, change);
  std::vector<VertexId> kept = change.vertex_of_point;
  std::sort(kept.begin(), kept.end());
  std::vector<VertexId> removed;
  std::set_difference(change.removed.begin(), change.removed.end(), kept.begin(), kept.end(),
                      std::back_inserter(removed));
  if (removed.empty()) {
    change.removed.clear();
    return;
  }
  if (!plan_removal(removed)) {
    throw DegenerateInput(
        "the " + std::to_string(num_vertices - removed.size()) +
        " points that would remain do not span space: keep at least 4 that are not "
        "in one plane, or remove all");
  }
  commit_removal(removed, change);
  change.removed = std::move(removed);
}

DelaunayChange DynamicDelaunay::replace(std::span<const VertexId> vertices, Points points,
                                        const Execution& execution) {
  State& state = *state_;
  require_finite(points);
  state.require_vertices(vertices);
  require_ids(state.points.size() + points.size());
  DelaunayChange change;
  change.removed.assign(vertices.begin(), vertices.end());
  make_set(change.removed);
  report_progress(execution, "delaunay", 0);
  state.begin_journal();
  state.finite_cells.reset();
  if (change.removed.size() == state.num_vertices) {
    state.rebuild(points, execution, change);
    return change;
  }
  try {
    if (change.removed.empty() || state.plan_removal(change.removed)) {
      state.remove_then_insert(points, execution, change);
    } else {
      state.insert_then_remove(points, execution, change);
    }
    report_progress(execution, "delaunay", 1);
  } catch (...) {
    state.undo(change);
    throw;
  }
  state.free_vertices.insert(state.free_vertices.end(), change.removed.rbegin(),
                             change.removed.rend());
  state.write_journal(change);
  return change;
}

DelaunayChange DynamicDelaunay::insert(Points points, const Execution& execution) {
  return replace({}, points, execution);
}

DelaunayChange DynamicDelaunay::remove(std::span<const VertexId> vertices,
                                       const Execution& execution) {
  return replace(vertices, {}, execution);
}

// --- Reading ---------------------------------------------------------------------------------

DynamicDelaunay::DynamicDelaunay() : state_(std::make_unique<State>()) {}
DynamicDelaunay::DynamicDelaunay(Triangulation triangulation) : DynamicDelaunay() {
  state_->adopt(std::move(triangulation));
}
DynamicDelaunay::~DynamicDelaunay() = default;
DynamicDelaunay::DynamicDelaunay(DynamicDelaunay&&) noexcept = default;
DynamicDelaunay& DynamicDelaunay::operator=(DynamicDelaunay&&) noexcept = default;

std::size_t DynamicDelaunay::num_vertices() const { return state_->num_vertices; }
std::size_t DynamicDelaunay::num_vertex_slots() const { return state_->cell_at.size(); }
bool DynamicDelaunay::contains(VertexId v) const {
  return v.index() < state_->cell_at.size() && !state_->cell_at[v].is_none();
}
const Point& DynamicDelaunay::point(VertexId v) const { return state_->points[v]; }
CellId DynamicDelaunay::cell_at(VertexId v) const { return state_->cell_at[v]; }
const IdVector<VertexId, CellId>& DynamicDelaunay::cells_at_vertices() const {
  return state_->cell_at;
}
TriangulationView DynamicDelaunay::view() const { return {state_->points, state_->pool.cells}; }

DynamicDelaunay::Elements DynamicDelaunay::release() && {
  Elements elements{std::move(state_->points), std::move(state_->pool.cells)};
  *this = DynamicDelaunay();
  return elements;
}

// --- Without gaps ----------------------------------------------------------------------------

void DynamicDelaunay::State::follow(const CellExchange& exchange) {
  for (const CellId c : {exchange.a, exchange.b}) {
    if (c.index() < pool.cells.size()) note_corners(c);
  }
}

// Precondition: no cell is free; `to` is.
void DynamicDelaunay::State::rename(VertexId from, VertexId to) {
  std::vector<CellId> star{cell_at[from]};
  const auto take = [&](CellId c) {
    Cell& cell = pool.cells[c];
    cell.vertices[static_cast<std::size_t>(index_of_vertex(cell, from))] = to;
  };
  take(star[0]);
  for (std::size_t next = 0; next < star.size(); ++next) {
    for (const FacetId f : pool.cells[star[next]].neighbors) {
      if (!has_vertex(pool.cells[cell_of(f)], from)) continue;
      take(cell_of(f));
      star.push_back(cell_of(f));
    }
  }
  points[to] = points[from];
  cell_at[to] = cell_at[from];
}

Renumbering DynamicDelaunay::close_gaps() {
  State& state = *state_;
  state.begin_journal();
  Renumbering renumbering;
  state.finite_cells = compact_cells(state.pool, {}, &renumbering.cells);
  for (const CellExchange& exchange : renumbering.cells) state.follow(exchange);
  std::sort(state.free_vertices.begin(), state.free_vertices.end());
  auto hole = state.free_vertices.begin();
  for (VertexId v(state.num_vertices); v.index() < state.cell_at.size(); ++v) {
    if (state.cell_at[v].is_none()) continue;
    state.rename(v, *hole);
    renumbering.vertices.push_back({v, *hole++});
  }
  state.free_vertices.clear();
  state.cell_at.resize(state.num_vertices);
  state.points.resize(state.num_vertices);
  state.points.push_back({});
  if (state.num_vertices > 0) state.last_created = CellId(state.pool.cells.size() - 1);
  return renumbering;
}

Triangulation DynamicDelaunay::lend(IdVector<PointId, VertexId> vertex_of_point) {
  State& state = *state_;
  assert(state.finite_cells && state.free_vertices.empty());
  state.points.resize(state.num_vertices);
  return Triangulation(
      {std::move(state.points), std::move(state.pool.cells), std::move(vertex_of_point)},
      *state.finite_cells);
}

IdVector<PointId, VertexId> DynamicDelaunay::take_back(Triangulation triangulation) {
  TriangulationArrays arrays = std::move(triangulation).release();
  state_->points = std::move(arrays.points);
  state_->points.push_back({});  // there is room: it was there before
  state_->pool.cells = std::move(arrays.cells);
  return std::move(arrays.vertex_of_point);
}

FrozenDelaunay DynamicDelaunay::freeze() const {
  const State& state = *state_;
  std::vector<VertexId> live;
  std::vector<Point> points;
  for (const VertexId v : state.cell_at.ids()) {
    if (state.cell_at[v].is_none()) continue;
    live.push_back(v);
    points.push_back(state.points[v]);
  }

  // Number the vertices along the Hilbert curve.
  FrozenDelaunay result;
  result.frozen_vertex.resize(state.cell_at.size());
  TriangulationArrays arrays;
  arrays.vertex_of_point.resize(live.size());
  arrays.points.reserve(live.size());
  for (const PointId p : hilbert_order(points)) {
    const VertexId number = arrays.points.push_back(points[p.index()]);
    arrays.vertex_of_point[p] = number;
    result.frozen_vertex[live[p.index()]] = number;
  }

  CellPool pool = state.pool;
  const std::size_t finite_cells = compact_cells(pool);
  for (Cell& cell : pool.cells) {
    for (VertexId& v : cell.vertices) v = v == infinite_vertex ? v : result.frozen_vertex[v];
  }
  arrays.cells = std::move(pool.cells);
  result.triangulation = Triangulation(std::move(arrays), finite_cells);
  return result;
}

}  // namespace cocoon
