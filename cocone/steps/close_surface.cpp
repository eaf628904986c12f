#include "cocone/steps/close_surface.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "cocone/cell_marks.h"
#include "cocone/checks/surface_roughness.h"
#include "cocone/close_body.h"
#include "cocone/facets/linked_facets.h"
#include "cocone/mark_cells.h"
#include "cocone/marking/certain_surface.h"
#include "cocone/peel_cells.h"
#include "cocone/second_look.h"
#include "cocone/surface_mesh.h"
#include "cocone/umbrella.h"

namespace cocoon {

namespace {

// Who tells labels is asked once, whoever wants to know.
class ToldLabels {
 public:
  // Nobody is asked in paper mode.
  ToldLabels(const KnownLabelsSource& known, Mode mode)
      : known_(mode == Mode::paper ? KnownLabelsSource() : known) {}
  ToldLabels(const ToldLabels&) = delete;
  ToldLabels& operator=(const ToldLabels&) = delete;

  bool is_there() const { return static_cast<bool>(known_); }
  // Precondition: there is somebody.
  const KnownLabels& ask(const Triangulation& triangulation, const FacetSet& surface,
                         const Execution& execution) {
    if (!told_) told_ = known_(triangulation, surface, execution);
    return *told_;
  }
  // For who asks by itself. Empty if there is nobody. Refers to the object.
  KnownLabelsSource source() {
    if (!known_) return {};
    return [this](const auto&... asked) { return ask(asked...); };
  }
  bool is_asked() const { return told_.has_value(); }
  // Whether links of the surface are needed where what was told is heeded.
  bool needs_links() const { return told_ && cocoon::needs_links(*told_); }
  // Whether a foreign mesh has told them.
  bool is_foreign() const { return told_ && told_->is_foreign(); }

 private:
  KnownLabelsSource known_;
  std::optional<KnownLabels> told_;
};

// One look at the samples, from the surface that it has found to the result.
struct Look {
  const ReconstructInput& input;
  FoundSurface& found;
  ToldLabels& told;
  const GoingOn& going_on;
  SurfaceResult& made;
  GoodUmbrellas good = {};
};

// A third as much memory as the triangulation has. What is left of the links is the set of facets.
void forget_links(Look& look) {
  if (look.going_on.live != nullptr) return;
  LinkedFacets& triangles = look.found.surface.triangles;
  FacetSet set = std::move(triangles.set);
  triangles = {};
  triangles.set = std::move(set);
}

void keep_good(CellMarks marks, Look& look) {
  look.good.umbrellas = marks.good_vertices + marks.folded.size() + marks.refuted_vertices;
  look.good.good = std::move(marks.good);
}

// What enter_body() would: nothing is left to be decided.
void enter_certain(GoodVertices good, Look& look, const Execution& execution) {
  ManifoldSurface& surface = look.found.surface;
  enter_mesh(look.input, look.found,
             surface_of(look.input.triangulation, std::exchange(surface.triangles, {}),
                        surface.halves, execution),
             look.made, execution);
  ReconstructCounters& counters = look.made.result.counters;
  counters.good_vertices = good.count;
  counters.demoted_vertices = good.folded.size();
  if (look.input.options.clean_up.enabled) {
    counters.clean_up.unused_before = counters.clean_up.unused_after =
        look.made.result.unused_points;
  }
  look.good = {std::move(good.good), good.count + good.folded.size()};
}

// None if the surface is certain: then it is entered.
std::optional<CellMarks> mark(Look& look, const Execution& execution) {
  const Triangulation& triangulation = look.input.triangulation;
  const LinkedFacets& surface = look.found.surface.triangles;
  const VertexSet& boundary = look.found.boundary.boundary;
  const GoodVertexOptions& options = look.input.options.good_vertices;
  const KnownLabelsSource known = look.told.source();
  if (const LiveStages* live = look.going_on.live; live != nullptr) {
    return live->mark(triangulation, surface, boundary, known, options, execution);
  }
  GoodVertices good = good_vertices(surface, boundary, options, execution);
  if (is_certain(triangulation, look.found.surface, good, execution)) {
    enter_certain(std::move(good), look, execution);
    return std::nullopt;
  }
  CellMarks marks = mark_cells(triangulation, surface, std::move(good), known, execution);
  if (!known) forget_links(look);
  if (look.going_on.stages != nullptr) look.going_on.stages->marks = marks;
  return marks;
}

std::optional<CellMarks> mark_and_peel(Look& look, const Execution& execution) {
  return run_step(execution, "tight/marks", [&](const Execution& nested) {
    std::optional<CellMarks> marks = mark(look, nested);
    if (marks) {
      marks = peel_cells(look.input.triangulation, look.found.surface.triangles.set,
                         *std::move(marks), look.input.options.peel, nested);
    }
    return marks;
  });
}

bool calls_for_look(const Look& look, std::size_t conflicts, std::size_t poor_cells) {
  const std::size_t poor = look.told.is_foreign() ? 0 : poor_cells;  // there costs tell
  return calls_for_second_look(look.input.options.second_look,
                               {conflicts, poor, look.made.result.vertices});
}

// Where a mesh of others has told: its marks may have been made again since the peel.
bool calls_for_look_at_closed(const Look& look, std::size_t conflicts, std::size_t poor_cells) {
  return look.told.is_foreign() && calls_for_look(look, conflicts, poor_cells);
}

// Whether the clean-up has seen the boundary of the body be no closed umbrella at some vertex.
bool is_flawed(const CleanUpCounters& clean_up) {
  return clean_up.left_cells + clean_up.defects_after + clean_up.unused_after != 0;
}

// The first point at each vertex of the set, ascending. An empty set is one of no vertices.
std::vector<PointId> first_points_at(const Triangulation& triangulation,
                                     const VertexSet& vertices) {
  std::vector<PointId> points;
  for (const VertexId v : vertices.ids()) {
    if (vertices[v] != 0) points.push_back(triangulation.point_of_vertex(v));
  }
  std::sort(points.begin(), points.end());
  return points;
}

void count_body(const ClosedBody& body, ReconstructCounters& counters) {
  const CellMarks& marks = body.marks;
  counters.clean_up = body.clean_up;
  counters.cavities = body.cavities;
  counters.yielded_cells = body.yielded_cells;
  counters.likely_cells = body.likely_cells;
  counters.contradicted_likely = body.contradicted_likely;
  counters.heeded_likely = body.heeded_likely;
  counters.good_vertices = marks.good_vertices;
  counters.demoted_vertices = marks.folded.size();
  counters.unvisited_vertices = marks.good_vertices - marks.visited_vertices;
  counters.marking_rounds = marks.rounds;
  counters.marking_conflicts = marks.conflicts;
  counters.known_cells = marks.known_cells;
  counters.refuted_vertices = marks.refuted_vertices;
  counters.poor_cells = marks.poor_cells;
  counters.deferred_seeds = marks.deferred_seeds;
}

void enter_body(ClosedBody body, Look& look, const Execution& execution) {
  const Triangulation& triangulation = look.input.triangulation;
  const GoingOn& going_on = look.going_on;
  CellMarks& marks = body.marks;
  // A look at what is closed needs the mesh.
  const bool is_to_be_seen =
      is_flawed(body.clean_up) || calls_for_look_at_closed(look, marks.conflicts, marks.poor_cells);
  if (going_on.live != nullptr &&
      going_on.live->take_body(triangulation, marks.reached, is_to_be_seen)) {
    look.made.result.status = SurfaceStatus::ok;
  } else {
    enter_mesh(look.input, look.found, surface_between(triangulation, marks, execution), look.made,
               execution);
  }
  count_body(body, look.made.result.counters);
  look.made.result.contradicted = first_points_at(triangulation, marks.contradicted);
  if (going_on.stages != nullptr) going_on.stages->out = std::move(marks.reached);
  keep_good(std::move(marks), look);
}

// All that follows the peel.
void close_by(CellMarks marks, Look& look, const Execution& execution) {
  run_step(execution, "tight/body", [&](const Execution& nested) {
    const FoundSurface& found = look.found;
    const LiveStages* live = look.going_on.live;
    const bool all_visited = marks.visited_vertices == marks.good_vertices;
    const bool is_asked = look.told.is_there() && (is_in_doubt(marks) || !all_visited);
    const KnownLabels nothing;
    const KnownLabels& told =
        is_asked ? look.told.ask(look.input.triangulation, found.surface.triangles.set, nested)
                 : nothing;
    if (!needs_links(told)) forget_links(look);
    ClosedBody body =
        close_body({look.input.triangulation, found.surface.triangles, found.boundary.boundary,
                    found.poles, live != nullptr ? &live->cell_at : nullptr},
                   std::move(marks), told, look.input.options, nested);
    forget_links(look);
    enter_body(std::move(body), look, nested);
  });
}

double cost_of_result(const Look& look, const Execution& execution) {
  const ReconstructResult& result = look.made.result;
  return cost_of(surface_roughness(result.mesh, result.vertices, execution),
                 look.input.options.clean_up);
}

// Closes the surface of the second look if it is better than the first, with so many conflicts.
// `cost`: of the surface that is closed already; none: it is not, and marks decide.
bool close_with_less(Look& second, std::size_t conflicts, std::optional<double> cost,
                     const Execution& execution) {
  if (second.found.boundary.interior() == 0) return false;
  if (std::optional<CellMarks> marks = mark_and_peel(second, execution)) {
    if (!cost && marks->conflicts >= conflicts) return false;
    close_by(*std::move(marks), second, execution);
  }
  const ReconstructResult& result = second.made.result;
  if (result.status != SurfaceStatus::ok) return false;
  return !cost || (result.counters.marking_conflicts < conflicts &&
                   cost_of_result(second, execution) < *cost);
}

// Whether the second look is better than the first, as above, and its result is the result now.
bool look_again(Look& first, std::size_t conflicts, std::optional<double> cost,
                const Execution& execution) {
  ReconstructCounters& of_first = first.made.result.counters;
  of_first.first_conflicts = conflicts;
  ReconstructOptions options = first.input.options;
  options.boundary.radius_mode = RadiusMode::cocone;
  options = effective_options(options);
  return run_step(execution, "second_look", [&](const Execution& nested) {
    const ReconstructInput input{first.input.triangulation, first.input.points, options};
    SurfaceResult made = begin_result(input);
    ReconstructCounters& counters = made.result.counters;
    FoundSurface found = find_surface(input, counters, nullptr, nested);
    Look second{input, found, first.told, {}, made};
    if (!close_with_less(second, conflicts, cost, nested)) return false;
    counters.delaunay = of_first.delaunay;
    counters.first_conflicts = conflicts;
    counters.second_look = 1;
    first.made = std::move(made);
    return true;
  });
}

}  // namespace

GoodUmbrellas close_surface(const ReconstructInput& input, FoundSurface& found,
                            const KnownLabelsSource& known, const GoingOn& going_on,
                            SurfaceResult& made, const Execution& execution) {
  ToldLabels told(known, input.options.mode);
  Look look{input, found, told, going_on, made};
  if (found.boundary.interior() == 0) {
    enter_mesh(input, found, {}, made, execution);
    return {};
  }
  std::optional<CellMarks> marks = mark_and_peel(look, execution);
  if (!marks) return std::move(look.good);
  if (told.is_there() && is_in_doubt(*marks)) {
    // The clean-up will ask, and who tells decides how a second look is judged.
    run_step(execution, "tight/known", [&](const Execution& nested) {
      told.ask(input.triangulation, found.surface.triangles.set, nested);
    });
  }
  if (!told.is_foreign() && calls_for_look(look, marks->conflicts, marks->poor_cells)) {
    if (told.is_asked() && !told.needs_links()) forget_links(look);
    if (look_again(look, marks->conflicts, std::nullopt, execution)) {
      keep_good(*std::move(marks), look);
      return std::move(look.good);
    }
  }
  close_by(*std::move(marks), look, execution);
  const ReconstructCounters& counters = made.result.counters;
  if (made.result.status == SurfaceStatus::ok &&
      calls_for_look_at_closed(look, counters.marking_conflicts, counters.poor_cells)) {
    const double cost = cost_of_result(look, execution);
    const double least = cost_of({.parts = 1}, input.options.clean_up);
    if (cost > least) look_again(look, counters.marking_conflicts, cost, execution);
  }
  return std::move(look.good);
}

}  // namespace cocoon
