// Labels of cells that are likely, and not known: whether a surface heeds them already, and which
// of two surfaces is the rougher one.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/known_labels.h"
#include "cocone/marking/cell_label.h"
#include "cocone/surface_mesh.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

// Those that are not unmarked. Complexity: O(cells).
std::size_t count_labels(const IdVector<CellId, CellLabel>& labels);

// Cells with the other label; `out`: 1 for cells outside. Errors: InputError unless there are as
// many of both. Complexity: O(cells).
std::size_t count_contradicted(const IdVector<CellId, CellLabel>& labels,
                               const IdVector<CellId, std::uint8_t>& out);

// The known labels, and the likely ones where nothing is known. Complexity: O(cells).
IdVector<CellId, CellLabel> with_likely(KnownLabels known);

// How much of a closed surface needs an explanation.
struct SurfaceRoughness {
  std::size_t parts = 0;
  // 2 parts - (V - T / 2): edges and vertices where it touches itself count as well.
  std::ptrdiff_t twice_handles = 0;
  std::size_t unused_vertices = 0;  // of the triangulation

  // No more parts and handles, but some if the other has any; and no more unused vertices than
  // `unused_per_part` for each part less.
  bool is_at_most(const SurfaceRoughness& other, std::size_t unused_per_part) const {
    if (parts > other.parts || twice_handles > other.twice_handles) return false;
    if (parts == 0 && other.parts > 0) return false;
    return unused_vertices <= other.unused_vertices + unused_per_part * (other.parts - parts);
  }
};

// `vertices`: of the triangulation. Complexity: O(t) for t triangles, near linear.
SurfaceRoughness surface_roughness(const SurfaceMesh& surface, std::size_t vertices,
                                   const Execution& execution = {});

}  // namespace cocoon
