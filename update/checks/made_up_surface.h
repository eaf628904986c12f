// What a new surface makes up between vertices of the model where nothing was scanned.
#pragma once

#include <cstddef>
#include <span>

#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/checks/model_places.h"

namespace cocoon {

struct MadeUpOptions {
  // A place is made up if it is farther from the model than this many spacings of the scans, the
  // largest of several. Other diagonals of four samples, and corners between rows of vertices, are
  // nearer.
  double distance = 1;
};

struct MadeUpSurface {
  std::size_t places = 0;  // middles of triangles, or of parts of large ones
  double area = 0;         // that they stand for, in squares of the coordinates' unit
  Point farthest;          // of them, from the model
  double distance = 0;     // of that one
};

// Of the new triangles `added` of the updated mesh, whose vertices are all of the model: what is
// far from its surface, though no sample is near. Where the change takes vertices away without
// samples in their place, as in a shadow, that is how it is closed; elsewhere something went wrong.
// Complexity: O(log n) for each triangle, and O(t log t) if any is where nothing was scanned.
// `unscanned`: made of the scans.
// Errors: InputError for options out of range. Source: ours.
MadeUpSurface made_up_surface(const TriangleMesh& model, const TriangleMesh& updated,
                              std::span<const TriangleId> added, const UnscannedPlaces& unscanned,
                              const MadeUpOptions& options = {});

}  // namespace cocoon
