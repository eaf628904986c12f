// A triangulation as a binary file, to be loaded again without being built again.
//
//   bytes        content (all numbers little-endian)
//   8            "COCOONDT"
//   4, 4         version (1), zero
//   8, 8, 8, 8   numbers of vertices n, cells m, finite cells, input points k
//   24 n         coordinates x y z, 64-bit floating point
//   32 m         cells: four vertices, four neighbors, 32-bit; finite cells first
//   4 k          the vertex of each input point, 32-bit; zero bytes up to a multiple of 8
//   8            checksum of all before (io/summed_file.h)
#pragma once

#include <filesystem>

#include "delaunay/triangulation.h"
#include "geom/execution.h"

namespace cocoon {

// Writes all of it: the same arrays come back. The file appears complete or not at all
// (io/atomic_file.h). Errors: FileError. Complexity: O(n + m + k).
void save_triangulation(const std::filesystem::path& path, const Triangulation& triangulation);

struct LoadTriangulationOptions {
  // Also certifies with check_delaunay that this is the Delaunay triangulation of its points. Takes
  // some ten times as long as loading; without it, a file made to deceive can hold any
  // triangulated 3-manifold.
  bool certify = false;
};

// Reads what save_triangulation wrote. Before anything is believed: the file's length is what its
// header says, the checksum is right, coordinates are finite, ids are in range, cells have four
// different vertices with the infinite one where it belongs, neighbors name each other and share
// their triangle, and every vertex has an input point.
// Errors: FileError, one line that names the first thing that is wrong. Complexity: O(n + m + k).
Triangulation load_triangulation(const std::filesystem::path& path,
                                 const LoadTriangulationOptions& options = {},
                                 const Execution& execution = {});

}  // namespace cocoon
