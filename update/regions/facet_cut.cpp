#include "update/regions/facet_cut.h"

#include <algorithm>
#include <cmath>

#include "cocone/energy/max_flow.h"
#include "geom/arrays/zeroed_array.h"
#include "update/regions/grow_regions.h"

namespace cocoon {

namespace {

// In steps. Sums of 4 million edges fit into 62 bits, whatever the scale of the model.
constexpr double most_steps = 0x1p40;  // of an edge

// The facets near those that pull, as nodes of a graph.
class Zone {
 public:
  Zone(const ModelIndex& model, const TriangleSet& border, std::span<const FacetPull> pulls)
      : model_(model), border_(border), node_of_(border.size()) {
    for (const FacetPull& p : pulls) include(p.facet);
  }

  // Takes in what is a step away. Returns whether there was anything.
  bool grow() {
    const std::size_t end = facets_.size();
    for (; searched_ < end; ++searched_) {
      for (const TriangleId next : model_.neighbors()[facets_[searched_]]) {
        if (!next.is_none() && border_[next] == 0) include(next);
      }
    }
    return facets_.size() > end;
  }

  const std::vector<TriangleId>& facets() const { return facets_; }
  bool has(TriangleId t) const { return node_of_[t] != 0; }
  std::uint32_t node_of(TriangleId t) const { return node_of_[t] - 1; }

  // Calls visit(t, i, next) for the edges between facets off the border with t in the zone; those
  // within it once.
  template <class Visit>
  void visit_edges(const Visit& visit) const {
    for (const TriangleId t : facets_) {
      for (std::size_t i = 0; i < 3; ++i) {
        const TriangleId next = model_.neighbors()[t][i];
        if (next.is_none() || border_[next] != 0 || (has(next) && next < t)) continue;
        visit(t, i, next);
      }
    }
  }

 private:
  void include(TriangleId t) {
    if (node_of_[t] != 0) return;
    facets_.push_back(t);
    node_of_[t] = static_cast<std::uint32_t>(facets_.size());
  }

  const ModelIndex& model_;
  const TriangleSet& border_;
  ZeroedArray<TriangleId, std::uint32_t> node_of_;  // 1 + its place in facets_
  std::vector<TriangleId> facets_;
  std::size_t searched_ = 0;  // of facets_, whose neighbors are in the zone
};

std::vector<std::uint8_t> cut_zone(const ModelIndex& model, const Zone& zone,
                                   std::span<const FacetPull> pulls, const EdgeCosts& costs) {
  MaxFlow flow(zone.facets().size());
  for (const FacetPull& p : pulls) {
    if (p.pull > 0) flow.pull_to_source(zone.node_of(p.facet), p.pull);
    if (p.pull < 0) flow.pull_to_sink(zone.node_of(p.facet), -p.pull);
  }
  zone.visit_edges([&](TriangleId t, std::size_t i, TriangleId next) {
    if (!zone.has(next)) return;
    flow.add_edge(zone.node_of(t), zone.node_of(next), edge_in_steps(model, t, i, costs));
  });
  return flow.source_side();
}

// The labels of what is left between border and zone: 1 or 2 for one label beside a region (the
// second is the source side), 3 for both.
IdVector<RegionId, std::uint8_t> labels_beside(const Regions& rest, const Zone& zone,
                                               const std::vector<std::uint8_t>& source) {
  IdVector<RegionId, std::uint8_t> labels(rest.regions.size(), 0);
  zone.visit_edges([&](TriangleId t, std::size_t, TriangleId next) {
    if (!zone.has(next)) {
      std::uint8_t& label = labels[rest.region_of_facet[next]];
      label = static_cast<std::uint8_t>(label | (source[zone.node_of(t)] != 0 ? 2U : 1U));
    }
  });
  return labels;
}

TriangleSet label_all(const TriangleSet& border, const Zone& zone,
                      const std::vector<std::uint8_t>& source, const Regions& rest,
                      const IdVector<RegionId, std::uint8_t>& labels) {
  TriangleSet all(border.size(), 0);
  for (const TriangleId t : border.ids()) {
    const RegionId r = rest.region_of_facet[t];
    if (!r.is_none()) all[t] = labels[r] == 2 ? 1 : 0;
  }
  for (const TriangleId t : zone.facets()) all[t] = source[zone.node_of(t)];
  return all;
}

}  // namespace

std::int64_t edge_in_steps(const ModelIndex& model, TriangleId t, std::size_t i,
                           const EdgeCosts& costs) {
  double steps = edge_length(model.mesh(), t, i) * costs.steps_per_unit;
  const TriangleId next = model.neighbors()[t][i];
  const bool is_dear = costs.dear != nullptr &&
                       ((*costs.dear)[t] != 0 || (!next.is_none() && (*costs.dear)[next] != 0));
  if (is_dear) steps *= costs.dear_factor;
  return std::llround(std::clamp(steps, 1.0, most_steps));
}

TriangleSet facet_cut(const ModelIndex& model, const TriangleSet& border,
                      std::span<const FacetPull> pulls, const EdgeCosts& costs,
                      const FacetCutOptions& options) {
  Zone zone(model, border, pulls);
  std::size_t steps = options.first_steps;
  for (bool growing = true;; steps *= 2) {
    for (std::size_t k = 0; k < steps && growing; ++k) growing = zone.grow();
    const std::vector<std::uint8_t> source = cut_zone(model, zone, pulls, costs);
    TriangleSet taken = border;
    for (const TriangleId t : zone.facets()) taken[t] = 1;
    const Regions rest = grow_regions(model, taken);
    const IdVector<RegionId, std::uint8_t> labels = labels_beside(rest, zone, source);
    if (std::count(labels.begin(), labels.end(), 3) > 0) continue;
    return label_all(border, zone, source, rest, labels);
  }
}

std::vector<Halfedge> halfedges_of_cut(const ModelIndex& model, const TriangleSet& border,
                                       const TriangleSet& source) {
  std::vector<Halfedge> halfedges;
  for (const TriangleId t : members(source)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const TriangleId next = model.neighbors()[t][i];
      if (next.is_none() || border[next] != 0 || source[next] != 0) continue;
      halfedges.push_back(halfedge_of(t, i));
    }
  }
  return halfedges;
}

}  // namespace cocoon
