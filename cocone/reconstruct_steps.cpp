#include "cocone/reconstruct_steps.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "cocone/candidate_triangles.h"
#include "cocone/checks/surface_roughness.h"
#include "cocone/checks/verify_surface.h"
#include "cocone/clean_up_cells.h"
#include "cocone/cocones.h"
#include "cocone/mark_cells.h"
#include "cocone/marking/certain_surface.h"
#include "cocone/marking/likely_labels.h"
#include "cocone/marking/yielding_labels.h"
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

// Whether something is left to be decided by the clean-up.
bool is_in_doubt(const CellMarks& marks) { return marks.poor_cells != 0 || marks.conflicts != 0; }

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
  KnownLabelsSource source;
  if (known && options_.mode != Mode::paper) {
    source = [&](const auto&... asked) {
      if (!told_) told_ = known(asked...);
      return *told_;
    };
  }
  run_step(execution_, "tight", [&](const Execution& nested) {
    if (live_ != nullptr) return close_by(mark_by_caller(source, nested), source, nested);
    GoodVertices good = find_good_vertices(nested);
    if (is_certain(*triangulation_, surface_, good, nested)) {
      return deliver_certain(std::move(good), nested);
    }
    CellMarks marks =
        mark_cells(*triangulation_, surface_.triangles, std::move(good), source, nested);
    if (!source) forget_links();
    if (stages_ != nullptr) stages_->marks = marks;
    close_by(std::move(marks), source, nested);
  });
}

void ReconstructSteps::look_again(const KnownLabelsSource& known) {
  const std::size_t first_conflicts = result_.counters.marking_conflicts;
  if (!is_contradictory(first_conflicts) || result_.status != SurfaceStatus::ok) return;
  const double first_cost = cost_of_result();
  if (first_cost <= cost_of({.parts = 1}, options_.clean_up)) return;  // none is less
  result_.counters.first_conflicts = first_conflicts;
  ReconstructOptions options = options_;
  options.boundary.radius_mode = RadiusMode::cocone;
  options.verify = false;
  run_step(execution_, "second_look", [&](const Execution& nested) {
    ReconstructSteps again(points_, options, nested);
    again.refer_to(*triangulation_);
    again.told_ = std::move(told_);
    again.find_poles();
    again.build_surface();
    again.close_surface(known);
    ReconstructResult& second = again.result_;
    if (second.status != SurfaceStatus::ok || second.counters.marking_conflicts >= first_conflicts)
      return;
    if (again.cost_of_result() >= first_cost) return;
    second.counters.delaunay = result_.counters.delaunay;
    second.counters.first_conflicts = first_conflicts;
    second.counters.second_look = 1;
    result_ = std::move(second);
    triangulation_vertex_ = std::move(again.triangulation_vertex_);
  });
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
  look_again(known);
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

bool ReconstructSteps::is_contradictory(std::size_t conflicts) const {
  return cocoon::is_contradictory(options_.second_look, conflicts, result_.vertices);
}

double ReconstructSteps::cost_of_result() const {
  return cost_of(surface_roughness(result_.mesh, result_.vertices, execution_), options_.clean_up);
}

CellMarks ReconstructSteps::mark_by_caller(const KnownLabelsSource& known,
                                           const Execution& execution) const {
  return live_->mark(*triangulation_, surface_.triangles, boundary_.boundary, known,
                     options_.good_vertices, execution);
}

GoodVertices ReconstructSteps::find_good_vertices(const Execution& execution) const {
  return good_vertices(surface_.triangles, boundary_.boundary, options_.good_vertices, execution);
}

void ReconstructSteps::forget_links() {
  if (live_ != nullptr) return;  // take_surface() gives them
  FacetSet set = std::move(surface_.triangles.set);
  surface_.triangles = {};
  surface_.triangles.set = std::move(set);
}

CellMarks ReconstructSteps::peel(CellMarks marks, const Execution& execution) const {
  return peel_cells(*triangulation_, surface_.triangles.set, std::move(marks), options_.peel,
                    execution);
}

void ReconstructSteps::close_by(CellMarks marks, const KnownLabelsSource& known,
                                const Execution& execution) {
  marks = peel(std::move(marks), execution);
  const bool in_doubt = is_in_doubt(marks);
  const bool all_visited = marks.visited_vertices == marks.good_vertices;
  KnownLabels told;
  if (known && (in_doubt || !all_visited)) {
    told = known(*triangulation_, surface_.triangles.set, execution);
  }
  // Else the marking may have to be done again.
  if (told.likely.empty() && told.undisturbed.empty()) forget_links();
  Attempt best;
  if (!in_doubt) {
    best.body = clean_up(std::move(marks), execution);
  } else {
    best = clean_up_knowing(std::move(marks), told, execution);
  }
  if (!told.likely.empty()) heed_likely(told, in_doubt, best, execution);
  forget_links();
  result_.counters.yielded_cells = best.yielded_cells;
  deliver(std::move(best.body), execution);
}

void ReconstructSteps::heed_likely(const KnownLabels& told, bool in_doubt, Attempt& best,
                                   const Execution& execution) {
  ReconstructCounters& counters = result_.counters;
  const IdVector<CellId, CellLabel>& likely = told.likely;
  const auto contradicted = [&] { return count_contradicted(likely, best.body.marks.reached); };
  const auto are_too_many = [&](std::size_t cells) {
    return static_cast<double>(cells) >
           options_.max_contradicted_likely * static_cast<double>(counters.likely_cells);
  };
  counters.likely_cells = count_labels(likely);
  counters.contradicted_likely = contradicted();
  if (!are_too_many(counters.contradicted_likely)) return;
  const auto roughness = [&](const Attempt& of) {
    return surface_roughness(surface_between(*triangulation_, of.body.marks, execution).mesh,
                             result_.vertices, execution);
  };
  SurfaceRoughness least = roughness(best);
  const bool is_foreign = !told.undisturbed.empty();
  KnownLabels taken;
  taken.undisturbed = told.undisturbed;
  taken.labels = with_likely(told);
  const auto offer = [&](CellMarks marks) {
    Attempt other = clean_up_knowing(peel(std::move(marks), execution), taken, execution);
    const SurfaceRoughness rough = roughness(other);
    if (!rough.is_at_most(least, options_.max_unused_per_part)) return;
    counters.heeded_likely = counters.likely_cells;
    best = std::move(other);
    least = rough;
  };
  if (in_doubt) {
    const auto source = [&](const auto&...) { return taken; };
    offer(mark_cells(*triangulation_, surface_.triangles, find_good_vertices(execution), source,
                     execution));
    if (!are_too_many(contradicted())) return;
  }
  // A mesh of another program contradicts many good vertices.
  offer(mark_undoubted_cells(*triangulation_, surface_.triangles, find_good_vertices(execution),
                             is_foreign ? likely : taken.labels, likely, execution));
}

ReconstructSteps::Attempt ReconstructSteps::clean_up_knowing(CellMarks marks,
                                                             const KnownLabels& told,
                                                             const Execution& execution) const {
  if (!told.undisturbed.empty()) return clean_up_foreign(marks, told.labels, execution);
  // The marking has asked already if good vertices disagreed.
  if (marks.known.empty()) marks.known = told.labels;
  Attempt attempt;
  attempt.body = clean_up(std::move(marks), execution);
  return attempt;
}

ReconstructSteps::Attempt ReconstructSteps::clean_up_foreign(
    const CellMarks& marks, const IdVector<CellId, CellLabel>& told,
    const Execution& execution) const {
  require_size("reconstruct_tight_with_labels", "labels of cells that are known beforehand",
               told.size(), triangulation_->num_cells());
  return marks.known.empty() ? clean_up_yielding(marks, told, execution)
                             : with_or_without(marks, told, execution);
}

ReconstructSteps::Attempt ReconstructSteps::with_or_without(const CellMarks& asked,
                                                            const IdVector<CellId, CellLabel>& told,
                                                            const Execution& execution) const {
  CellMarks unasked = mark_cells(*triangulation_, surface_.triangles, find_good_vertices(execution),
                                 KnownLabelsSource(), execution);
  const bool contradict = unasked.conflicts != 0;
  Attempt without = clean_up_yielding(peel(std::move(unasked), execution), told, execution);
  if (!contradict) return without;
  Attempt with = clean_up_yielding(asked, told, execution);
  const auto rank = [](const Attempt& attempt) {
    const VertexSet& contradicted = attempt.body.marks.contradicted;
    return std::pair(attempt.unused, std::count(contradicted.begin(), contradicted.end(), 1));
  };
  return rank(with) < rank(without) ? std::move(with) : std::move(without);
}

ReconstructSteps::Attempt ReconstructSteps::clean_up_yielding(const CellMarks& marks,
                                                              IdVector<CellId, CellLabel> told,
                                                              const Execution& execution) const {
  Attempt best;
  const unsigned rounds = options_.clean_up.enabled ? options_.yield_rounds : 0;
  std::size_t yielded = 0;
  std::size_t fewest = 0;
  for (unsigned round = 0; round <= rounds; ++round) {
    CellMarks known = marks;
    known.known = told;
    Body body = clean_up(std::move(known), execution);
    const SurfaceMesh surface = surface_between(*triangulation_, body.marks, execution);
    const std::vector<VertexId> touching = touching_vertices(surface, execution);
    const std::size_t unused = result_.vertices - surface.mesh.points.size();
    if (round == 0 || touching.size() + unused < fewest) {
      best.body = std::move(body);
      best.unused = unused;
      best.yielded_cells = yielded;
      fewest = touching.size() + unused;
    }
    if (touching.empty() || round == rounds) break;
    const std::size_t more = yield_labels(*triangulation_, touching, round, marks.good, told);
    if (more == 0) break;
    yielded += more;
  }
  return best;
}

ReconstructSteps::Body ReconstructSteps::clean_up(CellMarks marks,
                                                  const Execution& execution) const {
  Body body;
  body.clean_up = clean_up_cells(*triangulation_, poles_, marks, options_.clean_up,
                                 live_ != nullptr ? &live_->cell_at : nullptr, execution);
  if (options_.keep_cavities) {
    body.cavities = open_cavities(*triangulation_, surface_.triangles.set, marks, execution);
  }
  body.marks = std::move(marks);
  return body;
}

void ReconstructSteps::deliver(Body body, const Execution& execution) {
  CellMarks& marks = body.marks;
  // A second look needs the mesh.
  const bool is_to_be_seen = is_flawed(body.clean_up) || is_contradictory(marks.conflicts);
  if (live_ != nullptr && live_->take_body(*triangulation_, marks.reached, is_to_be_seen)) {
    result_.status = SurfaceStatus::ok;
  } else {
    deliver(surface_between(*triangulation_, marks, execution));
  }
  result_.contradicted = points_at(std::move(marks.contradicted));
  ReconstructCounters& counters = result_.counters;
  counters.clean_up = body.clean_up;
  counters.cavities = body.cavities;
  counters.good_vertices = marks.good_vertices;
  counters.demoted_vertices = marks.folded.size();
  counters.unvisited_vertices = marks.good_vertices - marks.visited_vertices;
  counters.marking_rounds = marks.rounds;
  counters.marking_conflicts = marks.conflicts;
  counters.known_cells = marks.known_cells;
  counters.refuted_vertices = marks.refuted_vertices;
  counters.poor_cells = marks.poor_cells;
  counters.deferred_seeds = marks.deferred_seeds;
  umbrellas_ = counters.good_vertices + counters.demoted_vertices + counters.refuted_vertices;
  good_ = std::move(marks.good);
  if (stages_ != nullptr) stages_->out = std::move(marks.reached);
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
