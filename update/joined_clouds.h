// Clouds that overlap each other: scans of one place from several sides. Together they show where
// the scan ends; each alone also ends where it could not see.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/cloud_surface.h"

namespace cocoon {

// Distances in those between nearest samples, of two clouds the larger one, of joined ones that of
// the coarsest.
// While clouds are joined nothing is taken that leaves a rim in doubt: none that lies in shadow
// (ShadowOptions::max_unmatched_share), and no group by its mean against its samples
// (ChoiceOptions::sure_margin). Each by itself, they are.
struct JoinOptions {
  // Clouds overlap each other if at least this share of the samples of one of them is close to
  // samples of the other.
  double min_share = 0.02;
  // How far that is at most. Two sides of a wall are farther apart. 0: no clouds overlap.
  double reach = 1;
  // Smallest distance between the samples of which the surface of joined clouds is made.
  double thinning = 0.7;
  // A cloud that is more than so many times coarser than others, and has at least this share of its
  // samples on them, shows nothing that they do not: of joined clouds it is not the coarsest. Less
  // than 1 counts as 1.
  double coarser = 2;
  double min_covered_share = 0.9;
};

struct JoinedCloud {
  std::vector<std::size_t> members;  // of the clouds given, ascending; at least one
  // The samples of which its surface is made, without equal ones; empty: all.
  std::vector<PointId> sheet;
  std::size_t different = 0;  // samples, if some are chosen
};

// The clouds, those joined that overlap each other, in the order of their first members; nothing if
// no two do. Of the samples of joined ones those are chosen for the surface that keep their
// distance: layers that lie over each other, a little out of register, are no surface. Clouds with
// numbers that are not finite overlap none. Errors: InputError for options out of range.
// Complexity: O(n log n) for each pair of clouds whose boxes overlap, of n samples, unless they are
// known to be joined, and of joined ones for each much coarser than another. Deterministic; what is
// joined and what is chosen does not depend on the order of clouds or samples. Source: ours; Woo &
// Dey 2005 have a cloud for each change.
std::vector<JoinedCloud> join_clouds(std::span<const std::vector<Point>> clouds,
                                     const JoinOptions& options = {});

// As if no two overlapped, but told. Complexity: O(clouds).
std::vector<JoinedCloud> each_by_itself(std::size_t clouds);

// The points of its members, one after the other.
std::vector<Point> samples_of(const JoinedCloud& cloud, std::span<const std::vector<Point>> clouds);

// ranked_cloud_surfaces() of the samples chosen for it, or of all if none were, told of all of
// them. `points`: samples_of() the cloud. Errors: as cloud_surface() of what was chosen.
std::vector<CloudSurface> joined_cloud_surfaces(Points points, const JoinedCloud& cloud,
                                                const CloudSurfaceOptions& options,
                                                const Execution& execution = {});

}  // namespace cocoon
