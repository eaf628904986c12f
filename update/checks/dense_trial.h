// Whether to make a model with large triangles dense and to update it again, as those of CAD
// programs: an update makes the new mesh from points alone, and from few vertices it makes another
// shape. And which of the two updates is the better one.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/checks/lost_surface.h"
#include "update/cloud/scan.h"
#include "update/update_model.h"

namespace cocoon {

struct DenseTrialOptions {
  // An update that is yet to come is looked at only if triangles that are too large (large_side)
  // are at least this share of the model's area; one that is refused, if this one. Others lose
  // less than is told.
  double min_large_share = 0.01;
  double min_large_share_if_refused = 0.5;
  // The spacing of a scan is this part of the distance of its samples from the neighbor of this
  // rank. With the nearest, views that overlap in one file would seem much denser than they are.
  std::size_t neighbor = 8;
  double neighbor_share = 0.5;
  // Samples are as far apart as those of the scans, but no more than about so many: 20 s of work.
  double most_samples = 5e5;
  // How much has to be lost, so that it is worth the time, and at most.
  LostSurfaceOptions lost = {};
  // The second update is better if what it alone loses or makes up is at most this part of what the
  // first alone does, if that is ok. Negative: it never is.
  double max_given_up = 0.5;
};

// All throw InputError for options out of range. Source: ours, docs/update.md#outcomes.

// The spacing at which to sample the model: that of the coarsest scan, or the one that gives
// most_samples. 0: neither have the clouds any, nor has the model an area. Complexity: O(n log n +
// t).
double dense_spacing(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                     const DenseTrialOptions& options = {});

// Whether triangles that are too large for the scans and the change (large_side) are at least this
// share of the model's area, and there are any. Complexity: O(n log n + t).
bool has_large_triangles(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                         double share, const DenseTrialOptions& options = {});

// Whether the update of the model as it is loses so much by large triangles that a trial is worth
// its time; or, if it is refused, whether large triangles are min_large_share_if_refused of the
// area. `lost`: of an update that is ok. Complexity: as has_large_triangles().
bool is_worth_dense_trial(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                          const UpdateResult& result, const LostSurface& lost,
                          const DenseTrialOptions& options = {});

// A model, and what became of it. Refers to both.
struct TrialUpdate {
  const TriangleMesh& model;
  const UpdateResult& result;
};

// Areas of the model as it is where nothing was scanned, by which of the two updates passes there;
// and what they have made up.
struct KeptAreas {
  double all = 0;
  double only_dense = 0;  // the one of the dense model
  double only_first = 0;  // where it is no part of what the change of the dense model replaced
  double neither = 0;     // likewise
  double made_up_by_dense = 0;
  double made_up_by_first = 0;
};

// `first`, which need not be ok, is the update of the model as it is; `dense`, which is, that of
// the same made dense. `scans`: their clouds, as in `dense` (scans_of). Errors: InputError for
// options out of range. Complexity: as UnscannedPlaces, of all three meshes.
KeptAreas kept_areas(const TrialUpdate& first, const TrialUpdate& dense,
                     std::span<const Scan> scans, const AstrayOptions& options = {});

// Whether by the update of the dense model less is lost and made up. Where the first one is refused
// there is nothing to compare: then it may lose and make up min_area_share at most. Complexity:
// O(1).
bool keeps_more(const KeptAreas& areas, bool first_is_ok, const DenseTrialOptions& options = {});

}  // namespace cocoon
