// The Euler number of a model.
#pragma once

#include <cstddef>
#include <span>

#include "update/model/irregular_sides.h"
#include "update/model/model_index.h"

namespace cocoon {

// Of the vertices that a triangle uses, those at the place of an earlier one. Complexity: O(1) if
// the index knows that there are none, else O(vertices log vertices).
std::size_t repeated_vertices(const ModelIndex& model);

// V - E + F. Vertices: those that a triangle uses, those at one place once. An edge counts once for
// each two of its triangles, and for one left over: so sheets that touch along an edge count as if
// they were parted there. Of a closed mesh: 2 for each part, less 2 for each handle; a hole
// takes 1. `irregular`: irregular_sides() of the model. Complexity: O(1) for a mesh that is known
// to be smooth (ModelIndex::of_smooth()), else O(t log t).
std::ptrdiff_t euler_number(const ModelIndex& model, std::span<const EdgeSide> irregular);

// The same of a closed mesh by its counts, where `vertices` are those in use.
inline std::ptrdiff_t euler_number(std::size_t vertices, std::size_t triangles) {
  return static_cast<std::ptrdiff_t>(vertices) - static_cast<std::ptrdiff_t>(triangles / 2);
}

}  // namespace cocoon
