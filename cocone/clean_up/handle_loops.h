// Where the surface between two sides has a handle of the least girth (clean_up_cells.h, step 6).
// Source: ours, docs/stages/clean_up_cells.md.
#pragma once

#include <cstdint>
#include <vector>

#include "cocone/energy/doubtful_region.h"
#include "delaunay/star_cache.h"
#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

class HandleLoops {
 public:
  // Keeps references, which must outlive the object. O(1). `out`: the side of each cell.
  HandleLoops(const Triangulation& triangulation, StarCache& stars,
              const IdVector<CellId, std::uint8_t>& out)
      : triangulation_(triangulation), stars_(stars), out_(out) {}

  // Three vertices of the region each two of which are an edge of the surface, though the three
  // are no facet of it, by their ranks. Around a neck, through a tunnel, or around a thinner part
  // of the body; see is_handle(). Complexity: O(cells of the region + f log f +
  // sum of squared degrees) for f surface facets there, parallel but for their order.
  std::vector<Triangle> find(const DoubtfulRegion& region, const Execution& execution = {}) const;

  // Do the edges of the loop not divide the surface? Floods from both sides of it go on by turns,
  // ring by ring, until they meet, or one has come to its end or has more than `most_facets`, which
  // is a no. False, too, if one of the edges is not, or not any more, of two surface facets. True,
  // too, where a path leads from sheet to sheet over a sample at which the surface is pinched.
  // Complexity: O(what the smaller flood has), and once a byte for every facet asked for.
  bool is_handle(const Triangle& loop, std::size_t most_facets);

 private:
  struct Flood {
    std::vector<FacetId> facets;  // seen from inside
    std::size_t next = 0;
    std::uint8_t mark = 0;
  };
  bool begin(const Triangle& loop);
  bool enter(Flood& flood, FacetId f);
  bool grow(Flood& flood, const Triangle& loop);

  const Triangulation& triangulation_;
  StarCache& stars_;
  const IdVector<CellId, std::uint8_t>& out_;
  Flood left_;
  Flood right_;
  ZeroedArray<FacetId, std::uint8_t> mark_;  // of the flood that was there; zero between questions
};

}  // namespace cocoon
