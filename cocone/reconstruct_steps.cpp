#include "cocone/reconstruct_steps.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "cocone/candidate_triangles.h"
#include "cocone/checks/surface_roughness.h"
#include "cocone/checks/verify_surface.h"
#include "cocone/close_body.h"
#include "cocone/cocones.h"
#include "cocone/mark_cells.h"
#include "cocone/marking/certain_surface.h"
#include "cocone/orient_surface.h"
#include "cocone/peel_cells.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/second_look.h"
#include "delaunay/delaunay.h"
#include "delaunay/require_points.h"
#include "geom/errors.h"
#include "geom/messages/require_size.h"
#include "geom/parallel/parallel_reduce.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// Whether the clean-up has seen the boundary of the body be no closed umbrella at some vertex.
bool is_flawed(const CleanUpCounters& clean_up) {
  return clean_up.left_cells + clean_up.defects_after + clean_up.unused_after != 0;
}

}  // namespace

ReconstructSteps::ReconstructSteps(Points points, const ReconstructOptions& options,
                                   const Execution& execution)
    : points_(points), options_(effective_options(options)), execution_(execution) {}

void ReconstructSteps::triangulate() {
  require_comparable_sizes(points_, execution_);
  std::vector<Point> scaled;
  Points working = points_;
  if (const double scale = working_scale(points_); scale != 1) {
    require_exact(scale);
    for (const Point& p : points_) scaled.push_back(scale * p);
    working = scaled;
  }
  DelaunayResult built = delaunay(working, options_.delaunay, execution_);
  result_.counters.delaunay = built.counters;
  take(std::move(built.triangulation));
}

void ReconstructSteps::take(Triangulation triangulation) {
  own_triangulation_ = std::move(triangulation);
  refer_to(own_triangulation_);
}

void ReconstructSteps::refer_to(const Triangulation& triangulation) {
  require_size("reconstruct_tight", "input points of the triangulation",
               triangulation.vertex_of_point().size(), points_.size());
  scale_ = working_scale(points_);
  triangulation_ = &triangulation;
  result_.points = points_.size();
  result_.duplicates = triangulation_->num_duplicates();
  result_.vertices = triangulation_->num_vertices();
  result_.tetrahedra = triangulation_->num_finite_cells();
}

void ReconstructSteps::find_poles() {
  run_step(execution_, "poles", [&](const Execution& nested) {
    DualAndPoles found = dual_and_poles(*triangulation_, options_.cocone.cosine, nested);
    dual_ = std::move(found.dual);
    poles_ = std::move(found.poles);
    sides_ = std::move(found.sides);
  });
  ReconstructCounters& counters = result_.counters;
  counters.exact_centers = dual_.exact_centers;
  counters.dual_facet_fallbacks = dual_.facet_fallbacks;
  counters.hull_vertices = poles_.hull_vertices;
  counters.degenerate_poles = poles_.degenerate_vertices;
}

void ReconstructSteps::build_surface() {
  Cocones cocones = run_step(execution_, "cocone/cones", [&](const Execution& nested) {
    return intersect_cocones(*triangulation_, std::move(sides_), nested);
  });
  run_step(execution_, "boundary", [&](const Execution& nested) {
    boundary_ =
        boundary_samples(*triangulation_, dual_, poles_, cocones, options_.boundary, nested);
    // Not {}, which would keep the memory.
    dual_.rays = std::vector<Vec3>();
    dual_.hard_centers = std::vector<Point>();
    if (stages_ == nullptr) poles_.heights = {};  // nobody else asks for them
  });
  run_step(execution_, "cocone/surface", [&](const Execution& nested) {
    CandidateTriangles candidates =
        list_candidate_triangles(*triangulation_, cocones, boundary_.boundary, nested);
    cocones = {};
    if (stages_ != nullptr) stages_->candidates = candidates.set;
    PrunedCandidates pruned =
        prune_sharp_edges(*triangulation_, std::move(candidates), options_.prune, nested);
    if (stages_ != nullptr) stages_->left = pruned.left.set;
    surface_ = extract_manifold(*triangulation_, std::move(pruned.left), pruned.umbrella, nested);
    result_.counters.candidates = pruned.candidates;
    result_.counters.pruned = pruned.pruned;
    result_.counters.umbrellas = pruned.umbrellas;
    if (stages_ != nullptr) stages_->umbrella = std::move(pruned.umbrella);
  });
  ReconstructCounters& counters = result_.counters;
  counters.boundary_samples = boundary_.count;
  counters.ratio_failed = boundary_.ratio_failed;
  counters.recovered_samples = boundary_.recovered;
  count_surface();
}

void ReconstructSteps::extract_from(KnownCandidates candidates) {
  const DelaunayCounters of_triangulation = result_.counters.delaunay;
  result_.counters = candidates.counters;
  result_.counters.delaunay = of_triangulation;
  poles_.normals = std::move(candidates.normals);
  boundary_.boundary = std::move(candidates.boundary);
  boundary_.count = result_.counters.boundary_samples;
  run_step(execution_, "cocone/surface", [&](const Execution& nested) {
    surface_ = extract_again(*triangulation_, std::move(candidates.left), candidates.umbrella,
                             candidates.first_walk, nested);
  });
  count_surface();
}

void ReconstructSteps::close_surface(const KnownLabelsSource& known) {
  if (boundary_.interior() == 0) return deliver({});
  const auto ask = [&](const auto&... asked) -> const KnownLabels& {
    if (!told_) told_ = known(asked...);
    return *told_;
  };
  KnownLabelsSource source;
  if (known && options_.mode != Mode::paper) source = ask;
  std::optional<CellMarks> marks = mark(source);
  if (!marks) return;
  if (source && is_in_doubt(*marks)) {
    // The clean-up will ask, and who tells decides how a second look is judged.
    run_step(execution_, "tight/known", [&](const Execution& nested) {
      ask(*triangulation_, surface_.triangles.set, nested);
    });
  }
  if (!is_told_by_others() && calls_for_second_look(marks->conflicts, marks->poor_cells)) {
    if (told_ && !needs_links(*told_)) forget_links();
    if (look_again(marks->conflicts, std::nullopt, source)) return keep_good(std::move(*marks));
  }
  close_by(std::move(*marks), source);
  const ReconstructCounters& counters = result_.counters;
  if (result_.status != SurfaceStatus::ok ||
      !calls_for_look_at_closed(counters.marking_conflicts, counters.poor_cells)) {
    return;
  }
  const double cost = cost_of_result();
  const double least = cost_of({.parts = 1}, options_.clean_up);
  if (cost > least) look_again(counters.marking_conflicts, cost, source);
}

std::optional<CellMarks> ReconstructSteps::mark(const KnownLabelsSource& known) {
  const auto marked = [&](const Execution& nested) -> std::optional<CellMarks> {
    const LinkedFacets& surface = surface_.triangles;
    if (live_ != nullptr) {
      return live_->mark(*triangulation_, surface, boundary_.boundary, known,
                         options_.good_vertices, nested);
    }
    GoodVertices good = good_vertices(surface, boundary_.boundary, options_.good_vertices, nested);
    if (is_certain(*triangulation_, surface_, good, nested)) {
      deliver_certain(std::move(good), nested);
      return std::nullopt;
    }
    CellMarks marks = mark_cells(*triangulation_, surface, std::move(good), known, nested);
    if (!known) forget_links();
    if (stages_ != nullptr) stages_->marks = marks;
    return marks;
  };
  return run_step(execution_, "tight/marks", [&](const Execution& nested) {
    std::optional<CellMarks> marks = marked(nested);
    if (marks) {
      marks = peel_cells(*triangulation_, surface_.triangles.set, *std::move(marks), options_.peel,
                         nested);
    }
    return marks;
  });
}

bool ReconstructSteps::look_again(std::size_t conflicts, std::optional<double> cost,
                                  const KnownLabelsSource& known) {
  result_.counters.first_conflicts = conflicts;
  ReconstructOptions options = options_;
  options.boundary.radius_mode = RadiusMode::cocone;
  return run_step(execution_, "second_look", [&](const Execution& nested) {
    ReconstructSteps again(points_, options, nested);
    again.refer_to(*triangulation_);
    if (!again.close_with_less(conflicts, cost, known)) return false;
    ReconstructCounters& counters = again.result_.counters;
    counters.delaunay = result_.counters.delaunay;
    counters.first_conflicts = conflicts;
    counters.second_look = 1;
    result_ = std::move(again.result_);
    triangulation_vertex_ = std::move(again.triangulation_vertex_);
    return true;
  });
}

bool ReconstructSteps::close_with_less(std::size_t conflicts, std::optional<double> cost,
                                       const KnownLabelsSource& known) {
  find_poles();
  build_surface();
  if (boundary_.interior() == 0) return false;
  if (std::optional<CellMarks> marks = mark(known)) {
    if (!cost && marks->conflicts >= conflicts) return false;
    close_by(std::move(*marks), known);
  }
  if (result_.status != SurfaceStatus::ok) return false;
  return !cost || (result_.counters.marking_conflicts < conflicts && cost_of_result() < *cost);
}

void ReconstructSteps::deliver_open_surface() {
  run_step(execution_, "cocone/mesh", [&](const Execution& nested) {
    deliver(surface_of(*triangulation_, std::exchange(surface_.triangles, {}), surface_.halves,
                       nested));
    result_.counters.non_orientable_components = orient_surface(result_.mesh).non_orientable;
    canonicalize_triangles(result_.mesh, nested);
  });
}

void ReconstructSteps::verify(bool closed) {
  if (!options_.verify || result_.status != SurfaceStatus::ok) return;
  result_.verification = verify_surface(
      *triangulation_, {result_.mesh, result_.point_of_vertex, triangulation_vertex_}, points_,
      {.closed = closed, .scale = scale_}, execution_);
  if (result_.verification.ok()) return;
  result_.status = SurfaceStatus::refuted;
  result_.mesh = {};
}

ReconstructResult ReconstructSteps::tight_result(const KnownLabelsSource& known) {
  find_poles();
  build_surface();
  close_surface(known);
  verify(true);
  return take_result();
}

CoconeSurface ReconstructSteps::take_surface() {
  CoconeSurface surface;
  surface.halves = std::move(surface_.halves);
  surface.good = std::move(good_);
  surface.first_walk = surface_.first_walk;
  surface.umbrellas = umbrellas_;
  if (live_ != nullptr) {
    surface.triangles = std::move(surface_.triangles);
    surface.rest = std::move(surface_.rest);
  }
  return surface;
}

ReconstructResult ReconstructSteps::take_result() {
  if (stages_ != nullptr) {
    stages_->triangulation = std::move(own_triangulation_);
    stages_->not_in_doubles = std::move(dual_.not_in_doubles);
    stages_->poles = std::move(poles_);
    stages_->boundary = std::move(boundary_);
    stages_->marked = std::move(surface_.triangles.set);
    stages_->surface = take_surface();
  }
  return std::move(result_);
}

void ReconstructSteps::require_exact(double scale) const {
  require_finite(points_);
  if (scales_exactly(points_, scale)) return;
  throw InputError(
      "the coordinates reach beyond 2^100 (1.27e30), and some of them are so much smaller that "
      "no double can hold both after scaling; set those to 0, or use other units");
}

void ReconstructSteps::count_surface() {
  ReconstructCounters& counters = result_.counters;
  counters.surface_triangles = surface_.halves.size();
  counters.surface_walks = surface_.walks;
  counters.back_contacts = surface_.back_contacts;
}

bool ReconstructSteps::calls_for_second_look(std::size_t conflicts, std::size_t poor_cells) const {
  const std::size_t poor = is_told_by_others() ? 0 : poor_cells;  // there costs tell
  return cocoon::calls_for_second_look(options_.second_look, {conflicts, poor, result_.vertices});
}

bool ReconstructSteps::calls_for_look_at_closed(std::size_t conflicts,
                                                std::size_t poor_cells) const {
  return is_told_by_others() && calls_for_second_look(conflicts, poor_cells);
}

double ReconstructSteps::cost_of_result() const {
  return cost_of(surface_roughness(result_.mesh, result_.vertices, execution_), options_.clean_up);
}

void ReconstructSteps::forget_links() {
  if (live_ != nullptr) return;  // take_surface() gives them
  FacetSet set = std::move(surface_.triangles.set);
  surface_.triangles = {};
  surface_.triangles.set = std::move(set);
}

void ReconstructSteps::keep_good(CellMarks marks) {
  umbrellas_ = marks.good_vertices + marks.folded.size() + marks.refuted_vertices;
  good_ = std::move(marks.good);
}

void ReconstructSteps::close_by(CellMarks marks, const KnownLabelsSource& known) {
  run_step(execution_, "tight/body", [&](const Execution& nested) {
    KnownLabels told;
    const bool all_visited = marks.visited_vertices == marks.good_vertices;
    if (known && (is_in_doubt(marks) || !all_visited)) {
      told = known(*triangulation_, surface_.triangles.set, nested);
    }
    if (!needs_links(told)) forget_links();
    ClosedBody body = close_body({*triangulation_, surface_.triangles, boundary_.boundary, poles_,
                                  live_ != nullptr ? &live_->cell_at : nullptr},
                                 std::move(marks), told, options_, nested);
    forget_links();
    deliver(std::move(body), nested);
  });
}

void ReconstructSteps::deliver(ClosedBody body, const Execution& execution) {
  CellMarks& marks = body.marks;
  // A look at what is closed needs the mesh.
  const bool is_to_be_seen =
      is_flawed(body.clean_up) || calls_for_look_at_closed(marks.conflicts, marks.poor_cells);
  if (live_ != nullptr && live_->take_body(*triangulation_, marks.reached, is_to_be_seen)) {
    result_.status = SurfaceStatus::ok;
  } else {
    deliver(surface_between(*triangulation_, marks, execution));
  }
  result_.contradicted = points_at(std::move(marks.contradicted));
  ReconstructCounters& counters = result_.counters;
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
  if (stages_ != nullptr) stages_->out = std::move(marks.reached);
  keep_good(std::move(marks));
}

std::vector<PointId> ReconstructSteps::points_at(VertexSet vertices) const {
  std::vector<PointId> points;
  if (vertices.empty()) return points;
  const IdVector<PointId, VertexId>& vertex_of_point = triangulation_->vertex_of_point();
  for (const PointId p : vertex_of_point.ids()) {
    std::uint8_t& wanted = vertices[vertex_of_point[p]];
    if (wanted != 0) points.push_back(p);
    wanted = 0;
  }
  return points;
}

void ReconstructSteps::deliver_certain(GoodVertices good, const Execution& execution) {
  deliver(surface_of(*triangulation_, std::exchange(surface_.triangles, {}), surface_.halves,
                     execution));
  ReconstructCounters& counters = result_.counters;
  counters.good_vertices = good.count;
  counters.demoted_vertices = good.folded.size();
  if (options_.clean_up.enabled) {
    counters.clean_up.unused_before = counters.clean_up.unused_after = result_.unused_points;
  }
  umbrellas_ = counters.good_vertices + counters.demoted_vertices;
  good_ = std::move(good.good);
}

void ReconstructSteps::deliver(SurfaceMesh surface) {
  result_.mesh = std::move(surface.mesh);
  result_.point_of_vertex = std::move(surface.point_of_vertex);
  triangulation_vertex_ = std::move(surface.triangulation_vertex);
  const std::size_t count = result_.mesh.points.size();
  result_.normals.resize(count);
  result_.boundary_sample.resize(count);
  parallel_chunks(execution_, count, coarse_grain(count), [&](std::size_t begin, std::size_t end) {
    for (VertexId v(begin); v.index() < end; ++v) {
      const VertexId source = triangulation_vertex_[v];
      result_.mesh.points[v] = points_[result_.point_of_vertex[v].index()];
      result_.normals[v] = poles_.normals[source];
      result_.boundary_sample[v] = boundary_.boundary[source];
    }
  });
  result_.unused_points = result_.vertices - count;
  result_.status = boundary_.interior() == 0        ? SurfaceStatus::no_surface
                   : result_.mesh.triangles.empty() ? SurfaceStatus::empty
                                                    : SurfaceStatus::ok;
}

}  // namespace cocoon
