// Colors, normals and other properties of PLY inputs, carried to the PLY output.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/job.h"
#include "cocone/reconstruct.h"
#include "geom/point.h"
#include "io/vertex_properties.h"

namespace cocoon::app {

// Whether an output of this name has a place for properties.
bool holds_properties(const std::string& output);

// The properties of the output's vertices: row i is that of origins[i]. `names` are the files of
// `tables`, for people. Sections "properties" (name, type, and the vertices without a value) and
// "properties_left_out" of the report; the latter, and vertices without a value, are warned of.
VertexProperties carried_properties(Job& job, std::span<const VertexProperties> tables,
                                    const std::vector<std::string>& names,
                                    std::span<const RowOrigin> origins);

// The properties of samples of a mesh: the first are its vertices, of which `table` is, the others
// have those of the nearest vertex. Complexity: O(n log n), if there are any properties.
VertexProperties properties_of_samples(const VertexProperties& table, Points samples);

// Of each vertex of a surface the row in a table of its points. Complexity: O(vertices).
std::vector<RowOrigin> rows_of(const ReconstructResult& surface);

// carried_properties for a surface of the points of one file. Errors and complexity: the same.
VertexProperties properties_of_surface(Job& job, const VertexProperties& table,
                                       const std::string& name, const ReconstructResult& surface);

}  // namespace cocoon::app
