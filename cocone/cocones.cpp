#include "cocone/cocones.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geom/id_vector.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 4096;

// The sides of a cell without the corner of one rank: [rank][nappes], bits 0 .. 2 the lower nappes
// of the others in the order of their ids, bits 3 .. 5 the upper ones.
using FacetSides = std::array<std::array<std::uint8_t, 256>, 4>;

constexpr FacetSides make_facet_sides() {
  FacetSides of_facets{};
  for (unsigned rank = 0; rank < 4; ++rank) {
    for (unsigned nappes = 0; nappes < 256; ++nappes) {
      unsigned kept = 0;
      for (unsigned r = 0, place = 0; r < 4; ++r) {
        if (r == rank) continue;
        kept |= (nappes >> r & 1U) << place | (nappes >> (4 + r) & 1U) << (3 + place);
        ++place;
      }
      of_facets[rank][nappes] = static_cast<std::uint8_t>(kept);
    }
  }
  return of_facets;
}

constexpr FacetSides facet_sides = make_facet_sides();

unsigned rank_of(CornerSides sides, int i) { return unsigned{sides.ranks} >> 2 * i & 3U; }

unsigned sides_of_facet(CornerSides sides, int i) {
  return facet_sides[rank_of(sides, i)][sides.nappes];
}

// A finite facet by its canonical id, and what its corners see.
struct SeenFacet {
  FacetId facet;
  FacetId mirror;
  unsigned bits;  // at first as sides_of_facet(); then the cocones met, in the order of the ids
};

constexpr std::size_t cells_per_block = 128;
using FacetBlock = std::array<SeenFacet, 4 * cells_per_block + 1>;

// Lists the facets whose canonical ids lie in the cells begin .. end and whose dual edge meets the
// cocone of a corner: unless both ends lie in the same nappe (meets_cocone in double_cone.h).
// Returns how many there are. No branch depends on ids or sides: half of the guesses would be
// wrong.
std::size_t list_facets(const Triangulation& triangulation,
                        const IdVector<CellId, CornerSides>& sides, std::size_t begin,
                        std::size_t end, FacetBlock& facets) {
  std::size_t canonical = 0;
  for (CellId c(begin); c.index() < end; ++c) {
    const Cell& cell = triangulation.cell(c);
    const CornerSides here = sides[c];
    for (int i = 0; i < 4; ++i) {
      const FacetId mirror = cell.neighbors[static_cast<std::size_t>(i)];
      facets[canonical] = {facet_id(c, i), mirror, sides_of_facet(here, i)};
      canonical += facet_id(c, i) < mirror ? 1U : 0U;
    }
  }
  // They lie here and there in memory: all are asked for in advance.
  for (std::size_t k = 0; k < canonical; ++k) {
    __builtin_prefetch(&sides[cell_of(facets[k].mirror)]);
  }
  std::size_t count = 0;
  for (std::size_t k = 0; k < canonical; ++k) {
    const SeenFacet seen = facets[k];
    const CornerSides behind = sides[cell_of(seen.mirror)];
    const unsigned same = seen.bits & sides_of_facet(behind, index_of(seen.mirror));
    const unsigned met = 7U & ~(same | same >> 3);
    facets[count] = {seen.facet, seen.mirror, met};
    count += met != 0 ? 1U : 0U;
  }
  return count;
}

// From bits in the order of the ids to one bit for each vertex of the cell.
std::uint8_t row_of_facet(const SeenFacet& seen, CornerSides sides) {
  const int i = index_of(seen.facet);
  unsigned row = 0;
  for (const int j : facet_corners[i]) {
    const unsigned rank = rank_of(sides, j);
    const unsigned place = rank - (rank > rank_of(sides, i) ? 1U : 0U);
    row |= (seen.bits >> place & 1U) << j;
  }
  return static_cast<std::uint8_t>(row);
}

// The facets of a range of cells that have bits.
struct Rows {
  std::vector<FacetId> facets;
  std::vector<std::uint8_t> rows;
};

Rows rows_of_cells(const Triangulation& triangulation, const IdVector<CellId, CornerSides>& sides,
                   std::size_t begin, std::size_t end) {
  Rows found;
  FacetBlock block;
  for (std::size_t first = begin; first < end; first += cells_per_block) {
    const std::size_t last = std::min(first + cells_per_block, end);
    const std::size_t count = list_facets(triangulation, sides, first, last, block);
    for (std::size_t k = 0; k < count; ++k) {
      const FacetId f = block[k].facet;
      found.facets.push_back(f);
      found.rows.push_back(row_of_facet(block[k], sides[cell_of(f)]));
    }
  }
  return found;
}

// Puts the parts of successive cells together. Ids of the other side and corners are looked up only
// now: lists that grow leave memory behind that nobody else gets.
Cocones put_together(const Triangulation& triangulation, std::vector<Rows> parts, double cosine,
                     const Execution& execution) {
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
    Rows rows = std::move(parts[part]);
    std::size_t place = places[part];
    for (std::size_t k = 0; k < rows.facets.size(); ++k, ++place) {
      const FacetId f = rows.facets[k];
      cocones.facets[place] = f;
      cocones.rows[place] = rows.rows[k];
      cocones.mirrors[place] = triangulation.mirror(f);
      cocones.corners[place] = triangulation.facet_vertices(f);
    }
  });
  return cocones;
}

}  // namespace

Cocones intersect_cocones(const Triangulation& triangulation, const Dual& dual, const Poles& poles,
                          const CoconeOptions& options, const Execution& execution) {
  return intersect_cocones(
      triangulation, cone_sides(triangulation, dual, poles.normals, options.cosine, execution),
      execution);
}

Cocones intersect_cocones(const Triangulation& triangulation, ConeSides sides,
                          const Execution& execution) {
  report_progress(execution, "intersect_cocones", 0);
  // Infinite cells come last: every finite facet has its canonical id in a finite cell.
  const std::size_t finite = triangulation.num_finite_cells();
  std::vector<Rows> found((finite + cells_per_chunk - 1) / cells_per_chunk);
  parallel_chunks(execution, finite, cells_per_chunk, [&](std::size_t begin, std::size_t end) {
    found[begin / cells_per_chunk] = rows_of_cells(triangulation, sides.of_cells, begin, end);
  });
  sides.of_cells = {};
  Cocones cocones = put_together(triangulation, std::move(found), sides.cosine, execution);
  report_progress(execution, "intersect_cocones", 1);
  return cocones;
}

unsigned Cocones::row(FacetId f) const {
  const auto place = std::lower_bound(facets.begin(), facets.end(), f);
  if (place == facets.end() || *place != f) return 0;
  return rows[static_cast<std::size_t>(place - facets.begin())];
}

}  // namespace cocoon
