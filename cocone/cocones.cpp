#include "cocone/cocones.h"

#include <algorithm>
#include <utility>

#include "cocone/inputs/stage_inputs.h"
#include "cocone/samples/met_facets.h"
#include "geom/messages/require_size.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 4096;
constexpr std::size_t facets_ahead = 16;

// Puts the parts of successive cells together. Ids of the other side and corners are looked up only
// now: lists that grow leave blocks of memory behind that are too small to be used again.
Cocones put_together(const Triangulation& triangulation, std::vector<MetFacets> parts,
                     double cosine, const Execution& execution) {
  std::vector<std::size_t> places(parts.size() + 1, 0);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    places[k + 1] = places[k] + parts[k].facets.size();
  }
  Cocones cocones;
  cocones.cosine = cosine;
  cocones.facets.resize(places.back());
  cocones.rows.resize(places.back());
  cocones.mirrors.resize(places.back());
  cocones.corners.resize(places.back());
  parallel_chunks(execution, parts.size(), 1, [&](std::size_t part, std::size_t) {
    const MetFacets found = std::move(parts[part]);
    std::size_t place = places[part];
    for (std::size_t k = 0; k < found.facets.size(); ++k, ++place) {
      // The cells lie a few apart, too far for the processor to see which one is next.
      const std::size_t later = std::min(k + facets_ahead, found.facets.size() - 1);
      __builtin_prefetch(&triangulation.cell(cell_of(found.facets[later])));
      const FacetId f = found.facets[k];
      cocones.facets[place] = f;
      cocones.rows[place] = found.rows[k];
      cocones.mirrors[place] = triangulation.mirror(f);
      cocones.corners[place] = triangulation.facet_vertices(f);
    }
  });
  return cocones;
}

}  // namespace

Cocones intersect_cocones(const Triangulation& triangulation, const Dual& dual, const Poles& poles,
                          const CoconeOptions& options, const Execution& execution) {
  require_options("intersect_cocones", options);
  require_dual("intersect_cocones", triangulation, dual);
  require_size("intersect_cocones", "normals of the poles", poles.normals.size(),
               triangulation.num_vertices());
  return intersect_cocones(
      triangulation, cone_sides(triangulation, dual, poles.normals, options.cosine, execution),
      execution);
}

Cocones intersect_cocones(const Triangulation& triangulation, ConeSides sides,
                          const Execution& execution) {
  require_sides("intersect_cocones", triangulation, sides);
  report_progress(execution, "intersect_cocones", 0);
  // Infinite cells come last: every finite facet has its canonical id in a finite cell.
  const std::size_t finite = triangulation.num_finite_cells();
  std::vector<MetFacets> found((finite + cells_per_chunk - 1) / cells_per_chunk);
  parallel_chunks(execution, finite, cells_per_chunk, [&](std::size_t begin, std::size_t end) {
    found[begin / cells_per_chunk] = met_facets(triangulation, sides.of_cells, begin, end);
  });
  sides.of_cells = {};
  Cocones cocones = put_together(triangulation, std::move(found), sides.cosine, execution);
  report_progress(execution, "intersect_cocones", 1);
  return cocones;
}

}  // namespace cocoon
