// A 3D triangulation as a file of tetrahedra.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "delaunay/triangulation.h"
#include "io/atomic_file.h"

namespace cocoon {

struct TetrahedraWriteOptions {
  // VTU: numbers as text instead of base64. The other formats are always text.
  bool ascii = false;
};

// Writes the finite cells by extension: .vtu (VTK unstructured grid, for ParaView), .mesh (Medit)
// or .tet (text: a line "n m", n lines "x y z", m lines of four indices counted from 0).
//
// In all three, the points are the n different points of the input, each where the user's input had
// it first, and the indices of the m tetrahedra refer to these. Of points that differ in the sign
// of a zero only, the triangulation decides which one stands for both. Tetrahedra are in the order
// of the triangulation's cells, with orient3d > 0; the order of their corners is that of the cell.
// All bits of the coordinates are kept. Medit counts from 1 and gets the reference 0 everywhere.
//
// The file appears complete or not at all (io/atomic_file.h), with a batch together with the rest
// of it. Throws FileError for another extension and if it cannot be written. Complexity:
// O(points log points + cells).
void write_tetrahedra(const std::filesystem::path& path, const Triangulation& triangulation,
                      const TetrahedraWriteOptions& options = {}, FileBatch* batch = nullptr);

// One number for each vertex, or each finite cell, of the triangulation, in the order of ids; not
// copied.
struct NamedValues {
  std::string name;
  std::span<const double> values;
};
struct TetrahedraValues {
  std::vector<NamedValues> of_vertices;
  std::vector<NamedValues> of_cells;
};

// The same with values to look at, such as heights of poles or labels of cells (docs/examples/
// own_stages.cpp). Also throws InputError if there are not as many as vertices or finite cells, or
// the format is another than VTU, which has no place for them.
void write_tetrahedra(const std::filesystem::path& path, const Triangulation& triangulation,
                      const TetrahedraValues& values, const TetrahedraWriteOptions& options = {},
                      FileBatch* batch = nullptr);

}  // namespace cocoon
