#include "cocone/noise/outlier_rounds.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cocone/samples/sample_spacing.h"
#include "delaunay/dynamic_delaunay.h"
#include "delaunay/point_queries.h"
#include "geom/arrays/sort_ids.h"
#include "geom/errors.h"

namespace cocoon {
namespace {

// Those of the vertices with a flag.
std::vector<VertexId> flagged(const VertexSet& set) {
  std::vector<VertexId> vertices;
  for (const VertexId v : set.ids()) {
    if (set[v] != 0) vertices.push_back(v);
  }
  return vertices;
}

class Rounds {
 public:
  Rounds(Triangulation triangulation, IdVector<VertexId, double> spacing, const VertexSet& spared,
         const NoiseOptions& options, FlatSamples flat, const Execution& execution)
      : options_(options),
        flat_(flat),
        execution_(execution),
        spared_(spared),
        told_(spared.size(), 0),
        delaunay_(std::move(triangulation)),
        spacing_(std::move(spacing)) {}

  OutlierRounds run(const VertexSet& first) {
    OutlierRounds result{VertexSet(first.size(), 0)};
    std::vector<VertexId> now = flagged(first);
    for (result.rounds = 1;; ++result.rounds) {
      result.spared += take_out_spared(now);
      if (now.empty()) return result;
      for (const VertexId v : now) result.out[v] = 1;
      result.count += now.size();
      const std::optional<DelaunayChange> change = remove(now, result.count);
      if (!change) {
        result.is_flat = true;
        return result;
      }
      now = outliers_at(change->created);
    }
  }

 private:
  // From outliers; returns how many of these have not been told before.
  std::size_t take_out_spared(std::vector<VertexId>& outliers) {
    std::size_t spared = 0;
    std::erase_if(outliers, [&](VertexId v) {
      if (spared_.empty() || spared_[v] == 0) return false;
      spared += std::exchange(told_[v], 1) == 0 ? 1U : 0U;
      return true;
    });
    return spared;
  }

  // None if what is left is flat. `count`: all outliers so far, for the message.
  std::optional<DelaunayChange> remove(std::span<const VertexId> outliers, std::size_t count) {
    try {
      return delaunay_.remove(outliers, execution_);
    } catch (const DegenerateInput&) {
      if (flat_ == FlatSamples::moved) return {};
      throw DegenerateInput(
          "without " + std::to_string(count) +
          " outliers all points lie in one plane: no surface; a larger outlier ratio "
          "leaves fewer out");
    }
  }

  std::vector<CellId> star(VertexId v) const {
    return star_of_vertex(delaunay_.view(), v, delaunay_.cell_at(v));
  }

  // The spacing of a vertex follows from its edges, and whether it is an outlier from the spacings
  // at their ends.
  std::vector<VertexId> outliers_at(std::span<const CellId> created) {
    const TriangulationView view = delaunay_.view();
    std::vector<VertexId> asked;
    for (const CellId c : created) {
      for (const VertexId v : view.cell(c).vertices) {
        if (v != infinite_vertex) asked.push_back(v);
      }
    }
    make_set(asked);
    std::vector<VertexId> around;
    for (std::size_t k = 0, changed = asked.size(); k < changed; ++k) {
      const VertexId v = asked[k];
      const std::vector<CellId> cells = star(v);
      const double before =
          std::exchange(spacing_[v], sample_spacing(view, cells, v, options_.neighbors, shortest_));
      if (spacing_[v] == before) continue;
      collect_neighbors(view, cells, v, around);
      asked.insert(asked.end(), around.begin(), around.end());
    }
    make_set(asked);
    const auto spacing_of = [&](VertexId w) { return spacing_[w]; };
    std::erase_if(asked, [&](VertexId v) {
      collect_neighbors(view, star(v), v, around);
      return !is_outlying(spacing_[v], options_.outlier_ratio, around, spacing_of);
    });
    return asked;
  }

  const NoiseOptions& options_;
  FlatSamples flat_;
  const Execution& execution_;
  const VertexSet& spared_;
  VertexSet told_;  // 1 = spared, and an outlier of some round
  DynamicDelaunay delaunay_;
  IdVector<VertexId, double> spacing_;
  SpacingBuffer shortest_;
};

}  // namespace

OutlierRounds outlier_rounds(Triangulation triangulation, IdVector<VertexId, double> spacing,
                             const VertexSet& first, const VertexSet& spared,
                             const NoiseOptions& options, FlatSamples flat,
                             const Execution& execution) {
  return Rounds(std::move(triangulation), std::move(spacing), spared, options, flat, execution)
      .run(first);
}

}  // namespace cocoon
