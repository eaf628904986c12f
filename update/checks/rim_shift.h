// How far a cloud seems to be out of register, told by its rim on unchanged surface.
#pragma once

#include <cstddef>

#include "geom/point.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"

namespace cocoon {

struct ShiftOptions {
  // Fewer matched rim points tell nothing.
  std::size_t min_points = 12;
  // Points farther off the shifted model than this many rim spacings are of the change, or of the
  // far side of a wall: they are left out in the next round.
  double max_residual = 1;
  // If fewer than this share of the points remain, no shift explains them.
  double min_share = 0.5;
  std::size_t rounds = 4;
  // Directions in which the rim tells nothing, as along a plane: a shift there costs this share of
  // what it would if all normals lay in it.
  double prior = 0.02;
  // A shift of more rim spacings than this is worth a warning, unless the samples contradict it
  // (cloud_shift), and is not believed (CloudReport::believed_shift): it may be of the change.
  double max_shift = 0.75;
  // Samples at most this many rim spacings from the model lie on it (cloud_shift).
  double fit_distance = 0.3;

  bool is_too_long(double shift, double rim_spacing) const {
    return shift > max_shift * rim_spacing;
  }
};

// The translation t of the cloud off its place (p - t is back there), in units of the coordinates,
// that explains best how high the rim points lie over the planes of their facets: least squares of
// dot(n, t) - height, in rounds. Where a cloud was moved along the surface most of its rim still
// lies on the model; the places where the surface turns tell. The zero vector if too few points are
// matched or agree.
// Complexity: O(rim). Deterministic, but for roundings, whatever the order of the loops. Errors:
// InputError for options out of range, and for the overlap of another rim, by its loops.
// Source: ours; point-to-plane registration (Chen & Medioni 1992) without rotation.
Vec3 rim_shift(const ModelIndex& model, const CloudRim& rim, const Overlap& overlap,
               const ShiftOptions& options = {});

// The same, asked of all samples of the cloud if it is too long to be believed: where more of them
// lie on the model as they are than moved back, the rim is of the change, and the shift zero.
// Complexity: O(rim), and for a long shift what squared_heights() takes for all samples. Errors: as
// rim_shift(). Source: ours.
Vec3 cloud_shift(const ModelIndex& model, Points samples, const CloudRim& rim,
                 const Overlap& overlap, const ShiftOptions& options = {});

}  // namespace cocoon
