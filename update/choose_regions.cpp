#include "update/choose_regions.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "geom/arrays/sort_ids.h"
#include "geom/errors.h"
#include "geom/messages/require_size.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// What is left of one loop for the decision.
struct LoopRange {
  bool decides = false;     // saw two regions at least
  bool turns_away = false;  // these, with all of them beyond ChoiceOptions::turned_away
  double smallest = 0;
  double largest = 0;
  double midpoint() const { return 0.5 * (smallest + largest); }
  double margin() const { return largest - smallest; }
};

LoopRange loop_range(const RegionAngles& loop, const ChoiceOptions& options) {
  std::size_t most_edges = 0;
  for (const AngleMean& mean : loop.regions) most_edges = std::max(most_edges, mean.edges);
  const double min_edges = options.min_edge_share * static_cast<double>(most_edges);

  LoopRange range;
  std::size_t seen = 0;
  for (const AngleMean& mean : loop.regions) {
    if (mean.edges == 0 || static_cast<double>(mean.edges) < min_edges) continue;
    range.smallest = seen == 0 ? mean.mean() : std::min(range.smallest, mean.mean());
    range.largest = seen == 0 ? mean.mean() : std::max(range.largest, mean.mean());
    ++seen;
  }
  range.decides = seen >= 2;
  range.turns_away = range.decides && range.smallest > options.turned_away;
  return range;
}

// Sums over the loops of one cloud, per region.
struct RegionSum {
  double angle = 0;       // all loops
  std::size_t edges = 0;  // all loops
  double difference = 0;  // from the midpoint, deciding loops
};

// By how much the regions outside a cloud have larger angles than those under it, over all edges.
double margin_of(const CloudChoice& cloud) {
  std::array<double, 2> sums{};
  std::array<double, 2> edges{};
  for (const RegionVerdict& verdict : cloud.regions) {
    const auto count = static_cast<double>(verdict.edges);
    sums[verdict.under_cloud ? 1 : 0] += count * verdict.mean_angle;
    edges[verdict.under_cloud ? 1 : 0] += count;
  }
  if (!(edges[0] > 0) || !(edges[1] > 0)) return cloud.margin;
  return std::max(0.0, sums[0] / edges[0] - sums[1] / edges[1]);
}

// Enters the verdicts on one cloud's regions; `decided`: what they are, or null if their angles
// tell. Returns those that are under the cloud.
std::vector<RegionId> regions_under(const IdVector<RegionId, RegionSum>& sums,
                                    const IdVector<RegionId, std::uint8_t>* decided,
                                    CloudChoice& cloud) {
  std::vector<RegionId> found;
  for (const RegionId r : sums.ids()) {
    const RegionSum& sum = sums[r];
    const bool under =
        decided != nullptr ? (*decided)[r] != 0 : sum.edges > 0 && sum.difference < 0;
    if (under) found.push_back(r);
    if (sum.edges == 0) continue;
    cloud.regions.push_back({r, sum.angle / static_cast<double>(sum.edges), sum.edges, under});
  }
  if (decided != nullptr) cloud.margin = margin_of(cloud);
  return found;
}

void enter_range(const RegionAngles& loop, const LoopRange& range, const ChoiceOptions& options,
                 CloudChoice& cloud) {
  cloud.margin = std::min(cloud.margin, range.margin());
  if (!range.turns_away) {
    if (range.margin() < options.ambiguous_margin) cloud.is_ambiguous = true;
    return;
  }
  for (const RegionId r : loop.regions.ids()) {
    if (loop.regions[r].edges > 0) cloud.turned_away.push_back(r);
  }
}

void keep_the_largest_mean(RegionChoice& choice) {
  if (choice.replaced.empty()) return;
  for (const std::uint8_t flag : choice.replaced) {
    if (flag == 0) return;
  }
  const RegionVerdict* best = nullptr;
  for (const CloudChoice& cloud : choice.clouds) {
    for (const RegionVerdict& verdict : cloud.regions) {
      if (best == nullptr || verdict.mean_angle > best->mean_angle) best = &verdict;
    }
  }
  if (best == nullptr) return;
  choice.kept_largest = best->region;
  choice.replaced[best->region] = 0;
}

// Of the segmentation that loops, or decisions, are about.
std::size_t count_regions(std::span<const RegionAngles> loops,
                          std::span<const IdVector<RegionId, std::uint8_t>> decided) {
  if (!loops.empty()) return loops.front().regions.size();
  for (const IdVector<RegionId, std::uint8_t>& regions : decided) {
    if (!regions.empty()) return regions.size();
  }
  return 0;
}

void require_inputs(const ChoiceOptions& options,
                    std::span<const IdVector<RegionId, std::uint8_t>> decided,
                    std::size_t num_regions) {
  for (const IdVector<RegionId, std::uint8_t>& regions : decided) {
    if (regions.empty()) continue;
    require_size("choose_regions", "decided regions", regions.size(), num_regions);
  }
  require_options("choose_regions", options);
}

}  // namespace

RegionChoice choose_regions(std::span<const RegionAngles> loops, std::size_t num_clouds,
                            const ChoiceOptions& options,
                            std::span<const IdVector<RegionId, std::uint8_t>> decided) {
  const auto is_decided = [&](std::size_t c) { return c < decided.size() && !decided[c].empty(); };
  const std::size_t num_regions = count_regions(loops, decided);
  require_inputs(options, decided, num_regions);
  RegionChoice choice;
  choice.replaced = IdVector<RegionId, std::uint8_t>(num_regions, 0);
  choice.clouds.resize(num_clouds);

  // 1. Per cloud and region: mean angles, and where they lie to the midpoints of the loops.
  std::vector<IdVector<RegionId, RegionSum>> sums(num_clouds,
                                                  IdVector<RegionId, RegionSum>(num_regions));
  for (const RegionAngles& loop : loops) {
    if (loop.regions.size() != num_regions || loop.cloud >= num_clouds) {
      throw InputError("choose_regions: a loop of cloud " + std::to_string(loop.cloud) +
                       " does not fit the other loops; pass angles of one segmentation");
    }
    const LoopRange range = loop_range(loop, options);
    if (!range.decides) {
      ++choice.undecided_loops;
    } else if (!is_decided(loop.cloud)) {
      if (range.margin() < options.narrow_margin) ++choice.narrow;
      enter_range(loop, range, options, choice.clouds[loop.cloud]);
    }
    for (const RegionId r : loop.regions.ids()) {
      const AngleMean& mean = loop.regions[r];
      RegionSum& sum = sums[loop.cloud][r];
      sum.angle += mean.sum;
      sum.edges += mean.edges;
      if (!range.decides || range.turns_away) continue;
      sum.difference += mean.sum - static_cast<double>(mean.edges) * range.midpoint();
    }
  }

  // 2. A region under any cloud is replaced.
  choice.replaced_by_clear = choice.replaced;
  for (std::size_t c = 0; c < num_clouds; ++c) {
    CloudChoice& cloud = choice.clouds[c];
    if (cloud.is_ambiguous) cloud.turned_away.clear();
    make_set(cloud.turned_away);
    cloud.is_ambiguous = cloud.is_ambiguous || !cloud.turned_away.empty();
    for (const RegionId r : regions_under(sums[c], is_decided(c) ? &decided[c] : nullptr, cloud)) {
      choice.replaced[r] = 1;
      if (!cloud.is_ambiguous) choice.replaced_by_clear[r] = 1;
    }
    if (cloud.is_ambiguous) choice.status = ChoiceStatus::ambiguous;
  }
  keep_the_largest_mean(choice);
  if (choice.status == ChoiceStatus::ambiguous) {
    std::fill(choice.replaced.begin(), choice.replaced.end(), std::uint8_t{0});
    choice.kept_largest = {};
  } else {
    choice.replaced_by_clear = {};
  }
  return choice;
}

IdVector<RegionId, std::uint8_t> under_by_sure_angles(std::span<const RegionAngles> loops,
                                                      std::size_t num_clouds, std::size_t cloud,
                                                      ChoiceOptions options) {
  options.turned_away = std::numbers::pi;
  const RegionChoice all = choose_regions(loops, num_clouds, options);
  const CloudChoice& choice = all.clouds[cloud];
  double largest_under = 0;
  double smallest_outside = std::numbers::pi;
  IdVector<RegionId, std::uint8_t> under(all.replaced.size(), 0);
  for (const RegionVerdict& verdict : choice.regions) {
    if (verdict.under_cloud) {
      under[verdict.region] = 1;
      largest_under = std::max(largest_under, verdict.mean_angle);
    } else {
      smallest_outside = std::min(smallest_outside, verdict.mean_angle);
    }
  }
  const bool is_sure = smallest_outside - largest_under >= options.sure_margin;
  return is_sure && !choice.is_ambiguous ? under : IdVector<RegionId, std::uint8_t>();
}

RegionId largest_kept_region(const Regions& regions, const RegionChoice& choice) {
  require_size("largest_kept_region", "flags of replaced regions", choice.replaced.size(),
               regions.regions.size());
  RegionId largest;
  for (const RegionId r : regions.regions.ids()) {
    if (choice.replaced[r] != 0) continue;
    const std::size_t facets = regions.regions[r].facets;
    if (largest.is_none() || facets > regions.regions[largest].facets) largest = r;
  }
  return largest;
}

}  // namespace cocoon
