// Where the surface runs through idle samples, whole clusters of cells change sides
// (clean_up_cells.h, step 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/clean_up/cell_cluster.h"
#include "cocone/clean_up/changing_labels.h"
#include "cocone/clean_up_cells.h"
#include "cocone/energy/cell_energy.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"
#include "geom/ids.h"

namespace cocoon {

class ClusterFlips {
 public:
  // `labels` and `options` must outlive the object. O(1).
  ClusterFlips(ChangingLabels& labels, const CleanUpOptions& options, const Execution& execution)
      : labels_(labels), options_(options), execution_(execution) {}

  // In the doubtful region and beside it, by SpacingCache::precedes. Complexity: that of
  // CellEnergy::ask_idle() for what has changed, and k log k for k of them.
  std::vector<VertexId> idle_samples();
  // At these samples: clusters (cell_cluster.h) whose flip lowers the energy, those that lower it
  // most first. Returns whether there was one. Counts. Complexity: that of cell_cluster() for each
  // cluster at an idle sample, and of the energy of its cells.
  bool flip(const std::vector<VertexId>& idle, double deep_cosine, CleanUpCounters& counters);

 private:
  // That a cluster at an idle sample changes sides.
  struct Offer {
    Energy change;
    VertexId at;
    std::vector<CellId> cells;
  };
  std::vector<Offer> offers_at(const std::vector<VertexId>& idle, double deep_cosine,
                               CleanUpCounters& counters);
  std::vector<CellCluster> clusters_at(VertexId v, double deep_cosine,
                                       ZeroedArray<CellId, ClusterSize>& known,
                                       CleanUpCounters& counters);
  bool is_body(CellId c);
  ZeroedArray<CellId, std::uint8_t>& scratch();

  ChangingLabels& labels_;
  const CleanUpOptions& options_;
  Execution execution_;
  std::vector<VertexId> samples_;  // of the region when it had so many cells, but for those left
  std::size_t cells_with_samples_ = 0;
  ZeroedArray<CellId, std::uint8_t> scratch_;
};

}  // namespace cocoon
