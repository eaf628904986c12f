// Samples that lie closer together than the vertices of the model: in layers, often.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "update/cloud/scan.h"
#include "update/joined_clouds.h"
#include "update/model/model_index.h"

namespace cocoon {

struct CrowdedOptions {
  // As a share of the median edge at the vertices that went.
  double distance = 0.62;
  // Of all samples of a cloud, fewer mean nothing.
  double min_share = 0.25;
  // Samples lie in layers if they are as thick (layer_thickness) around those that keep the
  // distance, or that to the eighth neighbor (few_of_layers), if that is less: farther apart, two
  // walls of a part lie over each other. Where rims are refused each cloud is asked by itself,
  // within LayerOptions::spread times the distance to the eighth neighbor (when_refused).
  double min_thickness = 0.13;
  // Clouds are not looked at where the distance is longer than so many times that to the eighth
  // neighbor: the edges are those of a mesh whose vertices are no samples, as of CAD.
  double max_coarseness = 3.5;
  // Whether a surface without those that crowd in layers is tried, too.
  bool leave_out = true;
  // What layers make, in times their thickness: handles with a way around or through them that is
  // no longer, and parts with a box that is no larger. Where layers lie far apart both are wider.
  double max_width = 36;
  // The other surface is taken if of wider handles it lacks no more than this share of the narrow
  // ones that it is rid of: some of what layers make is wider, and some narrow handles are true.
  double max_lost_share = 1.0 / 3;
};

// Of clouds in which they are many; those that are joined are one.
struct CrowdedSamples {
  double distance = 0;
  std::size_t closer = 0;     // would have to go so that the others keep it (thin_points)
  std::size_t of = 0;         // samples of these clouds in all, like these without equal ones
  double thickness = 0;       // of the thickest of them, as a share of where it was asked
  double depth = 0;           // the same as a length; of all the largest
  std::size_t in_layers = 0;  // of those that are closer, equal ones counted each
  std::vector<SampleFlags> is_in_layers;  // for each cloud given: is it one of these
};

// Which samples lie closer to others of their cloud than a distance that the model does without.
// Views out of register and noise make layers of them, with handles, hollows and shreds between:
// where the surface has such, it may help to leave these samples out, which a finer scan of a true
// detail would miss. `removed`: the vertices that went; `joined`: all of `clouds`, each in one of
// them, or none if each is by itself. Complexity: O(n log n) for n samples. Deterministic; the
// samples of a cloud may have any order. Errors: InputError for options out of range, and for
// vertices and clouds that are not there. Source: ours, docs/departures.md, departure 25.
CrowdedSamples crowded_samples(const ModelIndex& model, std::span<const VertexId> removed,
                               std::span<const JoinedCloud> joined,
                               std::span<const std::vector<Point>> clouds,
                               const CrowdedOptions& options = {}, const Execution& execution = {});

}  // namespace cocoon
