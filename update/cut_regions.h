// Where the rim of a cloud is partial, torn or shared with other clouds, or runs around a handle:
// the model is cut by what is known of it, and by the shortest lines where that does not part it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "update/cloud/outward_normals.h"
#include "update/cloud/scan.h"
#include "update/cloud_rim.h"
#include "update/disproved_facets.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"
#include "update/regions/moved_cut.h"
#include "update/scan_ends.h"
#include "update/segment_model.h"
#include "update/trace_border.h"

namespace cocoon {

struct CutOptions {
  // The way over the model under a rim edge is part of the border unless it is longer than this
  // many times the sum of the edge and a spacing: then it leads around something that has nothing
  // to do with the edge.
  double max_detour = 2;
  // Facets beside the border say on which side of the rim they are if their centroids lie within
  // this many spacings of it (those of the rim, or the facet's shortest edge if that is longer).
  // Farther away the rim says little: the other wall of a thin slot is near, too.
  double seed_reach = 1.5;
  // The rim does not tell its sides apart if the cut costs more than this share of what the facets
  // on its weaker side say.
  double max_doubt = 0.7;
  // And it is as good as whole up to this one, so that nobody need look at the result: most right
  // updates with a cut have less than half of it, wrong ones more than twice as much.
  double clear_doubt = 0.05;
  // Beyond this one somebody must: of random changes a twentieth of the right ones with a cut has
  // more, and a third of the wrong ones.
  double high_doubt = 0.3;
  // So many facets that say that the scan ends on them are nothing to tell of: where rims have
  // small gaps right updates have a few.
  std::size_t few_scan_ends = 5;
  // If the rim of a cloud leaves more doubt (rim_doubt.h), the rims of its other trials are looked
  // at, and the clearest is taken if its doubt is less than this share of that. 0: none is.
  double clearer_rim = 0.6;
  // But none that tells less than this share of what that one tells (RimDoubt::told).
  double min_told = 0.7;
  // Of rims with no larger share of seams no loop is lost (as CloudSurfaceOptions::max_seam_share):
  // where scans end is looked for only if what would go reaches beyond the box of the samples.
  double clear_seam_share = 0.05;
  // Parts of the model outside the cloud with fewer facets, cut off from the rest beside a
  // partial loop, are none: their facets become border. 0: none is too small.
  std::size_t min_outside_facets = 8;
  // Where a whole rim runs around a handle and that is cut, what goes lies no farther from the box
  // of the samples than so many spacings. By the rims of other trials nothing goes that lies
  // farther, unless it does by the first one, too.
  double box_reach = 10;
  ScanEndOptions ends = {};
  DisprovedOptions disproved = {};
  MovedCutOptions moved = {};
};

// Adds the facets under the rim edges that are known to `border`: those with both ends on the model
// and no cloud beyond them, straight ways only. loops[l] belongs to rim.loops[l].
// Errors: InputError for parts of another rim or model, by their sizes, and for options out of
// range. Complexity: O(facets of the border).
void certain_border(const ModelIndex& model, const CloudRim& rim, std::span<const LoopBorder> loops,
                    const CutOptions& options, TriangleSet& border);

// All lengths are in median edges of the cloud's surface, of several clouds the shortest of these.
// Of a cloud that is not cut all is empty, and its doubt() says nothing.
struct RegionCut {
  TriangleSet under;  // 1: the facet lies under the cloud
  std::size_t under_facets = 0;
  // Between facets of both sides, off the border, where nothing tells that it should be there, and
  // before it moves (moved_cut.h).
  std::size_t cut_edges = 0;
  double cut_length = 0;   // of these
  double seeds_under = 0;  // the border's sides beside facets that say so
  double seeds_outside = 0;
  double contradicted = 0;    // of both, with the other label
  std::size_t scan_ends = 0;  // facets that say "outside" by ScanEndOptions
  // Facets that samples say are under the cloud: disproved ones, and those near them on islands
  // (DisprovedOptions); ascending.
  std::vector<TriangleId> said_under;
  // Facets of tiny parts of the outside, as CutOptions::min_outside_facets, ascending.
  std::vector<TriangleId> splinters;

  // Nothing was cut: no facet beside the border says anything.
  bool is_empty() const { return seeds_under == 0 && seeds_outside == 0; }
  // What the cut costs as a share of what the weaker side says; 1 if it says nothing.
  double doubt() const;
};

// Labels the facets that are not in `border` (those are under no cloud):
//  1. Each facet beside the border says "under the cloud" or "outside" by the side of the nearest
//     rim edge on which it lies, and is believed as far as its edges at the border are long.
//  2. A cut between two facets costs the length of their edge. The labels are those that cost least
//     in all, of several the ones with the fewest facets under the cloud. So a whole rim is all of
//     the cut; where a stretch of it is missing, the shortest way over the model replaces it; and
//     where one is in a wrong place, the others outvote it.
//  3. If the rim is not all of the cut, is contradicted, or leaves the model, the samples have a
//     say: facets outside that they disprove (disproved_facets.h), and those near them on an island
//     (island_spread.h), say "under the cloud" - unless facets would go that are farther from the
//     samples than these look: then the samples are wrong, or their normals.
//  4. Where the labels would have the model go on under the cloud although the scans end on it
//     (scan_ends.h), facets there say "outside".
//  5. The cut moves to where samples lie on the model still (moved_cut.h).
//  6. Where the rim runs into a seam, as at the mouth of a hole, edges that are no end of the cloud
//     have a few facets say "outside" in the midst of it: the splinters.
// `rims`: of one cloud, or of several that overlap each other and are cut as one. `scans`: their
// samples; without them steps 4 and 5 are left out. `outward`: of the samples, by the number of the
// scan; without it step 3 is left out. Why: docs/departures.md, departure 16. Errors: InputError
// for no rim, for the border of another model, by its size, and for options out of range.
// Complexity: that of a minimum cut of n facets, near linear. Deterministic: lengths are compared
// as integers, and the labels are unique. Source: ours; Woo & Dey 2005, section 3.4 presumes rims
// that are closed.
RegionCut cut_under_cloud(const ModelIndex& model, const TriangleSet& border,
                          std::span<const CloudRim> rims, std::span<const Scan> scans = {},
                          const CutOptions& options = {}, const OutwardNormals& outward = {});

// The regions of an update with clouds that are cut.
struct CutRegions {
  Regions regions;
  // Of each cloud, whether it is cut after all.
  std::vector<std::uint8_t> is_cut;
  // One for each cloud; empty but for those that are cut, alone or as the first of joined ones.
  std::vector<RegionCut> cuts;
  // Of each cloud that is cut: 1 for the regions under it, or under those it is joined to. Empty
  // for the others.
  std::vector<IdVector<RegionId, std::uint8_t>> under;
};

// For each cloud whether it is cut: its rim is partial (CloudRim::is_partial), or one of those it
// is joined to. joined[c]: the first of the clouds that c is joined to (lowest_sharing_clouds()).
// Errors: InputError unless there are as many of both.
std::vector<std::uint8_t> clouds_to_cut(std::span<const std::uint8_t> partial,
                                        std::span<const std::size_t> joined);

// What is known of each cloud, by its number.
struct CloudsOnModel {
  std::span<const CloudRim> rims;
  std::span<const Border> borders;
  std::span<const Scan> scans;           // of one without samples it is not known where it ends
  std::span<const std::size_t> joined;   // the first of the clouds that it is joined to
  std::span<const std::uint8_t> is_cut;  // it is to be cut, and so are those that it is joined to
  OutwardNormals outward = {};
};

// The components of the model without the borders of all clouds, split so that each lies as a whole
// under each cloud that is cut, or outside: parts of regions under a cloud are new ones behind the
// others. Of such clouds the border is certain_border() and splinters, of others all of it. Where
// triangles are so large that both are the same the rim is as good as whole: if the cut is doubtful
// there, since no triangle lies under the cloud as a whole, the cloud is not cut.
// Errors: InputError unless there are as many of each. Complexity: as cut_under_cloud() for each
// group of joined clouds.
CutRegions cut_regions(const ModelIndex& model, const CloudsOnModel& clouds,
                       const CutOptions& options = {}, const SegmentOptions& segment = {},
                       const Execution& execution = {});

}  // namespace cocoon
