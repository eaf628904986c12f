// Facets drawn at random, which form no surface.
#pragma once

#include <cstdint>

#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "geom/random/random.h"

namespace cocoon {

inline FacetSet random_facets(const Triangulation& triangulation, double share,
                              std::uint64_t seed) {
  Random random(seed);
  FacetSet facets(triangulation.num_cells());
  for (const CellId c : triangulation.finite_cells()) {
    for (int i = 0; i < 4; ++i) {
      if (random.uniform(0, 1) < share) facets.insert(triangulation, facet_id(c, i));
    }
  }
  return facets;
}

}  // namespace cocoon
