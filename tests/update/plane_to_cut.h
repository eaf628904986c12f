// A plane whose facets are cut, for tests of cuts.
#pragma once

#include <cstddef>

#include "tests/update/hand_made_models.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"

namespace cocoon::testing {

// Of unit squares, each cut in two triangles, without border.
struct PlaneToCut {
  static constexpr std::size_t side = 40;
  static constexpr double steps = 1024;  // that a unit costs

  TriangleMesh mesh = grid_plane(side);
  ModelIndex model{mesh};
  TriangleSet border = TriangleSet(mesh.triangles.size(), 0);

  // One of the triangles of a square.
  TriangleId at(std::size_t x, std::size_t y) const { return TriangleId(2 * (y * side + x)); }
};

}  // namespace cocoon::testing
