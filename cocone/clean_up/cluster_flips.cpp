#include "cocone/clean_up/cluster_flips.h"

#include <algorithm>
#include <utility>

#include "cocone/clean_up/best_move.h"
#include "cocone/facets/cell_order.h"
#include "delaunay/vertices_of_cells.h"

namespace cocoon {

std::vector<VertexId> ClusterFlips::idle_samples() {
  const DoubtfulRegion& region = labels_.region;
  if (cells_with_samples_ != region.cells.size()) {  // it only grows
    samples_ = vertices_of(labels_.triangulation, region.cells);
    std::erase_if(samples_, [&](VertexId v) { return region.is_left(v); });
    cells_with_samples_ = region.cells.size();
  }
  labels_.energy.ask_idle(samples_, execution_);
  std::vector<VertexId> idle;
  for (const VertexId v : samples_) {
    if (labels_.energy.is_idle(v)) idle.push_back(v);
  }
  std::sort(idle.begin(), idle.end(),
            [&](VertexId a, VertexId b) { return labels_.spacings.precedes(a, b); });
  return idle;
}

bool ClusterFlips::flip(const std::vector<VertexId>& idle, double deep_cosine,
                        CleanUpCounters& counters) {
  CellEnergy& energy = labels_.energy;
  std::size_t flipped = 0;
  for (const Offer& offer : offers_at(idle, deep_cosine, counters)) {
    const std::vector<CellId>& cells = offer.cells;
    if (!energy.is_idle(offer.at) || !are_on_one_side(labels_.out, cells))
      continue;  // not any more
    if (!is_attached(labels_.triangulation, labels_.out, cells) || energy.change(cells) >= 0) {
      continue;
    }
    if (labels_.split.splits(cells) || energy.leaves_out(cells)) continue;
    labels_.flip(cells);
    counters.cluster_cells += cells.size();
    ++flipped;
  }
  counters.clusters += flipped;
  return flipped != 0;
}

std::vector<ClusterFlips::Offer> ClusterFlips::offers_at(const std::vector<VertexId>& idle,
                                                         double deep_cosine,
                                                         CleanUpCounters& counters) {
  const Triangulation& triangulation = labels_.triangulation;
  ZeroedArray<CellId, ClusterSize> known(triangulation.num_cells());
  std::vector<Offer> offers;
  counters.large_clusters = 0;
  for (const VertexId v : idle) {
    for (CellCluster& cluster : clusters_at(v, deep_cosine, known, counters)) {
      if (!is_attached(triangulation, labels_.out, cluster.cells)) continue;
      const Energy change = labels_.energy.change(cluster.cells);
      if (change < 0) offers.push_back({change, v, std::move(cluster.cells)});
    }
  }
  std::sort(offers.begin(), offers.end(), [&](const Offer& a, const Offer& b) {
    return a.change != b.change ? a.change < b.change : precedes(triangulation, a.cells, b.cells);
  });
  return offers;
}

// Those that were not asked yet, in canonical order.
std::vector<CellCluster> ClusterFlips::clusters_at(VertexId v, double deep_cosine,
                                                   ZeroedArray<CellId, ClusterSize>& known,
                                                   CleanUpCounters& counters) {
  const Triangulation& triangulation = labels_.triangulation;
  std::vector<CellCluster> clusters;
  bool too_large = false;
  for (const CellId c : labels_.stars.star(v)) {
    if (known[c] == ClusterSize::unknown && is_body(c)) {
      CellCluster cluster =
          cell_cluster(triangulation, labels_.cosines, labels_.out, c, deep_cosine,
                       options_.most_cluster_cells, known, scratch());
      if (!cluster.too_large) clusters.push_back(std::move(cluster));
    }
    too_large = too_large || known[c] == ClusterSize::too_large;
  }
  counters.large_clusters += too_large ? 1U : 0U;
  std::sort(clusters.begin(), clusters.end(), [&](const auto& a, const auto& b) {
    return precedes(triangulation, a.cells, b.cells);
  });
  return clusters;
}

// Flat cells come along with others: alone they change no shape, only who is idle.
bool ClusterFlips::is_body(CellId c) {
  return !labels_.triangulation.is_infinite(c) && !labels_.cosines.is_flat(c);
}

ZeroedArray<CellId, std::uint8_t>& ClusterFlips::scratch() {
  if (scratch_.size() == 0) {
    scratch_ = ZeroedArray<CellId, std::uint8_t>(labels_.triangulation.num_cells());
  }
  return scratch_;
}

}  // namespace cocoon
