// The bytes of a triangulation file (triangulation_file.h) without its checksum: a block that other
// files may contain.
#pragma once

#include <cstddef>
#include <filesystem>

#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "io/summed_file.h"

namespace cocoon {

// Precondition: the bytes in `file` so far are whole 64-bit words; so are those appended.
void append_triangulation(SummedFile& file, const Triangulation& triangulation);

std::size_t triangulation_block_size(const Triangulation& triangulation);

// A block as it was read.
struct UncheckedTriangulation {
  TriangulationArrays arrays;
  std::size_t finite_cells = 0;
};

// The next `size` bytes are a block. Looks only at its header. Errors: FileError.
UncheckedTriangulation read_triangulation(SummedReader& file, std::size_t size);

// All other checks of load_triangulation, to be made when the checksum is known to be right.
// `path`: for messages. Errors: FileError. Complexity: O(cells), parallel.
Triangulation checked_triangulation(const std::filesystem::path& path,
                                    UncheckedTriangulation triangulation,
                                    const Execution& execution = {});

}  // namespace cocoon
