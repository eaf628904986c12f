#include "update/cut_regions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geom/arrays/sort_ids.h"
#include "geom/errors.h"
#include "geom/messages/require_size.h"
#include "update/cloud/rim_index.h"
#include "update/regions/facet_cut.h"
#include "update/regions/island_spread.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Lengths as integers, in this share of the median edge.
constexpr double steps_per_edge = 1024;

double length_of(std::int64_t steps) { return static_cast<double>(steps) / steps_per_edge; }

// The facets that say on which side they are, and what they cost.
class CutSeeds {
 public:
  CutSeeds(const ModelIndex& model, const TriangleSet& border, std::span<const CloudRim> rims,
           double median_edge)
      : model_(model),
        border_(border),
        rims_(rims),
        rim_index_(rims),
        costs_{steps_per_edge / median_edge} {}

  // By the rims: those beside the border.
  void pull_by_rims(double reach, RegionCut& cut) {
    if (rim_index_.empty()) return;
    for (const TriangleId t : beside_border()) {
      const EdgeLengths edges = edges_of(t);
      const RimSide side = rim_index_.side_of(model_.centroid(t));
      const double spacing = rims_[side.rim].spacing;
      if (!(side.distance <= reach * std::max(spacing, edges.shortest))) continue;
      pulls_.push_back({t, side.on_cloud_side ? edges.at_border : -edges.at_border});
      (side.on_cloud_side ? cut.seeds_under : cut.seeds_outside) += length_of(edges.at_border);
    }
  }

  // By the samples: facets that the labels have outside although nothing is left of them. After
  // pull_by_rims(); facets in the order of ids.
  void pull_under(const std::vector<TriangleId>& facets, RegionCut& cut) {
    cut.seeds_under += length_of(pull(facets, 1));
    cut.said_under = facets;
  }

  // By the samples: those that the labels have under the cloud although the scan ended before them.
  // After pull_under().
  void pull_outside(const std::vector<TriangleId>& ends, RegionCut& cut) {
    cut.seeds_outside += length_of(pull(ends, -1));
    ends_ = ends;
    cut.scan_ends = ends.size();
  }

  // Tiny parts of the outside beside partial loops; none if nothing else is outside.
  void find_splinters(std::size_t min_facets, RegionCut& cut) const {
    TriangleSet seen(border_.size(), 0);
    for (const TriangleId t : beside_border()) {
      if (cut.under[t] != 0 || seen[t] != 0) continue;
      const std::vector<TriangleId> part = start_of_part(t, min_facets, cut.under);
      for (const TriangleId in_part : part) seen[in_part] = 1;
      if (part.size() >= min_facets || !lies_at_partial_loops(part)) continue;
      cut.splinters.insert(cut.splinters.end(), part.begin(), part.end());
    }
    make_set(cut.splinters);
    const std::size_t off_border = border_.size() - members(border_).size();
    if (cut.splinters.size() == off_border - cut.under_facets) cut.splinters.clear();
  }

  // Anew with each call.
  void label(RegionCut& cut) const {
    cut.under = facet_cut(model_, border_, pulls_, costs_);
    cut.cut_edges = 0;
    cut.cut_length = cut.contradicted = 0;
    for (const FacetPull& p : pulls_) {
      const bool agrees = cut.under[p.facet] != 0 ? p.pull >= 0 : p.pull <= 0;
      if (!agrees) cut.contradicted += length_of(std::abs(p.pull));
    }
    for (const Halfedge halfedge : halfedges_of_cut(model_, border_, cut.under)) {
      const TriangleId t(triangle_of_halfedge(halfedge));
      const std::size_t i = corner_of_halfedge(halfedge);
      if (is_end(t) || is_end(model_.neighbors()[t][i])) continue;
      ++cut.cut_edges;
      cut.cut_length += length_of(edge_in_steps(model_, t, i, costs_));
    }
  }

  // To where samples lie on the model. What the cut cost before tells how much the rims leave open.
  void move(std::span<const Scan> scans, const MovedCutOptions& options, RegionCut& cut) const {
    cut.under = moved_cut(model_, border_, pulls_, costs_.steps_per_unit, std::move(cut.under),
                          scans, options);
  }

 private:
  struct EdgeLengths {
    std::int64_t at_border = 0;
    double shortest = 0;
  };

  // By half of their edges: more than a cut between them and their likes costs, less than one
  // around each. `way`: 1 or -1. Returns the sum.
  std::int64_t pull(const std::vector<TriangleId>& facets, std::int64_t way) {
    const auto before = [](const FacetPull& a, const FacetPull& b) { return a.facet < b.facet; };
    const auto known = static_cast<std::ptrdiff_t>(pulls_.size());
    std::int64_t sum = 0;
    for (const TriangleId t : facets) {
      std::int64_t edges = 0;
      for (std::size_t i = 0; i < 3; ++i) edges += edge_in_steps(model_, t, i, costs_);
      sum += edges / 2;
      const FacetPull more{t, way * (edges / 2)};
      const auto end = pulls_.begin() + known;
      const auto at = std::lower_bound(pulls_.begin(), end, more, before);
      if (at != end && at->facet == t) {
        at->pull += more.pull;
      } else {
        pulls_.push_back(more);
      }
    }
    std::inplace_merge(pulls_.begin(), pulls_.begin() + known, pulls_.end(), before);
    return sum;
  }

  bool is_end(TriangleId t) const { return std::binary_search(ends_.begin(), ends_.end(), t); }

  // In the order of ids.
  std::vector<TriangleId> beside_border() const {
    std::vector<TriangleId> facets;
    for (const TriangleId t : members(border_)) {
      for (const TriangleId next : model_.neighbors()[t]) {
        if (!next.is_none() && border_[next] == 0) facets.push_back(next);
      }
    }
    make_set(facets);
    return facets;
  }

  // Facets of the label of t that hang together with it by edges off the border: all of them, or as
  // many as are asked for.
  std::vector<TriangleId> start_of_part(TriangleId t, std::size_t most,
                                        const TriangleSet& under) const {
    std::vector<TriangleId> part = {t};
    for (std::size_t k = 0; k < part.size() && part.size() < most; ++k) {
      for (const TriangleId next : model_.neighbors()[part[k]]) {
        if (next.is_none() || border_[next] != 0 || under[next] != under[t]) continue;
        if (std::find(part.begin(), part.end(), next) == part.end()) part.push_back(next);
      }
    }
    return part;
  }

  bool lies_at_partial_loops(const std::vector<TriangleId>& part) const {
    return !rim_index_.empty() && std::all_of(part.begin(), part.end(), [&](TriangleId t) {
      return rim_index_.side_of(model_.centroid(t)).at_partial_loop;
    });
  }

  EdgeLengths edges_of(TriangleId t) const {
    EdgeLengths edges;
    for (std::size_t i = 0; i < 3; ++i) {
      const TriangleId next = model_.neighbors()[t][i];
      if (next.is_none() || border_[next] == 0) continue;
      edges.at_border += edge_in_steps(model_, t, i, costs_);
    }
    edges.shortest = shortest_edge(model_.mesh(), t);
    return edges;
  }

  const ModelIndex& model_;
  const TriangleSet& border_;
  std::span<const CloudRim> rims_;
  RimIndex rim_index_;
  EdgeCosts costs_;
  std::vector<FacetPull> pulls_;  // in the order of ids
  std::vector<TriangleId> ends_;  // in the order of ids
};

double way_length(const ModelIndex& model, std::span<const TriangleId> facets) {
  double length = 0;
  for (std::size_t k = 1; k < facets.size(); ++k) {
    length += distance(model.centroid(facets[k - 1]), model.centroid(facets[k]));
  }
  return length;
}

// Splits the regions that are partly under the cloud, and enters who lies under it. The clouds
// before it see the new regions as the old ones.
void split_by_cut(const TriangleSet& under, std::size_t cloud, CutRegions& result) {
  Regions& regions = result.regions;
  struct Parts {
    bool outside = false;
    bool under = false;
    RegionId new_region;
  };
  IdVector<RegionId, Parts> parts(regions.regions.size());
  for (const TriangleId t : under.ids()) {
    const RegionId r = regions.region_of_facet[t];
    if (!r.is_none()) (under[t] != 0 ? parts[r].under : parts[r].outside) = true;
  }
  IdVector<RegionId, std::uint8_t>& verdicts = result.under[cloud];
  for (const RegionId r : parts.ids()) verdicts.push_back(!parts[r].outside ? 1 : 0);
  for (const RegionId r : parts.ids()) {
    if (!parts[r].under || !parts[r].outside) continue;
    parts[r].new_region = regions.regions.push_back({});
    verdicts.push_back(1);
    for (std::size_t c = 0; c < cloud; ++c) {
      if (!result.under[c].empty()) result.under[c].push_back(result.under[c][r]);
    }
  }
  for (const TriangleId t : under.ids()) {
    const RegionId r = regions.region_of_facet[t];
    if (r.is_none() || under[t] == 0 || parts[r].new_region.is_none()) continue;
    regions.region_of_facet.set(t, parts[r].new_region);
  }
}

// Facets off the border that samples disprove, and those near them on islands; none if all of them
// are under the cloud anyway. The samples are asked only if rims alone leave a doubt: what is whole
// and on the model has told all.
std::vector<TriangleId> disproved_off_border(const ModelIndex& model, const TriangleSet& border,
                                             const RegionCut& cut, std::span<const CloudRim> rims,
                                             std::span<const Scan> scans,
                                             const DisprovedOptions& options,
                                             const OutwardNormals& outward) {
  const bool leaves_model =
      std::any_of(rims.begin(), rims.end(), [](const CloudRim& rim) { return rim.leaves_model; });
  const bool is_in_doubt = cut.cut_length > 0 || cut.contradicted > 0 || leaves_model;
  if (!outward || !is_in_doubt) return {};
  TriangleSet settled = cut.under;
  for (const TriangleId t : settled.ids()) settled[t] |= border[t];
  std::vector<TriangleId> disproved;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const std::vector<TriangleId> more =
        disproved_facets(model, scans[k], outward(k), settled, options);
    disproved.insert(disproved.end(), more.begin(), more.end());
  }
  make_set(disproved);
  spread_on_islands(model, std::move(settled), options.island_reach * largest_spacing(scans),
                    options.island_share, disproved);
  std::erase_if(disproved, [&](TriangleId t) { return border[t] != 0; });
  return disproved;
}

// Labels anew where the model goes on under the cloud although the scans end on it.
void take_out_ends(const ModelIndex& model, std::span<const CloudRim> rims,
                   std::span<const Scan> scans, const CutOptions& options, CutSeeds& seeds,
                   RegionCut& cut) {
  const auto is_clear = [&](const CloudRim& rim) {
    return static_cast<double>(rim.seam_edges) <=
           options.clear_seam_share * static_cast<double>(rim.rim_edges);
  };
  const std::vector<TriangleId> under = members(cut.under);
  std::vector<TriangleId> ends;
  if (!std::all_of(rims.begin(), rims.end(), is_clear) ||
      reaches_beyond(model, under, scans, options.ends)) {
    ends = scan_ends(model, under, scans, options.ends);
    // Nothing of the model is left where samples say so: no scan ends on it.
    std::erase_if(ends, [&](TriangleId t) {
      return std::binary_search(cut.said_under.begin(), cut.said_under.end(), t);
    });
  }
  if (!ends.empty()) {
    // Fewer facets are under the cloud then: none that was not looked at.
    seeds.pull_outside(ends, cut);
    seeds.label(cut);
  }
}

// What is left to do once it is known who has a say.
RegionCut settled(const CutSeeds& seeds, std::span<const Scan> scans, const CutOptions& options,
                  RegionCut cut) {
  seeds.move(scans, options.moved, cut);
  cut.under_facets = members(cut.under).size();
  seeds.find_splinters(options.min_outside_facets, cut);
  return cut;
}

// Whether the bands meet something, and all of it is of the border.
bool covers(const TriangleSet& border, std::span<const LoopBorder> bands) {
  bool any = false;
  bool all = true;
  for (const LoopBorder& band : bands) {
    band.for_each_facet([&](TriangleId t) {
      any = true;
      all = all && border[t] != 0;
    });
  }
  return any && all;
}

// Clouds that are cut as one.
struct JoinedRims {
  std::vector<std::size_t> clouds;
  TriangleSet border;  // certain_border() of all
  std::vector<CloudRim> rims;
  std::vector<Scan> scans;
  std::vector<std::size_t> cloud_of_scan;
};

JoinedRims joined_rims(const ModelIndex& model, std::size_t first, const CloudsOnModel& clouds,
                       const CutOptions& options) {
  JoinedRims found;
  found.border = TriangleSet(model.mesh().triangles.size(), 0);
  for (std::size_t c = first; c < clouds.rims.size(); ++c) {
    if (clouds.joined[c] != first) continue;
    found.clouds.push_back(c);
    certain_border(model, clouds.rims[c], clouds.borders[c].loops, options, found.border);
    found.rims.push_back(clouds.rims[c]);
    if (clouds.scans[c].samples.empty()) continue;
    found.scans.push_back(clouds.scans[c]);
    found.cloud_of_scan.push_back(c);
  }
  return found;
}

RegionCut cut_as_one(const ModelIndex& model, const JoinedRims& joined,
                     const OutwardNormals& outward, const CutOptions& options) {
  const auto outward_of_scan = [&](std::size_t scan) {
    return outward(joined.cloud_of_scan[scan]);
  };
  return cut_under_cloud(model, joined.border, joined.rims, joined.scans, options,
                         outward ? OutwardNormals(outward_of_scan) : OutwardNormals());
}

void require_sizes(const CloudsOnModel& clouds) {
  const std::size_t count = clouds.rims.size();
  require_size("cut_regions", "borders", clouds.borders.size(), count);
  require_size("cut_regions", "scans", clouds.scans.size(), count);
  require_size("cut_regions", "clouds that others are joined to", clouds.joined.size(), count);
  require_size("cut_regions", "flags of clouds", clouds.is_cut.size(), count);
}

}  // namespace

double RegionCut::doubt() const {
  const double weaker = std::min(seeds_under, seeds_outside);
  return weaker > 0 ? (cut_length + contradicted) / weaker : 1;
}

void certain_border(const ModelIndex& model, const CloudRim& rim, std::span<const LoopBorder> loops,
                    const CutOptions& options, TriangleSet& border) {
  require_options("certain_border", options);
  require_size("certain_border", "loops of the border", loops.size(), rim.loops.size());
  require_size("certain_border", "flags of the border", border.size(),
               model.mesh().triangles.size());
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const RimLoop& loop = rim.loops[l];
    if (loops[l].begin.empty()) continue;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop.is_inner(i)) continue;
      const std::span<const TriangleId> facets = loops[l].facets_of(i);
      const double edge = distance(loop.points[i], loop.points[loop.next(i)]);
      if (way_length(model, facets) > options.max_detour * (edge + rim.spacing)) continue;
      for (const TriangleId t : facets) border[t] = 1;
    }
  }
}

RegionCut cut_under_cloud(const ModelIndex& model, const TriangleSet& border,
                          std::span<const CloudRim> rims, std::span<const Scan> scans,
                          const CutOptions& options, const OutwardNormals& outward) {
  require_options("cut_under_cloud", options);
  require_size("cut_under_cloud", "flags of the border", border.size(),
               model.mesh().triangles.size());
  if (rims.empty()) throw InputError("cut_under_cloud: no rim to cut by; give that of the cloud");
  double median_edge = rims.front().median_edge;
  for (const CloudRim& rim : rims) median_edge = std::min(median_edge, rim.median_edge);
  RegionCut cut;
  CutSeeds seeds(model, border, rims, median_edge);
  seeds.pull_by_rims(options.seed_reach, cut);
  seeds.label(cut);
  const std::vector<TriangleId> disproved =
      disproved_off_border(model, border, cut, rims, scans, options.disproved, outward);
  if (!disproved.empty()) {
    CutSeeds more = seeds;
    RegionCut larger = cut;
    more.pull_under(disproved, larger);
    more.label(larger);
    take_out_ends(model, rims, scans, options, more, larger);
    std::vector<TriangleId> more_under = members(larger.under);
    std::erase_if(more_under, [&](TriangleId t) { return cut.under[t] != 0; });
    if (!reaches_beyond(model, more_under, scans, options.disproved.reach)) {
      return settled(more, scans, options, std::move(larger));
    }
  }
  take_out_ends(model, rims, scans, options, seeds, cut);
  return settled(seeds, scans, options, std::move(cut));
}

std::vector<std::uint8_t> clouds_to_cut(std::span<const std::uint8_t> partial,
                                        std::span<const std::size_t> joined) {
  require_size("clouds_to_cut", "clouds that others are joined to", joined.size(), partial.size());
  std::vector<std::uint8_t> cut(partial.size(), 0);
  for (std::size_t c = 0; c < cut.size(); ++c) {
    if (partial[c] != 0) cut[joined[c]] = 1;
  }
  for (std::size_t c = 0; c < cut.size(); ++c) cut[c] = cut[joined[c]];
  return cut;
}

CutRegions cut_regions(const ModelIndex& model, const CloudsOnModel& clouds,
                       const CutOptions& options, const SegmentOptions& segment,
                       const Execution& execution) {
  require_sizes(clouds);
  const auto& rims = clouds.rims;
  const auto& joined = clouds.joined;
  CutRegions result;
  result.is_cut = clouds_to_cut(clouds.is_cut, joined);
  result.cuts.resize(rims.size());
  result.under.resize(rims.size());
  TriangleSet all(model.mesh().triangles.size(), 0);
  for (std::size_t first = 0; first < rims.size(); ++first) {
    if (result.is_cut[first] == 0) {
      for (const LoopBorder& band : clouds.borders[first].loops) {
        band.for_each_facet([&](TriangleId t) { all[t] = 1; });
      }
    }
    if (result.is_cut[first] == 0 || joined[first] != first) continue;
    const JoinedRims group = joined_rims(model, first, clouds, options);
    for (const TriangleId t : all.ids()) all[t] |= group.border[t];
    RegionCut cut = cut_as_one(model, group, clouds.outward, options);
    const bool is_whole = std::all_of(group.clouds.begin(), group.clouds.end(), [&](std::size_t c) {
      return covers(group.border, clouds.borders[c].loops);
    });
    if (is_whole && cut.doubt() > options.max_doubt) {
      for (const std::size_t c : group.clouds) result.is_cut[c] = 0;
      continue;
    }
    for (const TriangleId t : cut.splinters) all[t] = 1;
    result.cuts[first] = std::move(cut);
  }
  result.regions = segment_model(model, all, segment, execution);
  const std::size_t whole = result.regions.regions.size();
  for (std::size_t c = 0; c < rims.size(); ++c) {
    if (result.is_cut[c] != 0 && joined[c] == c) split_by_cut(result.cuts[c].under, c, result);
  }
  for (std::size_t c = 0; c < rims.size(); ++c) {
    if (result.is_cut[c] != 0) result.under[c] = result.under[joined[c]];
  }
  if (result.regions.regions.size() > whole) count_and_group(model, result.regions);
  return result;
}

}  // namespace cocoon
