// The angle condition: which regions lie under a cloud and are replaced by it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "geom/angles.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "update/rim_angles.h"
#include "update/segment_model.h"

namespace cocoon {

struct ChoiceOptions {
  // A region that fewer of a loop's edges see, as a share of those that see the region most seen,
  // does not take part in the loop's midpoint.
  double min_edge_share = 0.1;
  // Regions of a loop whose means are closer to each other than this cannot be told apart.
  double ambiguous_margin = 1.0 * radians_per_degree;
  // Below this margin the choice is made and `narrow` counts it.
  double narrow_margin = 30.0 * radians_per_degree;
  // If all regions of a loop have larger means than this, the model turns away from the cloud on
  // both sides of it: the scan ends before it meets the model, and the smallest mean tells nothing.
  // pi: it never does so, and the smallest mean always decides, as in the paper. Of 336 rims that
  // were right 53 degrees was the largest mean under the cloud, 92 where clouds were out of
  // register.
  double turned_away = 100.0 * radians_per_degree;
  // If samples do not tell then, angles do after all, provided that each region outside has a mean
  // larger than each one under the cloud by at least this (under_by_sure_angles()). Of 235 rims
  // from which the model turned away, and whose samples told, none had the larger mean under the
  // cloud by more than 33 degrees.
  double sure_margin = 40.0 * radians_per_degree;
};

enum class ChoiceStatus {
  ok,
  ambiguous,  // a cloud cannot tell regions apart: nothing is replaced
};

// How one cloud saw one region.
struct RegionVerdict {
  RegionId region;
  double mean_angle = 0;  // over all loops of the cloud, radians
  std::size_t edges = 0;  // rim edges that counted
  bool under_cloud = false;

  double mean_angle_deg() const { return mean_angle * degrees_per_radian; }
};

struct CloudChoice {
  std::vector<RegionVerdict> regions;  // those it saw, in the order of ids
  // Smallest difference between the extreme means of a loop, radians; pi if no loop decided. Of a
  // cloud that `decided` tells about see choose_regions().
  double margin = std::numbers::pi;
  // A loop of it cannot tell its regions apart, or they turn away from it.
  bool is_ambiguous = false;
  // If nothing else is ambiguous: the regions at loops from which all turn away, ascending. Of the
  // others the verdicts hold.
  std::vector<RegionId> turned_away = {};
};

struct RegionChoice {
  ChoiceStatus status = ChoiceStatus::ok;
  IdVector<RegionId, std::uint8_t> replaced;  // one flag per region
  std::vector<CloudChoice> clouds;
  std::size_t undecided_loops = 0;  // loops that saw fewer than two regions: nothing inside them
  std::size_t narrow = 0;           // loops with a margin below narrow_margin
  RegionId kept_largest;  // all regions were under clouds: this one, with the largest mean, stays
  // If the choice is ambiguous: what goes by the other clouds. Else empty.
  IdVector<RegionId, std::uint8_t> replaced_by_clear;
};

// Decides for each cloud which of the regions at its loops lie under it:
//   per loop, the regions are compared with the midpoint between the loop's smallest and largest
//   mean; per cloud and region the differences from the midpoints are averaged over its loops,
//   weighted with edges; a negative average means that the region lies under the cloud.
// A region under any cloud is replaced. For one loop and two regions this is the paper's rule: the
// smaller mean is replaced. A region that no loop saw is kept; so is everything if a loop's means
// are closer than ambiguous_margin, or if they turn away from the cloud.
// `loops`: one entry per loop of any cloud, with its cloud set; `num_clouds` sets the length of the
// result's list. decided[c], where it is given and not empty, says which regions lie under cloud c
// (cut_regions.h, update/regions/sampled_regions.h): then its loops decide nothing, and its margin
// is by how much the mean angle of its regions outside is larger. Without loops and decisions the
// result knows of no regions.
// Errors: InputError unless all entries, and those of `decided`, have the same number of regions,
// their clouds are below num_clouds, the share is one (0 to 1) and the other options are angles (0
// to pi). Complexity: O(loops * regions). Source: Woo & Dey 2005, section 3.4, angle condition;
// several loops: their airbag example.
RegionChoice choose_regions(std::span<const RegionAngles> loops, std::size_t num_clouds,
                            const ChoiceOptions& options = {},
                            std::span<const IdVector<RegionId, std::uint8_t>> decided = {});

// By the angles alone: a flag for each region, 1 for those at loops of the cloud that lie under it,
// even if all of them turn away from it (ChoiceOptions::turned_away). Empty if not each region
// outside has a mean larger by sure_margin than each one under it. `loops`, `num_clouds`, errors
// and complexity: as choose_regions(); `loops` is not empty, and `cloud` below num_clouds. Source:
// ours.
IdVector<RegionId, std::uint8_t> under_by_sure_angles(std::span<const RegionAngles> loops,
                                                      std::size_t num_clouds, std::size_t cloud,
                                                      ChoiceOptions options = {});

// Of the regions that stay the one with the most facets, of several the first; none if all go.
// Errors: InputError unless the choice has a flag for each region. Complexity: O(regions).
RegionId largest_kept_region(const Regions& regions, const RegionChoice& choice);

}  // namespace cocoon
