#include "cocone/close_body.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cocone/checks/surface_roughness.h"
#include "cocone/mark_cells.h"
#include "cocone/marking/likely_labels.h"
#include "cocone/marking/yielding_labels.h"
#include "cocone/surface_mesh.h"
#include "cocone/umbrella.h"
#include "geom/messages/require_size.h"

namespace cocoon {

namespace {

// None are of no cell, unless they are wanted.
void require_labels(const char* what, const IdVector<CellId, CellLabel>& labels, std::size_t cells,
                    bool are_wanted) {
  if (!labels.empty() || are_wanted) require_size("close_body", what, labels.size(), cells);
}

class BodyCloser {
 public:
  BodyCloser(const MarkedSurface& marked, const ReconstructOptions& options,
             const Execution& execution)
      : triangulation_(marked.triangulation),
        surface_(marked.surface),
        boundary_(marked.boundary),
        poles_(marked.poles),
        cell_at_(marked.cell_at),
        options_(options),
        execution_(execution) {}

  ClosedBody clean_up(CellMarks marks) const;
  // `told` counts unless the marking has asked for labels already, as where good vertices
  // disagreed.
  ClosedBody clean_up_knowing(CellMarks marks, const KnownLabels& told) const;
  // Counts what is likely, and makes the body again with it if too much of that is contradicted.
  void heed_likely(const KnownLabels& told, bool in_doubt, ClosedBody& best) const;

 private:
  struct Attempt {
    ClosedBody body;
    std::size_t unused = 0;  // samples that are not on the surface
  };
  // Makes the body again with what is likely taken for known: first with marks as they are where it
  // is known, then, if still more than `most` of it is contradicted, by marks that leave more to
  // the clean-up (mark_undoubted_cells). Takes those whose surfaces are no rougher; whether one
  // was.
  bool make_heeding(const KnownLabels& told, bool in_doubt, double most, ClosedBody& best) const;
  // clean_up_knowing where a foreign mesh tells.
  ClosedBody clean_up_foreign(const CellMarks& marks,
                              const IdVector<CellId, CellLabel>& told) const;
  // Where the marking has asked it: such a mesh cuts sharp edges otherwise than the facets do, and
  // refutes many good vertices. So the marking is done once more without. What it told is taken
  // only if those marks contradict each other, and if fewer samples are unused then or, of as many,
  // fewer vertices contradicted.
  ClosedBody with_or_without(const CellMarks& asked, const IdVector<CellId, CellLabel>& told) const;
  // The clean-up of what is peeled. Where the surface touches itself `told` yields to good
  // vertices, in each round a cell farther off, until it touches itself nowhere or nothing is left
  // to yield. The round with the fewest vertices at which it does, or that are not on it, is taken.
  Attempt clean_up_yielding(const CellMarks& marks, IdVector<CellId, CellLabel> told) const;

  SurfaceRoughness roughness(const ClosedBody& body) const {
    return surface_roughness(surface_between(triangulation_, body.marks, execution_).mesh,
                             triangulation_.num_vertices(), execution_);
  }
  GoodVertices find_good_vertices() const {
    return good_vertices(surface_, boundary_, options_.good_vertices, execution_);
  }
  CellMarks mark(const KnownLabelsSource& known) const {
    return mark_cells(triangulation_, surface_, find_good_vertices(), known, execution_);
  }
  CellMarks peel(CellMarks marks) const {
    return peel_cells(triangulation_, surface_.set, std::move(marks), options_.peel, execution_);
  }

  const Triangulation& triangulation_;
  const LinkedFacets& surface_;
  const VertexSet& boundary_;
  const Poles& poles_;
  const IdVector<VertexId, CellId>* cell_at_;
  const ReconstructOptions& options_;
  const Execution& execution_;
};

ClosedBody BodyCloser::clean_up(CellMarks marks) const {
  ClosedBody body;
  body.clean_up =
      clean_up_cells(triangulation_, poles_, marks, options_.clean_up, cell_at_, execution_);
  if (options_.keep_cavities) {
    body.cavities = open_cavities(triangulation_, surface_.set, marks, execution_);
  }
  body.marks = std::move(marks);
  return body;
}

ClosedBody BodyCloser::clean_up_knowing(CellMarks marks, const KnownLabels& told) const {
  if (told.is_foreign()) return clean_up_foreign(marks, told.labels);
  // The marking has asked already if good vertices disagreed.
  if (marks.known.empty()) marks.known = told.labels;
  return clean_up(std::move(marks));
}

ClosedBody BodyCloser::clean_up_foreign(const CellMarks& marks,
                                        const IdVector<CellId, CellLabel>& told) const {
  return marks.known.empty() ? clean_up_yielding(marks, told).body : with_or_without(marks, told);
}

ClosedBody BodyCloser::with_or_without(const CellMarks& asked,
                                       const IdVector<CellId, CellLabel>& told) const {
  CellMarks unasked = mark(KnownLabelsSource());
  const bool contradict = unasked.conflicts != 0;
  Attempt without = clean_up_yielding(peel(std::move(unasked)), told);
  if (!contradict) return std::move(without.body);
  Attempt with = clean_up_yielding(asked, told);
  const auto rank = [](const Attempt& attempt) {
    const VertexSet& contradicted = attempt.body.marks.contradicted;
    return std::pair(attempt.unused, std::count(contradicted.begin(), contradicted.end(), 1));
  };
  return std::move((rank(with) < rank(without) ? with : without).body);
}

BodyCloser::Attempt BodyCloser::clean_up_yielding(const CellMarks& marks,
                                                  IdVector<CellId, CellLabel> told) const {
  Attempt best;
  const unsigned rounds = options_.clean_up.enabled ? options_.yield_rounds : 0;
  std::size_t yielded = 0;
  std::size_t fewest = 0;
  for (unsigned round = 0; round <= rounds; ++round) {
    CellMarks known = marks;
    known.known = told;
    ClosedBody body = clean_up(std::move(known));
    const SurfaceMesh surface = surface_between(triangulation_, body.marks, execution_);
    const std::vector<VertexId> touching = touching_vertices(surface, execution_);
    const std::size_t unused = triangulation_.num_vertices() - surface.mesh.points.size();
    if (round == 0 || touching.size() + unused < fewest) {
      best.body = std::move(body);
      best.body.yielded_cells = yielded;
      best.unused = unused;
      fewest = touching.size() + unused;
    }
    if (touching.empty() || round == rounds) break;
    const std::size_t more = yield_labels(triangulation_, touching, round, marks.good, told);
    if (more == 0) break;
    yielded += more;
  }
  return best;
}

void BodyCloser::heed_likely(const KnownLabels& told, bool in_doubt, ClosedBody& best) const {
  const std::size_t cells = count_labels(told.likely);
  const std::size_t contradicted = count_contradicted(told.likely, best.marks.reached);
  const double most = options_.max_contradicted_likely * static_cast<double>(cells);
  const bool is_heeded =
      static_cast<double>(contradicted) > most && make_heeding(told, in_doubt, most, best);
  best.likely_cells = cells;
  best.contradicted_likely = contradicted;
  best.heeded_likely = is_heeded ? cells : 0;
}

bool BodyCloser::make_heeding(const KnownLabels& told, bool in_doubt, double most,
                              ClosedBody& best) const {
  const IdVector<CellId, CellLabel>& likely = told.likely;
  SurfaceRoughness least = roughness(best);
  KnownLabels taken;
  taken.undisturbed = told.undisturbed;
  taken.labels = with_likely(told);
  bool is_better = false;
  const auto offer = [&](CellMarks marks) {
    ClosedBody other = clean_up_knowing(peel(std::move(marks)), taken);
    const SurfaceRoughness rough = roughness(other);
    if (!rough.is_at_most(least, options_.max_unused_per_part)) return;
    is_better = true;
    best = std::move(other);
    least = rough;
  };
  if (in_doubt) {
    offer(mark([&](const auto&...) { return taken; }));
    const std::size_t left = count_contradicted(likely, best.marks.reached);
    if (!(static_cast<double>(left) > most)) return is_better;
  }
  // A foreign mesh contradicts many good vertices.
  const bool is_foreign = told.is_foreign();
  offer(mark_undoubted_cells(triangulation_, surface_, find_good_vertices(),
                             is_foreign ? likely : taken.labels, likely, execution_));
  return is_better;
}

}  // namespace

ClosedBody close_body(const MarkedSurface& marked, CellMarks peeled, const KnownLabels& told,
                      const ReconstructOptions& options, const Execution& execution) {
  const ReconstructOptions effective = effective_options(options);
  const std::size_t cells = marked.triangulation.num_cells();
  require_labels("labels of cells that are known beforehand", told.labels, cells,
                 told.is_foreign());
  require_labels("labels of cells that are likely", told.likely, cells, false);
  const BodyCloser closer(marked, effective, execution);
  const bool in_doubt = is_in_doubt(peeled);
  ClosedBody body = in_doubt ? closer.clean_up_knowing(std::move(peeled), told)
                             : closer.clean_up(std::move(peeled));
  if (!told.likely.empty()) {
    // What is merely likely, as in a pocket that was seen, makes no hollow.
    ReconstructOptions filling = effective;
    filling.clean_up.keep_hollows = false;
    BodyCloser(marked, filling, execution).heed_likely(told, in_doubt, body);
  }
  return body;
}

}  // namespace cocoon
