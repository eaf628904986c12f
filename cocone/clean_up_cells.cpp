#include "cocone/clean_up_cells.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "cocone/clean_up/best_move.h"
#include "cocone/clean_up/cell_cluster.h"
#include "cocone/clean_up/compound_move.h"
#include "cocone/clean_up/handle_closing.h"
#include "cocone/clean_up/handle_loops.h"
#include "cocone/clean_up/kept_reach.h"
#include "cocone/clean_up/label_split.h"
#include "cocone/clean_up/small_parts.h"
#include "cocone/clean_up/surface_flaws.h"
#include "cocone/energy/cell_cut.h"
#include "cocone/energy/cell_energy.h"
#include "cocone/energy/doubtful_region.h"
#include "cocone/energy/label_evidence.h"
#include "cocone/facets/cell_order.h"
#include "cocone/facets/vertices_of_cells.h"
#include "cocone/inputs/stage_inputs.h"
#include "cocone/samples/sample_spacing.h"
#include "delaunay/star_cache.h"

namespace cocoon {
namespace {

class CleanUp {
 public:
  CleanUp(const Triangulation& triangulation, const Poles& poles, CellMarks& marks,
          const CleanUpOptions& options, const IdVector<VertexId, CellId>* cell_at,
          const Execution& execution)
      : triangulation_(triangulation),
        stars_(triangulation, cell_at, execution),
        poles_(poles),
        marks_(marks),
        options_(options),
        execution_(execution),
        out_(marks.reached),
        cosines_(triangulation, options.flat_ratio),
        spacings_(triangulation, stars_),
        energy_(triangulation, cosines_, stars_, spacings_, marks, options, out_),
        region_(find_doubtful_region(triangulation, marks, stars_, spacings_, most_clump_cells(),
                                     options.thin_support, execution)),
        label_split_(triangulation, out_),
        best_move_(triangulation, stars_, out_, energy_, label_split_, options.most_move_cells),
        compound_move_(triangulation, spacings_, region_, energy_, best_move_, options),
        handle_loops_(triangulation, stars_, out_),
        handle_closing_(triangulation, stars_, cosines_, region_, out_, energy_, options) {
    counters_.undecided_cells = region_.undecided.size();
    counters_.thin_cells = region_.thin_cells;
    counters_.left_cells = region_.left_cells;
    for (const CellId c : region_.undecided) {
      for (const VertexId v : triangulation.cell(c).vertices) energy_.want(v);
    }
  }

  CleanUpCounters run() {
    if (region_.vertices.empty()) return counters_;
    take_known_labels();
    ZeroedArray<CellId, Point> centers;
    if (!region_.undecided.empty()) {  // else hardly anything will be asked
      centers = cosines_.prepare(region_.cells, execution_);
      energy_.prepare_facet_costs(region_.undecided, execution_);
    }
    flaws_ = find_surface_flaws(triangulation_, region_, out_, execution_);
    count(counters_.defects_before, counters_.unused_before);
    if (region_.undecided.empty() && flaws_.pinched.empty() && marks_.known.empty()) {
      // Nothing is to be settled.
      counters_.unused_after = counters_.unused_before;
      return counters_;
    }
    leave_out_outliers();
    set_preferences(std::move(centers));
    cut(region_.undecided);
    fill_cavities();
    extend_region(stars_, spacings_, touched_, region_);
    touched_.clear();
    flaws_ = find_surface_flaws(triangulation_, region_, out_, execution_);
    tell_flaws();
    repair();
    flip_clusters();
    drop_components();
    if (counters_.dropped_components > 0) repair();
    if (make_compound_moves()) repair();
    if (close_handles()) repair();
    const std::vector<VertexId> flawed = flawed_vertices();
    counters_.large_stars = static_cast<std::size_t>(std::count_if(
        flawed.begin(), flawed.end(), [&](VertexId v) { return best_move_.is_too_large(v); }));
    count(counters_.defects_after, counters_.unused_after);
    for (const CellId c : triangulation_.finite_cells()) {
      counters_.changed_cells += out_[c] != marks_.reached[c];
    }
    marks_.reached = std::move(out_);
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
    for (const VertexId v : flaws_.unused) {
      if (!energy_.is_wanted(v) || !spacings_.is_outlier(v, options_.outlier_ratio)) continue;
      energy_.leave_out(v);
      outliers_.push_back(v);
    }
    counters_.outliers = outliers_.size();
  }

  std::size_t most_clump_cells() const {
    const double share = std::min(options_.most_clump_share, 1.0) *
                         static_cast<double>(triangulation_.num_finite_cells());
    return std::max(options_.most_clump_cells, static_cast<std::size_t>(share));
  }

  void set_preferences(ZeroedArray<CellId, Point> centers) {
    const ZeroedArray<CellId, LabelEvidence> evidence =
        label_evidence(triangulation_, stars_, cosines_, centers, spacings_, poles_, marks_,
                       region_, options_, execution_);
    for (const CellId c : region_.undecided) {
      const double margin = static_cast<double>(evidence[c].in) - evidence[c].out;
      energy_.set_preference(c, to_energy(options_.evidence_weight * margin));
    }
  }

  // Labels the undecided cells; those decided stay as the marking, not the peel, has them. Flat
  // cells are no nodes: what meets through them is joined, and they follow.
  void cut(std::vector<CellId> cells) {
    const auto first_flat = std::stable_partition(cells.begin(), cells.end(),
                                                  [&](CellId c) { return !cosines_.is_flat(c); });
    const std::vector<CellId> flat_cells(first_flat, cells.end());
    cells.erase(first_flat, cells.end());
    counters_.flat_cells = flat_cells.size();
    const std::vector<std::uint8_t> side =
        cut_cells(triangulation_, cosines_, energy_, marks_.labels, cells);
    for (const CellId c : triangulation_.finite_cells()) {
      out_[c] = marks_.labels[c] == CellLabel::out ? 1 : 0;
    }
    for (std::size_t k = 0; k < cells.size(); ++k) out_[cells[k]] = side[k];
    const auto is_out = [&](CellId c) { return !c.is_none() && out_[c] != 0; };
    for (const CellId c : flat_cells) {
      const auto [one, other] = cosines_.sides_of_flat(c);
      out_[c] = is_out(one) || is_out(other) ? 1 : 0;
    }
    for (const CellId c : triangulation_.finite_cells()) {
      if (out_[c] != marks_.reached[c]) relabeled_.push_back(c);
    }
    counters_.relabeled_cells = relabeled_.size();
  }

  void fill_cavities() {
    // As the peel left them all were reached from infinity.
    if (is_reach_kept(triangulation_, out_, relabeled_)) return;
    const IdVector<CellId, std::uint8_t> reached = reached_from_infinity(triangulation_, out_);
    for (const CellId c : triangulation_.finite_cells()) {
      if (out_[c] == reached[c]) continue;
      ++counters_.filled_cells;
      out_[c] = reached[c];
      touch(c);
    }
  }

  // Most vertices are flawless, and are asked about by their neighbors. From now on it is a loss,
  // too, if a sample of decided cells leaves the surface; outliers may.
  void tell_flaws() {
    enum Flaw : std::uint8_t { none = 0, unused, pinched };
    VertexSet flaw(triangulation_.num_vertices(), none);
    for (const VertexId v : flaws_.unused) flaw[v] = unused;
    for (const VertexId v : flaws_.pinched) flaw[v] = pinched;
    for (const VertexId v : region_.vertices) {
      if (flaw[v] != none) energy_.doubt(v);
      if (flaw[v] != unused) energy_.want(v);
    }
    if (region_.left_cells != 0) {
      for (const VertexId v : triangulation_.vertices()) {
        if (region_.is_left(v)) energy_.doubt(v);
      }
    }
    energy_.know_flawless_elsewhere();
    for (const VertexId v : outliers_) energy_.leave_out(v);
  }

  // At every sample that is unused or where the surface is pinched (both ends of a non-manifold
  // edge are), in the order of the region, round by round until no move helps.
  void repair() {
    std::vector<VertexId> turns = flawed_vertices();
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<VertexId> later;
      Turns now;
      for (const VertexId v : turns) {
        if (region_.contains(v)) now.push(region_.rank[v]);  // else left alone
      }
      while (!now.empty()) {
        const std::uint32_t rank = now.top();
        while (!now.empty() && now.top() == rank) now.pop();
        const VertexId v = region_.vertices[rank - 1];
        tell_turn();
        while (energy_.vertex_cost(v) != 0) {
          const std::vector<CellId> cells = best_move_.find(v);
          if (cells.empty()) {
            later.push_back(v);
            break;
          }
          flip(cells);
          ++counters_.moves;
          counters_.moved_cells += cells.size();
          changed = true;
          for (const CellId c : cells) {
            for (const VertexId w : triangulation_.cell(c).vertices) {
              if (region_.rank[w] > rank) now.push(region_.rank[w]);
              if (region_.rank[w] < rank) later.push_back(w);
            }
          }
        }
      }
      turns = std::move(later);
      extend_region(stars_, spacings_, turns, region_);
    }
  }

  // Moves take long where much is in doubt: somebody may want to stop.
  void tell_turn() {
    constexpr std::size_t turns_per_report = 64;
    if (++turns_ % turns_per_report == 0) report_progress(execution_, "clean_up_cells", 0.5);
  }

  // At what single moves did not mend, once each.
  bool make_compound_moves() {
    if (options_.max_rise == 0) return false;
    bool changed = false;
    for (const VertexId v : flawed_vertices()) {
      while (energy_.vertex_cost(v) != 0) {
        const std::vector<std::vector<CellId>> moves = compound_move_.find(v);
        if (moves.empty()) break;
        for (const std::vector<CellId>& cells : moves) {
          flip(cells);
          counters_.compound_cells += cells.size();
        }
        ++counters_.compound_moves;
        changed = true;
      }
    }
    return changed;
  }

  // Those of girth 3, once each.
  bool close_handles() {
    if (!touched_.empty()) update_flaws();
    for (const Triangle& loop : handle_loops_.find(region_, execution_)) {
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
      if (cells.empty() || label_split_.splits(cells) || energy_.leaves_out(cells)) continue;
      flip(cells);
      ++counters_.closed_handles;
      counters_.closing_cells += cells.size();
      return;
    }
  }

  void flip(const std::vector<CellId>& cells) {
    energy_.flip(cells);
    for (const CellId c : cells) touch(c);
  }

  // Something has changed at the vertices of a finite cell.
  void touch(CellId c) {
    const auto& vertices = triangulation_.cell(c).vertices;
    touched_.insert(touched_.end(), vertices.begin(), vertices.end());
  }

  // After flips: what was flawless elsewhere still is.
  void update_flaws() {
    extend_region(stars_, spacings_, touched_, region_);
    std::vector<VertexId> asked = std::move(touched_);
    std::erase_if(asked, [&](VertexId v) { return !region_.contains(v); });
    asked.insert(asked.end(), flaws_.unused.begin(), flaws_.unused.end());
    asked.insert(asked.end(), flaws_.pinched.begin(), flaws_.pinched.end());
    std::sort(asked.begin(), asked.end(),
              [&](VertexId a, VertexId b) { return region_.rank[a] < region_.rank[b]; });
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    touched_.clear();
    flaws_ = {};
    for (const VertexId v : asked) {
      if (energy_.is_unused(v)) {
        flaws_.unused.push_back(v);
      } else if (energy_.extra_fans(v) > 0) {
        flaws_.pinched.push_back(v);
      }
    }
  }

  // Of the vertices that cost something.
  std::vector<VertexId> flawed_vertices() {
    if (!touched_.empty()) update_flaws();
    std::vector<VertexId> flawed = flaws_.pinched;
    for (const VertexId v : flaws_.unused) {
      if (energy_.is_wanted(v)) flawed.push_back(v);
    }
    return flawed;
  }

  ZeroedArray<CellId, std::uint8_t>& scratch() {
    if (scratch_.size() == 0) {
      scratch_ = ZeroedArray<CellId, std::uint8_t>(triangulation_.num_cells());
    }
    return scratch_;
  }

  // Where the surface runs through idle samples, whole clusters change sides.
  void flip_clusters() {
    if (options_.idle_cost == 0 || region_.undecided.empty()) return;
    std::vector<VertexId> idle = idle_samples();
    counters_.idle_before = idle.size();
    // The loosest clusters first: walls that they cross are left to closer ones.
    for (const double cosine : {options_.deep_cosine, options_.deeper_cosine}) {
      while (flip_clusters_at(idle, cosine)) {
        repair();
        idle = idle_samples();
      }
    }
    counters_.idle_after = idle.size();
  }

  // In the doubtful region and beside it, by SpacingCache::precedes.
  std::vector<VertexId> idle_samples() {
    if (cells_with_samples_ != region_.cells.size()) {  // it only grows
      samples_ = vertices_of(triangulation_, region_.cells);
      std::erase_if(samples_, [&](VertexId v) { return region_.is_left(v); });
      cells_with_samples_ = region_.cells.size();
    }
    energy_.ask_idle(samples_, execution_);
    std::vector<VertexId> idle;
    for (const VertexId v : samples_) {
      if (energy_.is_idle(v)) idle.push_back(v);
    }
    std::sort(idle.begin(), idle.end(),
              [&](VertexId a, VertexId b) { return spacings_.precedes(a, b); });
    return idle;
  }

  // That a cluster at an idle sample changes sides.
  struct Offer {
    Energy change;
    VertexId at;
    std::vector<CellId> cells;
  };

  // Those that lower the energy most first.
  bool flip_clusters_at(const std::vector<VertexId>& idle, double deep_cosine) {
    std::size_t flipped = 0;
    for (const Offer& offer : offers_at(idle, deep_cosine)) {
      const std::vector<CellId>& cells = offer.cells;
      if (!energy_.is_idle(offer.at) || !are_on_one_side(out_, cells)) continue;  // not any more
      if (!is_attached(triangulation_, out_, cells) || energy_.change(cells) >= 0) continue;
      if (label_split_.splits(cells) || energy_.leaves_out(cells)) continue;
      flip(cells);
      counters_.cluster_cells += cells.size();
      ++flipped;
    }
    counters_.clusters += flipped;
    return flipped != 0;
  }

  std::vector<Offer> offers_at(const std::vector<VertexId>& idle, double deep_cosine) {
    ZeroedArray<CellId, ClusterSize> known(triangulation_.num_cells());
    std::vector<Offer> offers;
    counters_.large_clusters = 0;
    for (const VertexId v : idle) {
      for (CellCluster& cluster : clusters_at(v, deep_cosine, known)) {
        if (!is_attached(triangulation_, out_, cluster.cells)) continue;
        const Energy change = energy_.change(cluster.cells);
        if (change < 0) offers.push_back({change, v, std::move(cluster.cells)});
      }
    }
    std::sort(offers.begin(), offers.end(), [&](const Offer& a, const Offer& b) {
      return a.change != b.change ? a.change < b.change
                                  : precedes(triangulation_, a.cells, b.cells);
    });
    return offers;
  }

  // Those that were not asked yet, in canonical order.
  std::vector<CellCluster> clusters_at(VertexId v, double deep_cosine,
                                       ZeroedArray<CellId, ClusterSize>& known) {
    std::vector<CellCluster> clusters;
    bool too_large = false;
    for (const CellId c : stars_.star(v)) {
      if (known[c] == ClusterSize::unknown && is_body(c)) {
        CellCluster cluster = cell_cluster(triangulation_, cosines_, out_, c, deep_cosine,
                                           options_.most_cluster_cells, known, scratch());
        if (!cluster.too_large) clusters.push_back(std::move(cluster));
      }
      too_large = too_large || known[c] == ClusterSize::too_large;
    }
    counters_.large_clusters += too_large ? 1U : 0U;
    std::sort(clusters.begin(), clusters.end(), [&](const auto& a, const auto& b) {
      return precedes(triangulation_, a.cells, b.cells);
    });
    return clusters;
  }

  // Flat cells come along with others: alone they change no shape, only who is idle.
  bool is_body(CellId c) { return !triangulation_.is_infinite(c) && !cosines_.is_flat(c); }

  // Parts of the body whose samples and facets are not worth a part of its own.
  void drop_components() {
    const Energy gain = to_energy(options_.component_cost);
    for (const std::vector<CellId>& part :
         small_parts(triangulation_, out_, region_.cells, options_.most_cluster_cells)) {
      const bool is_left = std::any_of(part.begin(), part.end(), [&](CellId c) {
        return has_left_vertex(triangulation_, region_, c);
      });
      if (is_left || energy_.change(part, gain) >= gain) continue;
      flip(part);
      ++counters_.dropped_components;
    }
  }

  void count(std::size_t& defects, std::size_t& unused) {
    unused = flaws_.unused.size();
    defects = 0;
    for (const VertexId v : flaws_.pinched) defects += energy_.extra_fans(v);
  }

  using Turns =
      std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<std::uint32_t>>;
  const Triangulation& triangulation_;
  StarCache stars_;
  const Poles& poles_;
  CellMarks& marks_;
  const CleanUpOptions& options_;
  const Execution& execution_;
  IdVector<CellId, std::uint8_t> out_;
  BallCosines cosines_;
  SpacingCache spacings_;
  CellEnergy energy_;
  CleanUpCounters counters_;
  DoubtfulRegion region_;
  LabelSplit label_split_;
  std::vector<CellId> relabeled_;  // by the cut
  std::vector<VertexId> outliers_;
  std::vector<VertexId> samples_;  // of the region when it had so many cells, but for those left
  std::size_t cells_with_samples_ = 0;
  std::size_t turns_ = 0;
  SurfaceFlaws flaws_;             // of the region, before what is touched_ changed
  std::vector<VertexId> touched_;  // vertices of cells that have changed sides since
  ZeroedArray<CellId, std::uint8_t> scratch_;
  BestMove best_move_;
  CompoundMove compound_move_;
  HandleLoops handle_loops_;
  HandleClosing handle_closing_;
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
