// What the writers of mesh and point files can be asked for, and what the mesh readers tell.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geom/errors.h"

namespace cocoon {

struct MeshWriteOptions {
  // PLY and STL: text instead of binary little endian. The other formats are always text.
  bool ascii = false;
  // PLY: `float` instead of `double` coordinates, for readers that take only those. Rounds.
  // (Binary STL is float by its definition.)
  bool single_precision = false;
};

struct MeshReadOptions {
  // A point with a coordinate that is not a finite number is an error. With true it is left out of
  // files without faces, and counted; faces need all of their corners.
  bool skip_non_finite = false;
};

// A point of a file has a coordinate that is not a finite number.
class NonFiniteError : public FileError {
 public:
  NonFiniteError(const std::string& message, bool can_be_skipped)
      : FileError(message), can_be_skipped_(can_be_skipped) {}
  // Whether skip_non_finite would leave such points out.
  bool can_be_skipped() const { return can_be_skipped_; }

 private:
  bool can_be_skipped_;
};

// What a reader met that the mesh itself does not show. All 0 but `faces`: a plain triangle mesh.
struct MeshReadReport {
  std::size_t faces = 0;                 // in the file
  std::size_t polygons = 0;              // faces with more than three corners, cut into triangles
  std::size_t short_faces = 0;           // faces with fewer than three corners, left out
  std::size_t degenerate_triangles = 0;  // triangles with a repeated corner, left out
  // Ascii PLY: lines of any element with more values than announced, the last of which are not
  // read, and the number of the first one.
  std::size_t surplus_lines = 0;
  std::size_t first_surplus_line = 0;
  std::size_t trailing_bytes = 0;    // behind the last element or facet, not read
  std::vector<std::size_t> skipped;  // with skip_non_finite: which points of the file, ascending

  // Faces without area.
  std::size_t left_out() const { return short_faces + degenerate_triangles; }
};

}  // namespace cocoon
