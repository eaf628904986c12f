#include "cocone/dynamic_tight_cocone.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

#include "cocone/kept/certain_result.h"
#include "cocone/kept/certified_surface.h"
#include "cocone/kept/kept_labels.h"
#include "cocone/kept/kept_stages.h"
#include "cocone/kept/kept_state.h"
#include "cocone/kept/points_at_vertices.h"
#include "cocone/live/judge_points.h"
#include "cocone/live/known_candidates.h"
#include "cocone/live/live_candidates.h"
#include "cocone/live/point_step.h"
#include "cocone/live/reconstruct_stages.h"
#include "cocone/steps/reconstruct_and_keep.h"
#include "cocone/steps/triangulate_points.h"
#include "delaunay/compact_delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/lent_delaunay.h"
#include "geom/arrays/sort_ids.h"
#include "geom/errors.h"
#include "geom/id_vector.h"
#include "geom/mesh/triangle_order.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// Whether the working scale of the points is 1, as that of those they were made of, by some that
// came. Complexity: O(inserted), as a rule.
bool keeps_scale(Points points, Points inserted) {
  const bool tells =
      std::any_of(inserted.begin(), inserted.end(), [](const Point& p) { return p != Point{}; });
  return (tells && working_scale(inserted) == 1) || working_scale(points) == 1;
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
  KeptStages kept;                              // while the surface is not certain
  std::optional<KeptBody::Change> body_change;  // what the last stages told instead of a mesh
  PointsAtVertices points_at;                   // the way back from vertex_of_point

  bool is_live() const { return delaunay.num_vertices() > 0; }
  void take(std::size_t count, Triangulation triangulation);
  void take(const ReconstructResult& result, ReconstructStages stages, const Execution& execution);
  void resume(SurfaceState surface);
  void look_for_certificate(const ReconstructResult& result, const CoconeSurface& surface);
  bool take_body(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
                 bool is_flawed, bool may_edit, const Execution& execution);
  KnownLabelsSource labels_of(const OldSurface& old) const;
  ReconstructResult run_later_stages(Points points, const OldSurface& old,
                                     const Execution& execution, bool may_edit);
  void clear(std::size_t count);
  void forget_surface();
  DelaunayChange change_triangulation(Points points, const PointStep& step,
                                      const Execution& execution);
  void undo(PointStep step, const DelaunayChange& change);
  void close_gaps(PointStep& step);
  ReconstructResult run_stages(Points points, const OldSurface& old, const Execution& execution,
                               bool may_edit);
  // Whether so many points are the vertices of a certain surface, each its own.
  bool is_certain(std::size_t points) const {
    return certified.exists() && !options.verify && points == delaunay.num_vertices() &&
           points == certified.num_vertices();
  }
  bool is_smooth(std::size_t points) const {
    return is_certain(points) || (kept.body.is_smooth() && points == delaunay.num_vertices());
  }
  DelaunayChange carry_out(Points points, PointStep& step, const Execution& execution);
  ReconstructResult finish(Points points, PointStep step, const DelaunayChange& change,
                           const Execution& execution, const OldSurface& old,
                           bool may_edit = false);
  Edited edit_body(Points points, const ListEdit<PointId>& change, PointStep step,
                   const DelaunayChange& done, const Execution& execution, const OldSurface& old);
  CertainView view() const { return {delaunay, vertex_of_point, candidates, certified}; }
  SurfaceEdit surface_edit(const ListEdit<PointId>& points, std::span<const VertexId> touched,
                           std::span<const Triangle> triangles);
};

void DynamicTightCocone::State::take(std::size_t count, Triangulation triangulation) {
  num_points = count;
  vertex_of_point = triangulation.vertex_of_point();
  forget_surface();
  delaunay = DynamicDelaunay(std::move(triangulation));
}

// With what the stages found.
void DynamicTightCocone::State::take(const ReconstructResult& result, ReconstructStages stages,
                                     const Execution& execution) {
  take(result.points, std::move(stages.triangulation));
  candidates.start(delaunay, stages);
  look_for_certificate(result, stages.surface);
  if (!certified.exists() && result.status == SurfaceStatus::ok) {
    kept.start(*LentDelaunay(delaunay, vertex_of_point), stages, execution);
    if (result.counters.second_look != 0) kept.body.clear();  // if any, it is that of the first
  }
}

// Where the counts leave hope.
void DynamicTightCocone::State::look_for_certificate(const ReconstructResult& result,
                                                     const CoconeSurface& surface) {
  kept.first_walk = surface.first_walk;
  const ReconstructCounters& counters = result.counters;
  const bool hopeful = counters.second_look == 0 && result.status == SurfaceStatus::ok &&
                       counters.surface_walks == 1 && counters.back_contacts == 0 &&
                       counters.poor_cells == 0 && counters.unvisited_vertices == 0 &&
                       counters.marking_rounds == 0;
  if (hopeful && certified.certify(delaunay, candidates, surface)) kept.clear();
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
  kept.clear();
  points_at.clear();
}

// Changes the triangulation, and follows the surface as far as it stays certain. The step, which
// leads to these points, gets what vertex_of_point was.
DelaunayChange DynamicTightCocone::State::carry_out(Points points, PointStep& step,
                                                    const Execution& execution) {
  DelaunayChange change = change_triangulation(points, step, execution);
  for (std::size_t k = 0; k < step.inserted.size(); ++k) {
    step.vertex_of_point[step.inserted[k]] = change.vertex_of_point[k];
  }
  std::swap(vertex_of_point, step.vertex_of_point);
  // Where about half of the points come or go, looking at the whole takes less time.
  const bool is_local =
      2 * (change.inserted.size() + change.removed.size()) <= delaunay.num_vertices();
  if (!is_local) forget_surface();
  if (candidates.exists()) candidates.update(delaunay, change, execution);
  if (certified.exists()) certified.update(delaunay, change, candidates);
  kept.update(delaunay, change, candidates);
  // A point that comes may be a vertex that was to go (DynamicDelaunay::replace): its cells are
  // old, but the old mesh has no such point.
  if (change.removed.size() != step.removed.size()) kept.body.clear();
  return change;
}

// The result after a step.
ReconstructResult DynamicTightCocone::State::finish(Points points, PointStep step,
                                                    const DelaunayChange& change,
                                                    const Execution& execution,
                                                    const OldSurface& old, bool may_edit) {
  ReconstructResult result;
  if (certified.exists() && !options.verify) {
    result = certain_result(view(), points);
    ++local_changes;
  } else {
    // What is to be verified is computed as a whole.
    try {
      if (candidates.exists()) close_gaps(step);
      result = run_stages(points, old, execution, may_edit);
    } catch (...) {
      undo(std::move(step), change);
      throw;
    }
  }
  result.counters.delaunay = change.insertion;
  num_points = points.size();
  return result;
}

// If it throws the points are as before, but cells may have other numbers.
DelaunayChange DynamicTightCocone::State::change_triangulation(Points points, const PointStep& step,
                                                               const Execution& execution) {
  try {
    return delaunay.replace(step.removed, step.inserted_points, execution);
  } catch (const InputError&) {
    forget_surface();
    // What is wrong is to be said of the points, and not of the change.
    cocoon::delaunay(points, options.delaunay, {execution.threads});
    throw;
  } catch (...) {
    forget_surface();
    throw;
  }
}

// After a change that was done: the points from before come back. Those that were removed may get
// other vertices than they had.
void DynamicTightCocone::State::undo(PointStep step, const DelaunayChange& change) {
  forget_surface();
  std::size_t slots = std::max(step.slots, delaunay.num_vertex_slots());
  // If all points were replaced there may be fewer slots than before.
  for (const VertexId v : step.removed) slots = std::max(slots, v.index() + 1);
  std::vector<VertexId> inserted = change.inserted;
  rename_vertices(step.moved, slots, inserted);
  const DelaunayChange back = delaunay.replace(inserted, step.removed_points);
  for (std::size_t k = 0; k < step.removed.size(); ++k) {
    step.moved.push_back({step.removed[k], back.vertex_of_point[k]});
  }
  vertex_of_point = std::move(step.vertex_of_point);
  rename_vertices(step.moved, slots, vertex_of_point.span());
}

// Of the triangulation and of what is known by slot. Precondition: there is no certificate, or it
// is not needed any more.
void DynamicTightCocone::State::close_gaps(PointStep& step) {
  certified.clear();
  step.slots = delaunay.num_vertex_slots();
  Renumbering renumbering = delaunay.close_gaps();
  candidates.renumber(renumbering, delaunay);
  kept.renumber(renumbering, delaunay);
  points_at.renumber(renumbering.vertices, delaunay.num_vertex_slots());
  rename_vertices(renumbering.vertices, step.slots, vertex_of_point.span());
  step.moved = std::move(renumbering.vertices);
}

// All stages after the triangulation. may_edit: the mesh may be left out, see take_body().
ReconstructResult DynamicTightCocone::State::run_stages(Points points, const OldSurface& old,
                                                        const Execution& execution, bool may_edit) {
  if (candidates.exists()) return run_later_stages(points, old, execution, may_edit);
  ReconstructStages stages;
  ReconstructResult result =
      reconstruct_and_keep(compact_delaunay(delaunay, vertex_of_point).triangulation, points,
                           old.labels, options, execution, stages);
  take(result, std::move(stages), execution);
  return result;
}

void DynamicTightCocone::State::resume(SurfaceState surface) {
  if (surface.empty()) return;
  candidates.resume(delaunay, std::move(surface.candidates));
  if (surface.sides.empty()) {
    kept.resume(*LentDelaunay(delaunay, vertex_of_point), std::move(surface));
    return;
  }
  certified.resume(delaunay, std::move(surface.sides), std::move(surface.sheets));
}

// Keeps the body, as one that is not smooth if its mesh is to be verified as a whole. Tells what
// has changed since the last one instead of a mesh, if that will do: then true.
bool DynamicTightCocone::State::take_body(const Triangulation& triangulation,
                                          const IdVector<CellId, std::uint8_t>& out, bool is_flawed,
                                          bool may_edit, const Execution& execution) {
  auto change = kept.body.take(triangulation, delaunay.cells_at_vertices(), out,
                               !is_flawed && !options.verify, execution);
  if (!may_edit || !change) return false;
  body_change = std::move(change);
  return true;
}

// The same faster where the body that the old surface bounds is kept.
KnownLabelsSource DynamicTightCocone::State::labels_of(const OldSurface& old) const {
  if (!old.labels || !old.triangles.at || !kept.body.exists()) return old.labels;
  return [&](const Triangulation& triangulation, const FacetSet&, const Execution& execution) {
    return kept_labels(triangulation, delaunay.cells_at_vertices(), kept.body.before(triangulation),
                       old, execution);
  };
}

// Those from the extraction on, of the candidates that are known. Precondition: no gaps.
ReconstructResult DynamicTightCocone::State::run_later_stages(Points points, const OldSurface& old,
                                                              const Execution& execution,
                                                              bool may_edit) {
  KnownCandidates found = known_candidates(candidates);
  CoconeSurface surface;
  ReconstructResult result;
  {
    const LentDelaunay lent(delaunay, vertex_of_point);
    found.left = kept.links.link(*lent, candidates_left(candidates), execution);
    found.first_walk = kept.first_walk;
    bool asked = false;
    const LiveStages live{
        delaunay.cells_at_vertices(),
        [&](const Triangulation& triangulation, const auto&... input) {
          return kept.marks.mark(triangulation, delaunay.cells_at_vertices(), input...);
        },
        [&](const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out,
            bool is_flawed) {
          asked = true;
          return take_body(triangulation, out, is_flawed, may_edit, execution);
        }};
    result = reconstruct_tight_from(*lent, std::move(found), points, labels_of(old), options,
                                    execution, live, surface);
    if (!asked) kept.marks.clear();
    if (!asked || result.counters.second_look != 0) kept.body.clear();
  }
  if (!surface.triangles.facets.empty())
    kept.links.keep(std::move(surface.triangles), std::move(surface.rest));
  look_for_certificate(result, surface);
  return result;
}

// After a change from one smooth mesh to another one, once the points of what went are forgotten.
DynamicTightCocone::SurfaceEdit DynamicTightCocone::State::surface_edit(
    const ListEdit<PointId>& points, std::span<const VertexId> touched,
    std::span<const Triangle> triangles) {
  SurfaceEdit edit;
  for (const PointId p : points.removed) edit.touched.push_back(VertexId(p.value));
  for (const VertexId v : touched) {
    if (!points_at[v].is_none()) edit.touched.push_back(VertexId(points_at[v].value));
  }
  make_set(edit.touched);
  PointId first(vertex_of_point.size());
  if (!points.removed.empty()) first = std::min(first, points.removed.front());
  if (!points.added.empty()) first = std::min(first, points.added.front());
  points_at.list(vertex_of_point, first, delaunay.num_vertex_slots());
  const auto number = [&](VertexId v) { return VertexId(points_at[v].value); };
  for (const auto& [a, b, c] : triangles) {
    edit.triangles.push_back(smallest_first({number(a), number(b), number(c)}));
  }
  std::sort(edit.triangles.begin(), edit.triangles.end(), precedes);
  return edit;
}

// What is left of an edit where the surface is not certain.
DynamicTightCocone::Edited DynamicTightCocone::State::edit_body(
    Points points, const ListEdit<PointId>& change, PointStep step, const DelaunayChange& done,
    const Execution& execution, const OldSurface& old) {
  const bool may_edit = is_smooth(points.size());
  if (may_edit) {
    points_at.forget(step.removed, delaunay.num_vertex_slots());
  } else {
    points_at.clear();
  }
  body_change.reset();
  Edited edited{finish(points, std::move(step), done, execution, old, may_edit), {}};
  if (body_change) {
    edited.edit = surface_edit(change, body_change->touched, body_change->triangles);
  } else {
    points_at.clear();
  }
  return edited;
}

DynamicTightCocone::DynamicTightCocone(const ReconstructOptions& options)
    : state_(std::make_unique<State>()) {
  state_->options = options;
  state_->certified = CertifiedSurface(effective_options(options));
  state_->candidates = LiveCandidates(effective_options(options));
}
DynamicTightCocone::~DynamicTightCocone() = default;
DynamicTightCocone::DynamicTightCocone(DynamicTightCocone&&) noexcept = default;
DynamicTightCocone& DynamicTightCocone::operator=(DynamicTightCocone&&) noexcept = default;

const ReconstructOptions& DynamicTightCocone::options() const { return state_->options; }
void DynamicTightCocone::keep_cavities(bool keep) { state_->options.keep_cavities = keep; }
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
  const State& state = *state_;
  CompactDelaunay whole = compact_delaunay(state.delaunay, state.vertex_of_point);
  SurfaceState surface = kept_state(state.candidates, state.certified, state.kept, whole);
  return {std::move(whole.triangulation), std::move(surface)};
}

DynamicTightCocone::Snapshot DynamicTightCocone::release() && {
  State& state = *state_;
  CompactDelaunay whole = compact_delaunay(std::move(state.delaunay), state.vertex_of_point);
  SurfaceState surface = kept_state(state.candidates, state.certified, state.kept, whole);
  state.clear(0);
  return {std::move(whole.triangulation), std::move(surface)};
}

ReconstructResult DynamicTightCocone::reconstruct(Points points, const Execution& execution,
                                                  const KnownLabelsSource& known) {
  if (working_scale(points) != 1) {
    ReconstructResult result =
        reconstruct_tight_with_labels(points, known, state_->options, execution);
    state_->clear(points.size());
    return result;
  }
  DelaunayResult built = triangulate_points(points, state_->options.delaunay, execution);
  ReconstructStages stages;
  ReconstructResult result = reconstruct_and_keep(std::move(built.triangulation), points, known,
                                                  state_->options, execution, stages);
  result.counters.delaunay = built.counters;
  state_->take(result, std::move(stages), execution);
  return result;
}

ReconstructResult DynamicTightCocone::replace(Points points, std::span<const PointId> old_position,
                                              const Execution& execution, const OldSurface& old) {
  State& state = *state_;
  require_positions(points.size(), old_position, state.num_points);
  if (!state.is_live() || points.empty() || working_scale(points) != 1) {
    return reconstruct(points, execution, old.labels);  // of no points: throws
  }
  require_comparable_sizes(points, execution);
  PointStep step = plan_step(state.delaunay, state.vertex_of_point, points, old_position);
  const DelaunayChange change = state.carry_out(points, step, execution);
  state.points_at.clear();
  return state.finish(points, std::move(step), change, execution, old);
}

DynamicTightCocone::Edited DynamicTightCocone::edit(Points points, const ListEdit<PointId>& change,
                                                    const Execution& execution,
                                                    const OldSurface& old) {
  State& state = *state_;
  look_if_smooth(execution);
  require_edit(change, state.num_points, points.size());
  if (!is_smooth() || points.empty()) {
    const IdVector<PointId, PointId> before = places_after(change.reversed(), points.size());
    return {replace(points, before.raw(), execution, old), {}};
  }
  PointStep step = plan_step(state.delaunay, state.vertex_of_point, points, change);
  if (!keeps_scale(points, step.inserted_points))
    return {reconstruct(points, execution, old.labels), {}};
  if (!state.points_at.is_known()) {
    state.points_at.list(state.vertex_of_point, PointId(0), state.delaunay.num_vertex_slots());
  }
  const DelaunayChange done = state.carry_out(points, step, execution);
  if (done.inserted.size() != step.inserted.size()) {
    // A point that came is a vertex that was to go: it stays as it was, and no edit would see it.
    state.points_at.clear();
    return {state.finish(points, std::move(step), done, execution, old), {}};
  }
  if (!state.is_certain(points.size())) {
    return state.edit_body(points, change, std::move(step), done, execution, old);
  }
  state.points_at.forget(step.removed, state.delaunay.num_vertex_slots());
  Edited edited{certain_counts(state.view(), points.size()),
                state.surface_edit(change, state.certified.touched(),
                                   state.certified.triangles_at_touched())};
  edited.result.counters.delaunay = done.insertion;
  state.num_points = points.size();
  ++state.local_changes;
  return edited;
}

void DynamicTightCocone::forget_body() { state_->kept.body.clear(); }

void DynamicTightCocone::complete(ReconstructResult& result) const {
  const State& state = *state_;
  assert(state.num_points == state.delaunay.num_vertices());
  result.point_of_vertex.clear();
  for (const PointId p : state.vertex_of_point.ids()) result.point_of_vertex.push_back(p);
  result.normals.clear();
  result.boundary_sample.clear();
  if (!state.candidates.exists()) {  // an operation was cancelled
    return judge_points(compact_delaunay(state.delaunay, state.vertex_of_point).triangulation,
                        state.options, result);
  }
  for (const VertexId v : state.vertex_of_point) {
    result.normals.push_back(state.candidates.normal(v));
    result.boundary_sample.push_back(state.candidates.is_boundary(v) ? 1 : 0);
  }
}

void DynamicTightCocone::look_if_smooth(const Execution& execution) {
  State& state = *state_;
  if (!state.kept.body.may_be_smooth()) return;
  state.kept.body.look_if_smooth(*LentDelaunay(state.delaunay, state.vertex_of_point), execution);
}

bool DynamicTightCocone::is_smooth() const { return state_->is_smooth(state_->num_points); }
bool DynamicTightCocone::is_certain() const { return state_->is_certain(state_->num_points); }

}  // namespace cocoon
