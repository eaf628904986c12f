#include "cocone/dynamic_tight_cocone.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cocone/certified_surface.h"
#include "cocone/live_candidates.h"
#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/id_vector.h"
#include "geom/large_pages.h"
#include "geom/triangle_order.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// Smallest vertex first, and sorted: as canonicalize_triangles, but in proportion to the list.
void canonicalize(std::vector<Triangle>& triangles) {
  for (Triangle& t : triangles) t = smallest_first(t);
  std::sort(triangles.begin(), triangles.end());
}

// What is known by slot, by number.
template <class IdType, class T>
IdVector<IdType, T> by_number(const IdVector<IdType, T>& by_slot,
                              const IdVector<IdType, IdType>& number, std::size_t count) {
  IdVector<IdType, T> values(count);
  for (const IdType slot : number.ids()) {
    if (!number[slot].is_none()) values[number[slot]] = by_slot[slot];
  }
  return values;
}

std::vector<KnownTriangle> triangles_of(const KnownTriangleSource& source) {
  return source ? source() : std::vector<KnownTriangle>();
}

}  // namespace

struct DynamicTightCocone::State {
  ReconstructOptions options;
  std::size_t num_points = 0;
  std::size_t local_changes = 0;
  DynamicDelaunay delaunay;                     // empty while points are of extreme size
  IdVector<PointId, VertexId> vertex_of_point;  // in it
  LiveCandidates candidates;
  CertifiedSurface certified;
  // If that exists: its triangles by mesh vertices, in canonical order, and the vertices.
  std::vector<Triangle> triangles;
  IdVector<VertexId, VertexId> vertex_of_mesh;

  bool is_live() const { return delaunay.num_vertices() > 0; }
  void take(std::size_t count, Triangulation triangulation);
  void take(const ReconstructResult& result, ReconstructStages stages);
  // The live cells and vertices, in the order of their slots, finite cells first.
  struct Compact {
    Triangulation triangulation;
    IdVector<VertexId, VertexId> vertex;  // by slot
    IdVector<CellId, CellId> cell;        // by slot
  };
  Compact compact() const;
  SurfaceState surface_state(const Compact& whole) const;
  void resume(SurfaceState surface);
  void list_surface();
  void look_for_certificate(const ReconstructResult& result, std::span<const FacetId> halves);
  KnownCandidates known_candidates(const Compact& compact) const;
  ReconstructResult run_later_stages(Points points, std::span<const KnownTriangle> known,
                                     const Execution& execution);
  void clear(std::size_t count);
  void forget_surface();
  // What a change of the triangulation does to the points, and how to take it back.
  struct Step {
    std::vector<VertexId> removed;
    std::vector<Point> removed_points;
    std::vector<PointId> inserted;  // positions among the new points
    std::vector<Point> inserted_points;
    IdVector<PointId, VertexId> vertex_of_point;  // none: to be inserted
  };
  Step plan(Points points, std::span<const PointId> old_position) const;
  DelaunayChange change_triangulation(const Step& step, const Execution& execution);
  void undo(const Step& step, const DelaunayChange& change,
            IdVector<PointId, VertexId> vertex_of_point);
  ReconstructResult run_stages(Points points, std::span<const KnownTriangle> known,
                               const Execution& execution);
  ReconstructResult assemble(Points points);
  void replace_triangles(const IdVector<VertexId, VertexId>& number,
                         const std::vector<Triangle>& fresh);
  IdVector<VertexId, VertexId> kept_vertices(const IdVector<VertexId, VertexId>& number) const;
};

void DynamicTightCocone::State::take(std::size_t count, Triangulation triangulation) {
  num_points = count;
  vertex_of_point = triangulation.vertex_of_point();
  forget_surface();
  delaunay = DynamicDelaunay(std::move(triangulation));
}

// With what the stages found.
void DynamicTightCocone::State::take(const ReconstructResult& result, ReconstructStages stages) {
  take(result.points, std::move(stages.triangulation));
  candidates.start(delaunay, stages);
  look_for_certificate(result, stages.halves);
}

// Where the counts leave hope.
void DynamicTightCocone::State::look_for_certificate(const ReconstructResult& result,
                                                     std::span<const FacetId> halves) {
  const ReconstructCounters& counters = result.counters;
  const bool hopeful = result.status == SurfaceStatus::ok && result.unused_points == 0 &&
                       counters.surface_walks == 1 && counters.back_contacts == 0 &&
                       counters.good_vertices == result.vertices;
  if (!hopeful || !certified.certify(delaunay, candidates, halves)) return;
  triangles = result.mesh.triangles.raw();
  vertex_of_mesh.clear();
  for (const PointId p : result.point_of_vertex) vertex_of_mesh.push_back(vertex_of_point[p]);
}

void DynamicTightCocone::State::clear(std::size_t count) {
  num_points = count;
  vertex_of_point = {};
  forget_surface();
  delaunay = DynamicDelaunay();
}

void DynamicTightCocone::State::forget_surface() {
  candidates.clear();
  certified.clear();
}

DynamicTightCocone::State::Step DynamicTightCocone::State::plan(
    Points points, std::span<const PointId> old_position) const {
  Step step;
  step.vertex_of_point.resize(points.size());
  std::vector<std::uint8_t> stays(delaunay.num_vertex_slots(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (old_position[i].is_none()) {
      step.inserted.push_back(PointId(i));
      step.inserted_points.push_back(points[i]);
    } else {
      const VertexId v = vertex_of_point[old_position[i]];
      step.vertex_of_point[PointId(i)] = v;
      stays[v.index()] = 1;
    }
  }
  for (const VertexId v : vertex_of_point) {
    if (stays[v.index()] != 0) continue;
    stays[v.index()] = 1;  // listed once
    step.removed.push_back(v);
    step.removed_points.push_back(delaunay.point(v));
  }
  return step;
}

// If it throws the points are as before, but cells may have other numbers.
DelaunayChange DynamicTightCocone::State::change_triangulation(const Step& step,
                                                               const Execution& execution) {
  try {
    return delaunay.replace(step.removed, step.inserted_points, execution);
  } catch (...) {
    forget_surface();
    throw;
  }
}

// After a change that was done: the points from before come back. Those that were removed may get
// other vertices than they had.
void DynamicTightCocone::State::undo(const Step& step, const DelaunayChange& change,
                                     IdVector<PointId, VertexId> before) {
  forget_surface();
  const DelaunayChange back = delaunay.replace(change.inserted, step.removed_points);
  IdVector<VertexId, VertexId> again;
  for (const VertexId v : before) {
    if (v.index() >= again.size()) again.resize(v.index() + 1);
  }
  for (std::size_t k = 0; k < step.removed.size(); ++k) {
    again[step.removed[k]] = back.vertex_of_point[k];
  }
  for (VertexId& v : before) {
    if (!again[v].is_none()) v = again[v];
  }
  vertex_of_point = std::move(before);
}

DynamicTightCocone::State::Compact DynamicTightCocone::State::compact() const {
  const TriangulationView view = delaunay.view();
  TriangulationArrays arrays;
  IdVector<VertexId, VertexId> number(delaunay.num_vertex_slots());
  for (const VertexId v : number.ids()) {
    if (delaunay.contains(v)) number[v] = arrays.points.push_back(view.point(v));
  }
  IdVector<CellId, CellId> place(view.cell_records().size());
  std::size_t count = 0;
  for (const CellId c : place.ids()) {
    if (view.is_finite_cell(c)) place[c] = CellId(count++);
  }
  const std::size_t finite_cells = count;
  for (const CellId c : place.ids()) {
    if (!view.is_free(c) && view.is_infinite(c)) place[c] = CellId(count++);
  }
  arrays.cells.resize(count);
  for (const CellId c : place.ids()) {
    if (place[c].is_none()) continue;
    Cell cell = view.cell(c);
    for (VertexId& v : cell.vertices) v = v == infinite_vertex ? v : number[v];
    for (FacetId& f : cell.neighbors) f = facet_id(place[cell_of(f)], index_of(f));
    arrays.cells[place[c]] = cell;
  }
  arrays.vertex_of_point.reserve(vertex_of_point.size());
  for (const VertexId v : vertex_of_point) arrays.vertex_of_point.push_back(number[v]);
  return {Triangulation(std::move(arrays), finite_cells), std::move(number), std::move(place)};
}

// All stages after the triangulation.
ReconstructResult DynamicTightCocone::State::run_stages(Points points,
                                                        std::span<const KnownTriangle> known,
                                                        const Execution& execution) {
  if (candidates.exists()) return run_later_stages(points, known, execution);
  ReconstructStages stages;
  ReconstructResult result =
      reconstruct_tight_again(compact().triangulation, points, known, options, execution, stages);
  take(result, std::move(stages));
  return result;
}

KnownCandidates DynamicTightCocone::State::known_candidates(const Compact& whole) const {
  KnownCandidates found;
  const std::size_t count = whole.triangulation.num_vertices();
  found.normals.resize(count);
  found.boundary.resize(count, 0);
  found.umbrella.resize(count, 0);
  for (const VertexId v : whole.vertex.ids()) {
    const VertexId here = whole.vertex[v];
    if (here.is_none()) continue;
    found.normals[here] = candidates.normal(v);
    found.boundary[here] = candidates.is_boundary(v) ? 1 : 0;
    found.umbrella[here] = candidates.has_umbrella(v) ? 1 : 0;
  }
  IdVector<CellId, std::uint8_t> left(whole.triangulation.num_cells(), 0);
  for (const CellId c : whole.cell.ids()) {
    if (whole.cell[c].is_none()) continue;
    left[whole.cell[c]] = static_cast<std::uint8_t>(candidates.left(c));
  }
  found.left = FacetSet(std::move(left));
  candidates.count(found.counters);
  return found;
}

// In the numbers of a compact triangulation.
SurfaceState DynamicTightCocone::State::surface_state(const Compact& whole) const {
  SurfaceState state;
  if (!candidates.exists()) return state;
  const CandidateState& known = candidates.state();
  const std::size_t vertices = whole.triangulation.num_vertices();
  const std::size_t cells = whole.triangulation.num_cells();
  CandidateState& here = state.candidates;
  here.normals = by_number(known.normals, whole.vertex, vertices);
  here.vertex_flags = by_number(known.vertex_flags, whole.vertex, vertices);
  here.samples = by_number(known.samples, whole.vertex, vertices);
  here.steps = by_number(known.steps, whole.vertex, vertices);
  here.cell_flags = by_number(known.cell_flags, whole.cell, cells);
  here.pruned = by_number(known.pruned, whole.cell, cells);
  if (certified.exists()) state.sides = by_number(certified.sides(), whole.cell, cells);
  return state;
}

void DynamicTightCocone::State::resume(SurfaceState surface) {
  if (surface.empty()) return;
  candidates.resume(delaunay, std::move(surface.candidates));
  if (surface.sides.empty()) return;
  certified.resume(delaunay, std::move(surface.sides));
  list_surface();
}

// The certified surface as a mesh; it has all vertices. Complexity: O(n).
void DynamicTightCocone::State::list_surface() {
  IdVector<VertexId, VertexId> number(delaunay.num_vertex_slots());
  vertex_of_mesh.clear();
  for (const VertexId v : vertex_of_point) {
    if (number[v].is_none()) number[v] = vertex_of_mesh.push_back(v);
  }
  TriangleMesh mesh;
  mesh.points.resize(vertex_of_mesh.size());
  for (const auto& [a, b, c] : certified.triangles(delaunay.view())) {
    mesh.triangles.push_back({number[a], number[b], number[c]});
  }
  canonicalize_triangles(mesh);
  triangles = std::move(mesh.triangles.raw());
}

// Those from the extraction on, of the candidates that are known.
ReconstructResult DynamicTightCocone::State::run_later_stages(Points points,
                                                              std::span<const KnownTriangle> known,
                                                              const Execution& execution) {
  Compact whole = compact();
  KnownCandidates found = known_candidates(whole);
  std::vector<FacetId> halves;
  ReconstructResult result = reconstruct_tight_from(
      std::move(whole.triangulation), std::move(found), points, known, options, execution, halves);
  IdVector<CellId, CellId> slot(whole.cell.size());
  for (const CellId c : whole.cell.ids()) {
    if (!whole.cell[c].is_none()) slot[whole.cell[c]] = c;
  }
  for (FacetId& f : halves) f = facet_id(slot[cell_of(f)], index_of(f));
  look_for_certificate(result, halves);
  return result;
}

// The vertices of the mesh so far that were not touched, in new numbers.
IdVector<VertexId, VertexId> DynamicTightCocone::State::kept_vertices(
    const IdVector<VertexId, VertexId>& number) const {
  IdVector<VertexId, VertexId> after(vertex_of_mesh.size());
  VertexSet touched(number.size(), 0);
  for (const VertexId v : certified.touched()) touched[v] = 1;
  for (const VertexId m : after.ids()) {
    const VertexId v = vertex_of_mesh[m];
    if (v.index() < number.size() && touched[v] == 0) after[m] = number[v];
  }
  return after;
}

// Triangles without a touched vertex stay, those at touched vertices are the fresh ones. In
// canonical order, as long as the vertices that stay keep theirs; else everything is sorted.
void DynamicTightCocone::State::replace_triangles(const IdVector<VertexId, VertexId>& number,
                                                  const std::vector<Triangle>& fresh) {
  const IdVector<VertexId, VertexId> after = kept_vertices(number);
  std::vector<Triangle> merged;
  merged.reserve(triangles.size() + fresh.size());
  prefer_large_pages(merged);
  auto next = fresh.begin();
  Triangle last = lowest_triangle;
  bool sorted = true;
  for (const Triangle& t : triangles) {
    const Triangle mapped{after[t[0]], after[t[1]], after[t[2]]};
    if (mapped[0].is_none() || mapped[1].is_none() || mapped[2].is_none()) continue;
    sorted = sorted && precedes(last, mapped) && mapped[0] < mapped[1] && mapped[0] < mapped[2];
    last = mapped;
    for (; next != fresh.end() && precedes(*next, mapped); ++next) merged.push_back(*next);
    merged.push_back(mapped);
  }
  merged.insert(merged.end(), next, fresh.end());
  if (!sorted) canonicalize(merged);
  triangles = std::move(merged);
}

// The result from what is certified. Complexity: one pass over points and triangles, and sorting
// what is new.
ReconstructResult DynamicTightCocone::State::assemble(Points points) {
  ReconstructResult result;
  IdVector<VertexId, VertexId> number(delaunay.num_vertex_slots());
  IdVector<VertexId, VertexId> vertices;
  const std::size_t count = delaunay.num_vertices();
  vertices.reserve(count);
  result.mesh.points.reserve(count);
  result.point_of_vertex.reserve(count);
  result.normals.reserve(count);
  prefer_large_pages(result.mesh.points.raw());
  prefer_large_pages(result.normals.raw());
  constexpr std::size_t ahead = 16;  // points come in any order: what they need is asked for early
  for (const PointId p : vertex_of_point.ids()) {
    if (p.index() + ahead < points.size()) {
      const VertexId soon = vertex_of_point[PointId(p.index() + ahead)];
      __builtin_prefetch(&number[soon]);
      __builtin_prefetch(&candidates.normal(soon));
    }
    const VertexId v = vertex_of_point[p];
    if (!number[v].is_none()) continue;
    number[v] = result.mesh.points.push_back(points[p.index()]);
    vertices.push_back(v);
    result.point_of_vertex.push_back(p);
    result.normals.push_back(candidates.normal(v));
  }
  std::vector<Triangle> fresh;
  for (const auto& [a, b, c] : certified.triangles_at_touched()) {
    fresh.push_back({number[a], number[b], number[c]});
  }
  canonicalize(fresh);
  replace_triangles(number, fresh);
  vertex_of_mesh = std::move(vertices);
  result.mesh.triangles = IdVector<TriangleId, Triangle>(triangles);
  result.boundary_sample.resize(vertex_of_mesh.size(), 0);
  result.points = points.size();
  result.duplicates = points.size() - vertex_of_mesh.size();
  result.vertices = delaunay.num_vertices();
  result.tetrahedra = candidates.num_finite_cells();
  candidates.count(result.counters);
  certified.count(result.counters);
  return result;
}

DynamicTightCocone::DynamicTightCocone(const ReconstructOptions& options)
    : state_(std::make_unique<State>()) {
  state_->options = options;
  state_->certified = CertifiedSurface(effective_options(options).good_vertices);
  state_->candidates = LiveCandidates(effective_options(options));
}
DynamicTightCocone::~DynamicTightCocone() = default;
DynamicTightCocone::DynamicTightCocone(DynamicTightCocone&&) noexcept = default;
DynamicTightCocone& DynamicTightCocone::operator=(DynamicTightCocone&&) noexcept = default;

const ReconstructOptions& DynamicTightCocone::options() const { return state_->options; }
std::size_t DynamicTightCocone::num_points() const { return state_->num_points; }
std::size_t DynamicTightCocone::local_changes() const { return state_->local_changes; }

void DynamicTightCocone::take(Points points, Snapshot snapshot) {
  if (working_scale(points) != 1) {
    state_->clear(points.size());
    return;
  }
  state_->take(points.size(), std::move(snapshot.triangulation));
  state_->resume(std::move(snapshot.surface));
}

DynamicTightCocone::Snapshot DynamicTightCocone::snapshot() const {
  State::Compact whole = state_->compact();
  SurfaceState surface = state_->surface_state(whole);
  return {std::move(whole.triangulation), std::move(surface)};
}

ReconstructResult DynamicTightCocone::reconstruct(Points points, const Execution& execution,
                                                  const KnownTriangleSource& known) {
  if (working_scale(points) != 1) {
    ReconstructResult result =
        reconstruct_tight_again(points, triangles_of(known), state_->options, execution);
    state_->clear(points.size());
    return result;
  }
  DelaunayResult built = delaunay(points, state_->options.delaunay, execution);
  ReconstructStages stages;
  ReconstructResult result =
      reconstruct_tight_again(std::move(built.triangulation), points, triangles_of(known),
                              state_->options, execution, stages);
  result.counters.delaunay = built.counters;
  state_->take(result, std::move(stages));
  return result;
}

ReconstructResult DynamicTightCocone::replace(Points points, std::span<const PointId> old_position,
                                              const Execution& execution,
                                              const KnownTriangleSource& known) {
  State& state = *state_;
  if (!state.is_live() || working_scale(points) != 1) return reconstruct(points, execution, known);
  State::Step step = state.plan(points, old_position);
  const DelaunayChange change = state.change_triangulation(step, execution);
  for (std::size_t k = 0; k < step.inserted.size(); ++k) {
    step.vertex_of_point[step.inserted[k]] = change.vertex_of_point[k];
  }
  std::swap(state.vertex_of_point, step.vertex_of_point);
  // Where about half of the points come or go, looking at the whole takes less time.
  const bool is_local =
      2 * (change.inserted.size() + change.removed.size()) <= state.delaunay.num_vertices();
  if (!is_local) state.forget_surface();
  if (state.candidates.exists()) state.candidates.update(state.delaunay, change, execution);
  if (state.certified.exists()) state.certified.update(state.delaunay, change, state.candidates);
  // What is to be verified is computed as a whole.
  if (state.certified.exists() && !state.options.verify) {
    ReconstructResult result = state.assemble(points);
    result.counters.delaunay = change.insertion;
    state.num_points = points.size();
    ++state.local_changes;
    return result;
  }
  try {
    ReconstructResult result = state.run_stages(points, triangles_of(known), execution);
    result.counters.delaunay = change.insertion;
    state.num_points = points.size();
    return result;
  } catch (...) {
    state.undo(step, change, std::move(step.vertex_of_point));
    throw;
  }
}

}  // namespace cocoon
