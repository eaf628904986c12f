// How far apart the samples of a cloud lie, from one place to another.
#pragma once

#include "geom/triangle_mesh.h"

namespace cocoon {

struct SpacingRange {
  double low = 0;
  double high = 0;

  // Whether samples lie so many times as far apart in some places as in others; 0: never.
  bool is_uneven(double min_ratio) const {
    return min_ratio > 0 && low > 0 && high >= min_ratio * low;
  }
};

// Distances in an update are told in spacings of the cloud: if samples lie twice as far apart here
// as there, one spacing fits nowhere.
struct DensityOptions {
  // Clouds of even density have 1.2 to 1.9 times; those eight times as dense in one place as in
  // another, of which updates went wrong, 2 to 5. 0: all clouds count as even.
  double min_ratio = 2;
  // Of an uneven cloud few samples are looked at, too, no closer to each other than this share of
  // the distance where they lie far apart (SpacingRange::high).
  double spread = 0.7;
  // Their rim is taken if it is less doubtful than that of all samples, or good, its edges no
  // longer than this many of those of their surface.
  double max_stretch = 1.5;
};

// Of the mean edge lengths at the vertices of a surface those that a tenth are below and a tenth
// above; 0 without triangles. Complexity: O(triangles + vertices).
SpacingRange spacing_range(const TriangleMesh& surface);

}  // namespace cocoon
