#include "cocone/clean_up_cells.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cocone/clean_up/changing_labels.h"
#include "cocone/clean_up/cluster_flips.h"
#include "cocone/clean_up/handle_closing.h"
#include "cocone/clean_up/handle_loops.h"
#include "cocone/clean_up/kept_reach.h"
#include "cocone/clean_up/small_parts.h"
#include "cocone/clean_up/vertex_repairs.h"
#include "cocone/energy/cell_cut.h"
#include "cocone/energy/label_evidence.h"
#include "cocone/inputs/stage_inputs.h"
#include "cocone/marking/known_hollows.h"

namespace cocoon {
namespace {

class CleanUp {
 public:
  CleanUp(const Triangulation& triangulation, const Poles& poles, CellMarks& marks,
          const CleanUpOptions& options, const IdVector<VertexId, CellId>* cell_at,
          const Execution& execution)
      : triangulation_(triangulation),
        poles_(poles),
        marks_(marks),
        options_(options),
        execution_(execution),
        labels_(triangulation, marks, options, cell_at, execution),
        repairs_(labels_, options, execution),
        cluster_flips_(labels_, options, execution),
        handle_loops_(triangulation, labels_.stars, labels_.out),
        handle_closing_(triangulation, labels_.stars, labels_.cosines, labels_.region, labels_.out,
                        labels_.energy, options) {
    counters_.undecided_cells = labels_.region.undecided.size();
    counters_.thin_cells = labels_.region.thin_cells;
    counters_.left_cells = labels_.region.left_cells;
  }

  CleanUpCounters run() {
    const DoubtfulRegion& region = labels_.region;
    if (region.vertices.empty()) return counters_;
    take_known_labels();
    ZeroedArray<CellId, Point> centers;
    if (!region.undecided.empty()) {  // else hardly anything will be asked
      centers = labels_.cosines.prepare(region.cells, execution_);
      labels_.energy.prepare_facet_costs(region.undecided, execution_);
    }
    labels_.find_flaws(execution_);
    count(counters_.defects_before, counters_.unused_before);
    if (region.undecided.empty() && labels_.flaws().pinched.empty() && marks_.known.empty()) {
      // Nothing is to be settled.
      counters_.unused_after = counters_.unused_before;
      return counters_;
    }
    leave_out_outliers();
    set_preferences(std::move(centers));
    cut(region.undecided);
    fill_cavities();
    labels_.find_flaws(execution_);
    tell_flaws();
    repair();
    flip_clusters();
    if (drop_components()) repair();
    if (repairs_.make_compound_moves(counters_)) repair();
    if (close_handles()) repair();
    finish();
    return counters_;
  }

 private:
  // The marking left those without a good vertex to the peel.
  void take_known_labels() {
    for (const CellId c : marks_.known.ids()) {
      if (is_known(marks_, c)) marks_.labels[c] = marks_.known[c];
    }
  }

  void leave_out_outliers() {
    for (const VertexId v : labels_.flaws().unused) {
      if (!labels_.energy.is_wanted(v) || !labels_.spacings.is_outlier(v, options_.outlier_ratio))
        continue;
      labels_.energy.leave_out(v);
      outliers_.push_back(v);
    }
    counters_.outliers = outliers_.size();
  }

  void set_preferences(ZeroedArray<CellId, Point> centers) {
    const ZeroedArray<CellId, LabelEvidence> evidence =
        label_evidence(triangulation_, labels_.stars, labels_.cosines, centers, labels_.spacings,
                       poles_, marks_, labels_.region, options_, execution_);
    for (const CellId c : labels_.region.undecided) {
      const double margin = static_cast<double>(evidence[c].in) - evidence[c].out;
      labels_.energy.set_preference(c, to_energy(options_.evidence_weight * margin));
    }
  }

  // Labels the undecided cells; those decided stay as the marking, not the peel, has them. Flat
  // cells are no nodes: what meets through them is joined, and they follow.
  void cut(std::vector<CellId> cells) {
    const auto first_flat = std::stable_partition(
        cells.begin(), cells.end(), [&](CellId c) { return !labels_.cosines.is_flat(c); });
    const std::vector<CellId> flat_cells(first_flat, cells.end());
    cells.erase(first_flat, cells.end());
    counters_.flat_cells = flat_cells.size();
    const std::vector<std::uint8_t> side =
        cut_cells(triangulation_, labels_.cosines, labels_.energy, marks_.labels, cells);
    for (const CellId c : triangulation_.finite_cells()) {
      labels_.out[c] = marks_.labels[c] == CellLabel::out ? 1 : 0;
    }
    for (std::size_t k = 0; k < cells.size(); ++k) labels_.out[cells[k]] = side[k];
    const auto is_out = [&](CellId c) { return !c.is_none() && labels_.out[c] != 0; };
    for (const CellId c : flat_cells) {
      const auto [one, other] = labels_.cosines.sides_of_flat(c);
      labels_.out[c] = is_out(one) || is_out(other) ? 1 : 0;
    }
    for (const CellId c : triangulation_.finite_cells()) {
      if (labels_.out[c] != marks_.reached[c]) relabeled_.push_back(c);
    }
    counters_.relabeled_cells = relabeled_.size();
  }

  void fill_cavities() {
    // As the peel left them all were reached from infinity.
    if (is_reach_kept(triangulation_, labels_.out, relabeled_)) return;
    IdVector<CellId, std::uint8_t> reached = reached_from_infinity(triangulation_, labels_.out);
    if (options_.keep_hollows && !marks_.known.empty()) {
      extend_reach(triangulation_, labels_.out,
                   known_hollow_cells(triangulation_, marks_.known, reached), reached);
    }
    for (const CellId c : triangulation_.finite_cells()) {
      if (labels_.out[c] == reached[c]) continue;
      ++counters_.filled_cells;
      labels_.out[c] = reached[c];
      labels_.touch(c);
    }
  }

  // Most vertices are flawless, and are asked about by their neighbors. From now on it is a loss,
  // too, if a sample of decided cells leaves the surface; outliers may.
  void tell_flaws() {
    enum Flaw : std::uint8_t { none = 0, unused, pinched };
    VertexSet flaw(triangulation_.num_vertices(), none);
    for (const VertexId v : labels_.flaws().unused) flaw[v] = unused;
    for (const VertexId v : labels_.flaws().pinched) flaw[v] = pinched;
    for (const VertexId v : labels_.region.vertices) {
      if (flaw[v] != none) labels_.energy.doubt(v);
      if (flaw[v] != unused) labels_.energy.want(v);
    }
    if (labels_.region.left_cells != 0) {
      for (const VertexId v : triangulation_.vertices()) {
        if (labels_.region.is_left(v)) labels_.energy.doubt(v);
      }
    }
    labels_.energy.know_flawless_elsewhere();
    for (const VertexId v : outliers_) labels_.energy.leave_out(v);
  }

  // Those of girth 3, once each.
  bool close_handles() {
    labels_.flaws();  // the region takes in what has changed
    for (const Triangle& loop : handle_loops_.find(labels_.region, execution_)) {
      if (!handle_loops_.is_handle(loop, options_.most_handle_facets)) continue;
      const bool is_large = handle_closing_.count_cells_at(loop) > options_.most_closing_cells;
      counters_.large_handles += is_large ? 1U : 0U;
      if (!is_large) close_handle(loop);
    }
    return counters_.closed_handles != 0;
  }

  void close_handle(const Triangle& loop) {
    for (const std::uint8_t side : {std::uint8_t{1}, std::uint8_t{0}}) {  // rather filled than cut
      const std::vector<CellId> cells = handle_closing_.find(loop, side);
      if (cells.empty() || labels_.split.splits(cells) || labels_.energy.leaves_out(cells))
        continue;
      labels_.flip(cells);
      ++counters_.closed_handles;
      counters_.closing_cells += cells.size();
      return;
    }
  }

  // Where the surface runs through idle samples, whole clusters change sides.
  void flip_clusters() {
    if (options_.idle_cost == 0 || labels_.region.undecided.empty()) return;
    std::vector<VertexId> idle = cluster_flips_.idle_samples();
    counters_.idle_before = idle.size();
    // The loosest clusters first: walls that they cross are left to closer ones.
    for (const double cosine : {options_.deep_cosine, options_.deeper_cosine}) {
      while (cluster_flips_.flip(idle, cosine, counters_)) {
        repair();
        idle = cluster_flips_.idle_samples();
      }
    }
    counters_.idle_after = idle.size();
  }

  // Parts of the body whose samples and facets are not worth a part of its own.
  bool drop_components() {
    const Energy gain = to_energy(options_.component_cost);
    for (const std::vector<CellId>& part : small_parts(
             triangulation_, labels_.out, labels_.region.cells, options_.most_cluster_cells)) {
      const bool is_left = std::any_of(part.begin(), part.end(), [&](CellId c) {
        return has_left_vertex(triangulation_, labels_.region, c);
      });
      if (is_left || labels_.energy.change(part, gain) >= gain) continue;
      labels_.flip(part);
      ++counters_.dropped_components;
    }
    return counters_.dropped_components != 0;
  }

  void count(std::size_t& defects, std::size_t& unused) {
    unused = labels_.flaws().unused.size();
    defects = 0;
    for (const VertexId v : labels_.flaws().pinched) defects += labels_.energy.extra_fans(v);
  }

  // Step 2, again after each of the others.
  void repair() { repairs_.move(counters_); }

  void finish() {
    const std::vector<VertexId> flawed = labels_.flawed_vertices();
    counters_.large_stars = static_cast<std::size_t>(std::count_if(
        flawed.begin(), flawed.end(), [&](VertexId v) { return repairs_.is_too_large(v); }));
    count(counters_.defects_after, counters_.unused_after);
    for (const CellId c : triangulation_.finite_cells()) {
      counters_.changed_cells += labels_.out[c] != marks_.reached[c];
    }
    marks_.reached = std::move(labels_.out);
  }

  const Triangulation& triangulation_;
  const Poles& poles_;
  CellMarks& marks_;
  const CleanUpOptions& options_;
  const Execution& execution_;
  ChangingLabels labels_;
  VertexRepairs repairs_;
  ClusterFlips cluster_flips_;
  HandleLoops handle_loops_;
  HandleClosing handle_closing_;
  std::vector<CellId> relabeled_;  // by the cut
  std::vector<VertexId> outliers_;
  CleanUpCounters counters_;
};

}  // namespace

CleanUpCounters clean_up_cells(const Triangulation& triangulation, const Poles& poles,
                               CellMarks& marks, const CleanUpOptions& options,
                               const Execution& execution) {
  return clean_up_cells(triangulation, poles, marks, options, nullptr, execution);
}

CleanUpCounters clean_up_cells(const Triangulation& triangulation, const Poles& poles,
                               CellMarks& marks, const CleanUpOptions& options,
                               const IdVector<VertexId, CellId>* cell_at,
                               const Execution& execution) {
  if (!options.enabled) return {};
  require_clean_up("clean_up_cells", triangulation, poles, marks, options, cell_at);
  const bool all_good = marks.good_vertices == triangulation.num_vertices();
  if (all_good && marks.conflicts == 0) return {};  // every vertex has one disk around it
  report_progress(execution, "clean_up_cells", 0);
  const CleanUpCounters counters =
      CleanUp(triangulation, poles, marks, options, cell_at, execution).run();
  report_progress(execution, "clean_up_cells", 1);
  return counters;
}

}  // namespace cocoon
