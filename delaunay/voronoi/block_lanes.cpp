#include "delaunay/voronoi/block_lanes.h"

#include <array>
#include <cstdint>

#include "geom/lanes/vector_dispatch.h"

// Compile everything between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "delaunay/voronoi/block_lanes.cpp"
#include <hwy/foreach_target.h>
// clang-format off: must come after foreach_target.h
#include <hwy/highway.h>

#include "geom/lanes/circumcenter_lanes-inl.h"
#include "geom/lanes/gather-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace cocoon::HWY_NAMESPACE {

// The corners of cell_at(i) in lane i.
template <class CellAt>
HWY_INLINE std::array<Vectors, 4> gather_corners(const Point* points, CellAt cell_at) {
  std::array<Vectors, 4> corners;
  for (std::size_t j = 0; j < 4; ++j) {
    corners[j] = gather([&](std::size_t i) { return &points[cell_at(i).vertices[j].index()].x; });
  }
  return corners;
}

// Stores the corners of cell_at(k), cell_at(k + 1), ... in their lanes and returns them.
template <class CellAt>
HWY_INLINE std::array<Vectors, 4> load_lanes(const Point* points, CellAt cell_at, std::size_t k,
                                             CellBlock& block) {
  const auto corners = with_places(k, block.size, [&](auto place) {
    return gather_corners(points, [&](std::size_t i) -> const Cell& { return cell_at(place(i)); });
  });
  CircumcenterBatch& batch = block.batches[k / circumcenter_batch_size];
  for (std::size_t j = 0; j < 4; ++j) {
    store(corners[j], batch.corners[j], k % circumcenter_batch_size);
  }
  return corners;
}

// Asks for what is looked at in the next block, while the processor is busy with divisions: later
// it would wait for memory.
template <bool vectors, bool words>
HWY_INLINE void ask_for(const Cell* cells, const Point* points, const ReadSoon& soon) {
  for (std::size_t i = 0; i < hn::Lanes(Lanes()); ++i) {
    for (const VertexId v : cells[i].vertices) {
      __builtin_prefetch(&points[v.index()]);
      if constexpr (vectors) __builtin_prefetch(&soon.vectors[v.index()]);
      if constexpr (words) {
        __builtin_prefetch(static_cast<const std::uint64_t*>(soon.words) + v.index());
      }
    }
  }
}

template <bool vectors, bool words>
HWY_INLINE void centers_of_run_asking(const Point* points, std::span<const Cell> cells,
                                      const ReadSoon& soon, CellBlock& block) {
  const std::size_t lanes = hn::Lanes(Lanes());
  const std::size_t end = block.used().size() * circumcenter_batch_size;
  for (std::size_t k = 0; k < end; k += lanes) {
    const std::array<Vectors, 4> corners = load_lanes(
        points, [&](std::size_t i) -> const Cell& { return cells[i]; }, k, block);
    const std::size_t later = k + max_block_cells;
    if (later + lanes <= cells.size()) ask_for<vectors, words>(&cells[later], points, soon);
    Vectors centers;
    const Mask certified = circumcenters(corners, centers);
    CircumcenterBatch& batch = block.batches[k / circumcenter_batch_size];
    const std::size_t first = k % circumcenter_batch_size;
    batch.certified = (first == 0 ? 0 : batch.certified) | lane_bits(certified) << first;
    store(centers, batch.centers, first);
  }
}

// `cells`: all from the first one of the block on.
void centers_of_run(const Point* points, std::span<const Cell> cells, const ReadSoon& soon,
                    CellBlock& block) {
  if (soon.vectors != nullptr && soon.words != nullptr) {
    centers_of_run_asking<true, true>(points, cells, soon, block);
  } else if (soon.words != nullptr) {
    centers_of_run_asking<false, true>(points, cells, soon, block);
  } else {
    centers_of_run_asking<false, false>(points, cells, soon, block);
  }
}

template <class CellAt>
HWY_INLINE void corners_of(const Point* points, CellAt cell_at, CellBlock& block) {
  const std::size_t end = block.used().size() * circumcenter_batch_size;
  for (std::size_t k = 0; k < end; k += hn::Lanes(Lanes())) load_lanes(points, cell_at, k, block);
}

void corners_of_run(const Point* points, const Cell* cells, CellBlock& block) {
  corners_of(
      points, [&](std::size_t k) -> const Cell& { return cells[k]; }, block);
}

void corners_of_cells(const Point* points, const Cell* cells, const CellId* ids, CellBlock& block) {
  corners_of(
      points, [&](std::size_t k) -> const Cell& { return cells[ids[k].index()]; }, block);
}

}  // namespace cocoon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cocoon {

COCOON_VECTOR_EXPORT(centers_of_run);
COCOON_VECTOR_EXPORT(corners_of_run);
COCOON_VECTOR_EXPORT(corners_of_cells);

void load_centers(const Triangulation& triangulation, CellId first, std::size_t count,
                  const ReadSoon& soon, CellBlock& block) {
  block.size = count;
  const auto cells = triangulation.cell_records().span();
  COCOON_VECTOR_CALL(centers_of_run)
  (triangulation.points().raw().data(),
   cells.subspan(first.index(), triangulation.num_finite_cells() - first.index()), soon, block);
}

void load_corners(const Triangulation& triangulation, CellId first, std::size_t count,
                  CellBlock& block) {
  block.size = count;
  COCOON_VECTOR_CALL(corners_of_run)
  (triangulation.points().raw().data(), &triangulation.cell(first), block);
}

void load_corners(const Triangulation& triangulation, std::span<const CellId> cells,
                  CellBlock& block) {
  block.size = cells.size();
  COCOON_VECTOR_CALL(corners_of_cells)
  (triangulation.points().raw().data(), triangulation.cell_records().raw().data(), cells.data(),
   block);
}

}  // namespace cocoon

#endif  // HWY_ONCE
