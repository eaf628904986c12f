// The procedural models after the examples of Woo & Dey 2005: an initial part, the part after a
// design change, and scans of what changed. A model is two implicit solids and where they differ
// (one file each, sample_block and so on); all the rest is common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/models/implicit_solid.h"
#include "io/models/surface_sampling.h"

namespace cocoon {

// What a model's own file gives.
struct SampleModelDesign {
  ImplicitSolid before;
  ImplicitSolid after;
  // One for each cloud: all places, on the old surface or the new one, at which the two differ and
  // which the cloud is to show; besides, any that they have in common. No two overlap.
  std::vector<SurfaceRegion> changes;
  std::size_t points = 0;                 // the paper's counts
  std::vector<std::size_t> cloud_points;  // for each cloud; the paper gives their sum
  double mesh_cell = 0;  // grid cell of the true mesh, smaller than the finest detail
};

// Of the initial cloud, and of all others together: five times as many are made and listed with
// their neighbors, some gigabytes.
inline constexpr std::size_t most_sample_points = 20'000'000;

struct SampleOptions {
  std::optional<std::size_t> points = std::nullopt;  // of the initial cloud; default: the paper's
  // Of all update clouds together, shared as the paper's; default: the paper's.
  std::optional<std::size_t> cloud_points = std::nullopt;
  std::uint64_t seed = 1;
  // Points are moved off the surface in random directions, by up to this fraction of the mean
  // spacing of their cloud, sqrt(area / points).
  double jitter = 0.02;
  bool operator==(const SampleOptions&) const = default;
};

struct SampleModel {
  std::vector<Point> initial;              // samples of the surface before the change
  std::vector<std::vector<Point>> clouds;  // scans of what the change made of it, see sample_model
  TriangleMesh truth;                      // the surface after the change: closed, oriented outward
  // The initial points, in increasing order, whose place on the old surface (before jitter) is not
  // on the new one.
  std::vector<PointId> replaced;
};

// The names that sample_model knows.
std::vector<std::string> sample_model_names();

// How many clouds a model has. Throws InputError for a name that is not known.
std::size_t sample_cloud_count(std::string_view name);

// Makes the model `name`: exactly the wanted numbers of points, evenly spread (blue noise).
// A cloud is what a careful operator scans, the change and not much else: the places of the new
// surface that are closer to the initial points which the change makes wrong, by a ratio of 0.65,
// than to the others (and those farther from the old surface than 0.3 of the initial spacing in any
// case). Its outline thus runs between the wrong points and the right ones, on places that the
// change has left as they were or nearly so: an update that works removes exactly the wrong ones.
// Throws InputError for a name it does not know (the message lists those it does), for fewer than
// four points in a cloud or more than most_sample_points, Cancelled, and InputError for a jitter
// that is not in [0, 1], and if none or all of the initial points lie in one of the changes.
// Complexity: O(n log n) for n points, and the polygonization of two solids, a few seconds at most.
// Deterministic: a function of design and options, the same bits on every machine if the design
// uses nothing but correctly rounded operations. Source of models and counts: Woo & Dey 2005,
// section 4.
SampleModel sample_model(std::string_view name, const SampleOptions& options = {},
                         const Execution& execution = {});

}  // namespace cocoon
