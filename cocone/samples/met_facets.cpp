#include "cocone/samples/met_facets.h"

#include <algorithm>
#include <array>

#include "geom/lanes/vector_dispatch.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cocone/samples/met_facets.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>
// clang-format on

#ifndef COCOON_MET_FACETS_BLOCK
#define COCOON_MET_FACETS_BLOCK
namespace cocoon::met_facets_detail {

inline constexpr std::size_t cells_per_block = 128;
inline constexpr std::size_t max_lanes = 16;

// Facets of a few cells. What is stored at the end of a list may be a full vector.
struct FacetBlock {
  using List = std::array<std::uint32_t, 4 * cells_per_block + max_lanes>;
  alignas(64) List facets;   // canonical ids
  alignas(64) List mirrors;  // as the cells behind number them
  alignas(64) List here;     // the sides of their cells: nappes, and ranks from bit 8 on
  alignas(64) List behind;   // the sides of the cells behind
  alignas(64) List rows;
};

inline std::uint32_t bits_of(CornerSides sides) {
  return sides.nappes | std::uint32_t{sides.ranks} << 8;
}

}  // namespace cocoon::met_facets_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using namespace met_facets_detail;

using Words = hn::CappedTag<std::uint32_t, max_lanes>;
using Word = hn::Vec<Words>;

// The ids of a cell's facets that are canonical, and what goes with them. No branch depends on ids:
// half of the guesses would be wrong.
std::size_t list_canonical(const Cell* cells, const CornerSides* sides, std::size_t begin,
                           std::size_t end, FacetBlock& block) {
  const hn::CappedTag<std::uint32_t, 4> d;
  std::size_t count = 0;
  for (std::size_t c = begin; c < end; ++c) {
    const auto here = hn::Set(d, bits_of(sides[c]));
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto facets = hn::Iota(d, static_cast<std::uint32_t>(4 * c + i));
      const auto mirrors = hn::LoadU(d, &cells[c].neighbors[i].value);
      const auto is_canonical = hn::Lt(facets, mirrors);
      hn::StoreU(hn::Compress(facets, is_canonical), d, &block.facets[count]);
      hn::StoreU(hn::Compress(mirrors, is_canonical), d, &block.mirrors[count]);
      hn::StoreU(hn::Compress(here, is_canonical), d, &block.here[count]);
      count += hn::CountTrue(d, is_canonical);
    }
  }
  return count;
}

// The cells behind lie here and there in memory: all are asked for before the first is looked at.
void look_behind(const CornerSides* sides, std::size_t count, FacetBlock& block) {
  for (std::size_t k = 0; k < count; ++k) __builtin_prefetch(&sides[block.mirrors[k] >> 2]);
  for (std::size_t k = 0; k < count; ++k) block.behind[k] = bits_of(sides[block.mirrors[k] >> 2]);
}

// The rank in its cell of the vertex opposite to each facet.
HWY_INLINE Word opposite_ranks(Word facets, Word ranks) {
  const Words d;
  const Word three = hn::Set(d, 3);
  return hn::And(hn::Shr(ranks, hn::ShiftLeft<1>(hn::And(facets, three))), three);
}

// The sides of the corners of each facet in the order of their ids: bits 0 .. 2 the lower nappes,
// bits 4 .. 6 the upper ones.
HWY_INLINE Word sides_of_facets(Word facets, Word sides) {
  const Words d;
  const Word each = hn::Set(d, 0x11);
  const Word smaller =
      hn::Sub(hn::Shl(each, opposite_ranks(facets, hn::ShiftRight<8>(sides))), each);
  const Word closed =
      hn::Or(hn::And(smaller, sides), hn::AndNot(smaller, hn::ShiftRight<1>(sides)));
  return hn::And(closed, hn::Set(d, 0x77));
}

// From bits in the order of the ids to one bit for each vertex of the cell.
HWY_INLINE Word rows_of_facets(Word facets, Word ranks, Word met) {
  const Words d;
  const Word one = hn::Set(d, 1);
  const Word smaller = hn::Sub(hn::Shl(one, opposite_ranks(facets, ranks)), one);
  const Word by_rank = hn::Or(hn::And(smaller, met), hn::ShiftLeft<1>(hn::AndNot(smaller, met)));
  Word rows = hn::Zero(d);
  for (int j = 0; j < 4; ++j) {
    const Word rank = hn::And(hn::ShiftRightSame(ranks, 2 * j), hn::Set(d, 3));
    rows = hn::Or(rows, hn::ShiftLeftSame(hn::And(hn::Shr(by_rank, rank), one), j));
  }
  return rows;
}

// Keeps the first `count` facets that meet a cocone, with their rows. Returns how many there are.
std::size_t keep_met(std::size_t count, FacetBlock& block) {
  const Words d;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const Word facets = hn::Load(d, &block.facets[k]);
    const Word here = hn::Load(d, &block.here[k]);
    const Word same =
        hn::And(sides_of_facets(facets, here),
                sides_of_facets(hn::Load(d, &block.mirrors[k]), hn::Load(d, &block.behind[k])));
    const Word met = hn::AndNot(hn::Or(same, hn::ShiftRight<4>(same)), hn::Set(d, 7));
    const auto is_kept = hn::And(hn::Ne(met, hn::Zero(d)), hn::FirstN(d, count - k));
    const Word rows = rows_of_facets(facets, hn::ShiftRight<8>(here), met);
    hn::StoreU(hn::Compress(facets, is_kept), d, &block.facets[kept]);
    hn::StoreU(hn::Compress(rows, is_kept), d, &block.rows[kept]);
    kept += hn::CountTrue(d, is_kept);
  }
  return kept;
}

// Of the cells begin .. end - 1. Returns how many there are.
std::size_t fill_block(const Cell* cells, const CornerSides* sides, std::size_t begin,
                       std::size_t end, FacetBlock& block) {
  const std::size_t count = list_canonical(cells, sides, begin, end, block);
  look_behind(sides, count, block);
  return keep_met(count, block);
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(fill_block);

MetFacets met_facets(const Triangulation& triangulation, const IdVector<CellId, CornerSides>& sides,
                     std::size_t begin, std::size_t end) {
  using namespace met_facets_detail;
  MetFacets found;
  FacetBlock block;
  for (std::size_t first = begin; first < end; first += cells_per_block) {
    const std::size_t count = COCOON_VECTOR_CALL(fill_block)(
        triangulation.cell_records().raw().data(), sides.raw().data(), first,
        std::min(first + cells_per_block, end), block);
    for (std::size_t k = 0; k < count; ++k) {
      found.facets.push_back(FacetId(block.facets[k]));
      found.rows.push_back(static_cast<std::uint8_t>(block.rows[k]));
    }
  }
  return found;
}

}  // namespace cocoon

#endif  // HWY_ONCE
