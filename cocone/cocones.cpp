#include "cocone/cocones.h"

#include <algorithm>
#include <array>

#include "geom/id_vector.h"

namespace cocoon {
namespace {

constexpr std::size_t cells_per_chunk = 4096;

// Carries one bit per corner from a cell to the cell before it. Seen from behind, the corners of a
// facet run the other way round, beginning anywhere: [facet before][facet behind][turn][bits].
using CornerBits = std::array<std::uint8_t, 16>;
using CornerMaps = std::array<std::array<std::array<CornerBits, 3>, 4>, 4>;

constexpr CornerMaps make_corner_maps() {
  CornerMaps maps{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (unsigned turn = 0; turn < 3; ++turn) {
        for (unsigned bits = 0; bits < 16; ++bits) {
          unsigned carried = 0;
          for (unsigned k = 0; k < 3; ++k) {
            const int from = facet_corners[j][(3 + turn - k) % 3];
            carried |= ((bits >> from) & 1U) << facet_corners[i][k];
          }
          maps[i][j][turn][bits] = static_cast<std::uint8_t>(carried);
        }
      }
    }
  }
  return maps;
}

constexpr CornerMaps corner_maps = make_corner_maps();

// Of the sides of a cell, bits 2 i and 2 i + 1: all three corners of facet i see it in their lower
// nappe, or all in the upper one.
constexpr std::array<std::uint8_t, 256> make_uniform_facets() {
  std::array<std::uint8_t, 256> uniform{};
  for (unsigned sides = 0; sides < 256; ++sides) {
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned corners = 15U & ~(1U << i);
      const unsigned lower = (sides & corners) == corners ? 1U : 0U;
      const unsigned upper = (sides >> 4 & corners) == corners ? 2U : 0U;
      uniform[sides] = static_cast<std::uint8_t>(uniform[sides] | (lower | upper) << 2 * i);
    }
  }
  return uniform;
}

constexpr std::array<std::uint8_t, 256> uniform_facets = make_uniform_facets();

// A finite facet by its two ids, the smaller one first.
struct FacetPair {
  FacetId canonical;
  FacetId mirror;
};

constexpr std::size_t cells_per_block = 128;
using FacetBlock = std::array<FacetPair, 4 * cells_per_block + 1>;

// Lists the facets whose canonical ids lie in the cells begin .. end, but for most of those that
// meet no cocone: normals of neighbors nearly always point to the same side, and then no turn needs
// to be known. Asks for what row_of_facet is to read behind the others, which lies here and there
// in memory. Returns how many there are. No branch depends on ids or sides: half of the guesses
// would be wrong.
std::size_t list_facets(const Triangulation& triangulation,
                        const IdVector<CellId, CornerSides>& sides, std::size_t begin,
                        std::size_t end, FacetBlock& facets) {
  std::size_t canonical = 0;
  for (CellId c(begin); c.index() < end; ++c) {
    const Cell& cell = triangulation.cell(c);
    for (int i = 0; i < 4; ++i) {
      const FacetPair pair{facet_id(c, i), cell.neighbors[static_cast<std::size_t>(i)]};
      facets[canonical] = pair;
      canonical += pair.canonical < pair.mirror ? 1U : 0U;
    }
  }
  std::size_t count = 0;
  for (std::size_t k = 0; k < canonical; ++k) {
    const FacetPair pair = facets[k];
    const int here = uniform_facets[sides[cell_of(pair.canonical)]] >> 2 * index_of(pair.canonical);
    const int behind = uniform_facets[sides[cell_of(pair.mirror)]] >> 2 * index_of(pair.mirror);
    facets[count] = pair;
    count += (here & behind & 3) == 0 ? 1U : 0U;
  }
  for (std::size_t k = 0; k < count; ++k) {
    __builtin_prefetch(&triangulation.cell(cell_of(facets[k].mirror)));
  }
  return count;
}

// The row of a facet: its dual edge meets the cocone of a corner unless both ends lie in the same
// nappe (meets_cocone in double_cone.h, for three corners at once).
unsigned row_of_facet(const Triangulation& triangulation,
                      const IdVector<CellId, CornerSides>& sides, const FacetPair& facet) {
  const auto& [f, g] = facet;
  const auto i = static_cast<std::size_t>(index_of(f));
  const auto j = static_cast<std::size_t>(index_of(g));
  const VertexId first = triangulation.vertex(cell_of(f), facet_corners[i][0]);
  const CellId behind = cell_of(g);
  const unsigned turn = (triangulation.vertex(behind, facet_corners[j][1]) == first ? 1U : 0U) +
                        (triangulation.vertex(behind, facet_corners[j][2]) == first ? 2U : 0U);
  const CornerBits& map = corner_maps[i][j][turn];
  const unsigned here = sides[cell_of(f)];
  const unsigned lower = here & map[sides[behind] & 15U];
  const unsigned upper = (here >> 4) & map[sides[behind] >> 4];
  return 15U & ~(lower | upper | 1U << i);
}

// The facets of a range of cells that have bits.
struct Rows {
  std::vector<FacetId> facets;
  std::vector<std::uint8_t> rows;
};

Rows rows_of_cells(const Triangulation& triangulation, const IdVector<CellId, CornerSides>& sides,
                   std::size_t begin, std::size_t end) {
  Rows found;
  std::size_t size = 0;
  FacetBlock block;
  for (std::size_t first = begin; first < end; first += cells_per_block) {
    const std::size_t last = std::min(first + cells_per_block, end);
    const std::size_t count = list_facets(triangulation, sides, first, last, block);
    found.facets.resize(size + count + 1);
    found.rows.resize(size + count + 1);
    for (std::size_t k = 0; k < count; ++k) {
      const unsigned row = row_of_facet(triangulation, sides, block[k]);
      found.facets[size] = block[k].canonical;
      found.rows[size] = static_cast<std::uint8_t>(row);
      size += row != 0 ? 1U : 0U;
    }
  }
  found.facets.resize(size);
  found.rows.resize(size);
  return found;
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
  Cocones cocones{{}, {}, sides.cosine};
  std::size_t facets = 0;
  for (const Rows& part : found) facets += part.facets.size();
  cocones.facets.reserve(facets);
  cocones.rows.reserve(facets);
  for (Rows& part : found) {
    cocones.facets.insert(cocones.facets.end(), part.facets.begin(), part.facets.end());
    cocones.rows.insert(cocones.rows.end(), part.rows.begin(), part.rows.end());
    part = {};  // large at a million points: not both of all at once
  }
  report_progress(execution, "intersect_cocones", 1);
  return cocones;
}

unsigned Cocones::row(FacetId f) const {
  const auto place = std::lower_bound(facets.begin(), facets.end(), f);
  if (place == facets.end() || *place != f) return 0;
  return rows[static_cast<std::size_t>(place - facets.begin())];
}

}  // namespace cocoon
