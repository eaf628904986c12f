// Point samples of surfaces that are known, for the quality benchmark.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon::bench {

struct QualityModel {
  std::string name;
  TriangleMesh truth;  // closed, oriented outward
  std::vector<Point> points;
  double spacing = 0;  // sqrt(area / points): the unit of distances
};

// The shapes: several genera, sharp edges, thin plates, several bodies, a cavity, uneven density, a
// part that was not scanned. Each with `count` points, evenly spread, unless its name says
// otherwise: then there may be some more or fewer.
std::vector<QualityModel> quality_models(std::size_t count);

// `count` points on the surface of `truth`, evenly spread.
QualityModel sampled(std::string name, TriangleMesh truth, std::size_t count, std::uint64_t seed);

// The points moved by a normal variable of deviation noise * spacing on each axis, and
// `outliers` * points more, uniform in the box of the model enlarged by a tenth.
QualityModel disturbed(const QualityModel& model, double noise, double outliers,
                       std::uint64_t seed);

}  // namespace cocoon::bench
