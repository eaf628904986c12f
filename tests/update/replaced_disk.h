// A part of a plane that is replaced, for tests of what is replaced and of what is left.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tests/update/hand_made_models.h"
#include "update/overlapping_facets.h"
#include "update/replace_points.h"
#include "update/segment_model.h"
#include "update/trace_border.h"

namespace cocoon::testing {

// A plane, the rim of a round cloud, and the choice "inside is replaced". Vertices go by the sides
// of the rim, on which there are no samples.
struct ReplacedDisk {
  TriangleMesh model = grid_plane(20);
  std::vector<CloudRim> rims = {rim_of({circle(60, {10, 10, 0}, 6.3)})};
  std::vector<std::vector<Point>> clouds = {{{10, 10, 2}, {11, 10, 2}, {9.5, 10, 1.5}}};
  Regions regions;
  RegionChoice choice;

  ReplacedDisk() {
    const ModelIndex index(model);
    const Border border = trace_border(index, rims[0], overlapping_facets(index, rims[0]));
    regions = segment_model(model, border.facets);
    choice.replaced = IdVector<RegionId, std::uint8_t>(regions.regions.size(), 0);
    choice.replaced[regions.group_of_vertex[nearest_vertex(model, {10, 10, 0})]] = 1;
  }
  Replacement replace(const ReplaceOptions& options = {.scanned = {.rim_zone = 0}},
                      const SaidVertices& said = {}) const {
    return replace_points(ModelIndex(model), regions, choice, rims, clouds, clouds, options, said);
  }
};

}  // namespace cocoon::testing
