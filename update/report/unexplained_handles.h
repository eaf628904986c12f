// Handles of an updated model that the rims of its clouds do not explain.
#pragma once

#include <cstddef>
#include <span>

#include "update/model/model_index.h"
#include "update/report/cloud_report.h"

namespace cocoon {

// A sphere with b holes that is sewn into b holes of a connected surface adds b - 1 handles to it,
// and fewer if it joins parts: a drilled hole, with a rim at each mouth, is one handle more. So
// what an update adds beyond that are handles of the scans themselves, or wrong ones. Of each cloud
// the loops on the model count, and one that may be lost where its surface is torn
// (CloudRim::is_partial). `before` and `after`: Euler numbers of the models.
// Complexity: O(loops). Source: ours.
std::size_t unexplained_handles(std::span<const CloudReport> clouds, std::ptrdiff_t before,
                                std::ptrdiff_t after);

// How many vertices of the model's triangles lie at the place of an earlier one, as where contacts
// were split: they are one vertex of the updated model. Complexity: O(v), O(1) if it is known that
// there are none.
std::size_t repeated_vertices(const ModelIndex& model);

}  // namespace cocoon
