// compare -o: how far each vertex of one surface is from the other, as a file that viewers color.
#pragma once

#include <optional>
#include <string>

#include "app/job.h"
#include "geom/triangle_mesh.h"
#include "io/mesh_file_options.h"

namespace cocoon::app {

struct DeviationOutput {
  std::string file;  // PLY: the other formats keep nothing of vertices
  MeshWriteOptions writing;
  // The distance that gets the full color; not given: three times the root mean square of
  // those of vertices in triangles.
  std::optional<double> full_color;
};

// Writes `a` with the distances of its vertices from `b` as properties `distance` (in units of the
// coordinates; negative inside b or, if that is open, behind its facets; from a cloud never) and
// red, green, blue (white on b, red outside, blue inside). Whether they have signs, and the full
// color, are in section "deviation" of the report and in the summary.
void write_deviation(Job& job, const TriangleMesh& a, const TriangleMesh& b,
                     const DeviationOutput& output);

}  // namespace cocoon::app
