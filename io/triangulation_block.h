// The bytes of a triangulation file (triangulation_file.h) without its checksum: a block that other
// files may contain.
#pragma once

#include <filesystem>
#include <string_view>

#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "io/summed_file.h"

namespace cocoon {

// Precondition: the bytes in `file` so far are whole 64-bit words; so are those appended.
void append_triangulation(SummedFile& file, const Triangulation& triangulation);

std::size_t triangulation_block_size(const Triangulation& triangulation);

// `bytes` are a block as a whole. All checks of load_triangulation but that of the checksum.
// `path`: for messages. Errors: FileError.
Triangulation parse_triangulation(const std::filesystem::path& path, std::string_view bytes,
                                  const Execution& execution = {});

}  // namespace cocoon
