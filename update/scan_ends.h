// Where scans end on the model, by their samples alone.
#pragma once

#include <span>
#include <vector>

#include "geom/ids.h"
#include "update/choose_regions.h"
#include "update/cloud/scan.h"
#include "update/model/model_index.h"
#include "update/segment_model.h"

namespace cocoon {

struct ScanEndOptions {
  // A facet was scanned if its centroid is no farther from a sample than this many spacings.
  double scanned = 2;
  // A sample farther from the model than this many spacings, as it lies and moved back by the shift
  // of its scan, shows that it was changed there.
  double off_model = 0.5;
  // Facets with such a sample within this many spacings of its scan are where the scanned surface
  // leaves the model, not where the scan ends.
  double change_reach = 4;
};

// The facets of `among` (ascending) that were not scanned, but have a neighbor that was, with all
// samples around on the model: there the scans end and the model goes on, as at a rim, whether or
// not their surfaces show one. Where material went or came, the samples leave the model. In the
// order of ids. Complexity: O(n log n) for the facets of `among` and the samples near them, and a
// few operations for each sample. Deterministic. Errors, of all here: InputError for options out of
// range. Source: ours.
std::vector<TriangleId> scan_ends(const ModelIndex& model, std::span<const TriangleId> among,
                                  std::span<const Scan> scans, const ScanEndOptions& options = {});

// Whether a facet of `among` lies outside of the box of all samples, enlarged by as much as may lie
// between a scanned facet and the nearest sample. Complexity: O(samples + facets of `among`).
bool reaches_beyond(const ModelIndex& model, std::span<const TriangleId> among,
                    std::span<const Scan> scans, const ScanEndOptions& options = {});
// The same for a box enlarged by this many spacings of each scan.
bool reaches_beyond(const ModelIndex& model, std::span<const TriangleId> among,
                    std::span<const Scan> scans, double reach);

// Whether the scan ends on the model in the regions that are to go under it, if these reach beyond
// the box of its samples. (Else nothing is lost that was not scanned around, and nothing is looked
// at.) Complexity: O(samples + facets of these regions), as scan_ends() where they reach beyond.
bool scan_ends_under(const ModelIndex& model, const Regions& regions, const CloudChoice& choice,
                     const Scan& scan, const ScanEndOptions& options = {});

}  // namespace cocoon
