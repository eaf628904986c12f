// The procedural models after the examples of Woo & Dey 2005: an initial part, the part after a
// design change, and scans of what changed. A model is two implicit solids and the scanned regions
// (one file each, sample_block and so on); all the rest is common.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/implicit_solid.h"
#include "io/surface_sampling.h"

namespace cocoon {

// What a model's own file gives.
struct SampleModelDesign {
  ImplicitSolid before;
  ImplicitSolid after;
  std::vector<SurfaceRegion> scanned;  // one for each cloud: what it covers of the new surface
  std::size_t points = 0;              // the paper's counts
  std::vector<std::size_t> cloud_points;
  double mesh_cell = 0;  // grid cell of the true mesh, smaller than the finest detail
};

struct SampleOptions {
  std::optional<std::size_t> points = std::nullopt;  // of the initial cloud; default: the paper's
  std::optional<std::size_t> cloud_points =
      std::nullopt;  // of each update cloud; default: the paper's
  std::uint64_t seed = 1;
  // Points are moved off the surface in random directions, by up to this fraction of the mean
  // spacing of their cloud, sqrt(area / points).
  double jitter = 0.02;
  bool operator==(const SampleOptions&) const = default;
};

struct SampleModel {
  std::vector<Point> initial;              // samples of the surface before the change
  std::vector<std::vector<Point>> clouds;  // samples of the scanned parts of the surface after it
  TriangleMesh truth;                      // the surface after the change: closed, oriented outward
  // The initial points, in increasing order, whose place on the old surface (before jitter) is not
  // on the new one.
  std::vector<PointId> replaced;
};

// The names that sample_model knows.
std::vector<std::string> sample_model_names();

// Makes the model `name`: exactly the wanted numbers of points, evenly spread (blue noise).
// Throws InputError for a name it does not know (the message lists those it does), for fewer than
// four points or cloud points, or for a jitter that is not in [0, 1].
// Complexity: O(n log n) for n points, and the polygonization of two solids, a few seconds at most.
// Deterministic: a function of name and options, the same bits on every machine, since it uses
// nothing but correctly rounded operations and its own random numbers.
// Source of models and counts: Woo & Dey 2005, section 4.
SampleModel sample_model(std::string_view name, const SampleOptions& options = {});

// The same for a design of one's own.
SampleModel sample_design(const SampleModelDesign& design, const SampleOptions& options = {});

}  // namespace cocoon
