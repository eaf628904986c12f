// Point clouds from and to files, by extension (upper or lower case).
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "geom/point.h"
#include "io/atomic_file.h"
#include "io/mesh_file_options.h"
#include "io/vertex_properties.h"

namespace cocoon {

struct PointReadOptions {
  // A point with a coordinate that is not a finite number (nan, inf, 1e999) is an error. With true
  // it is left out and counted: organized scans mark "nothing measured" in this way.
  bool skip_non_finite = false;
  // Keep what a PLY file says of its vertices beside their position, in PointCloud::properties.
  bool keep_properties = false;
};

struct PointCloud {
  std::vector<Point> points;  // in the order of the file
  // With skip_non_finite: which points of the file were not finite, ascending.
  std::vector<std::size_t> skipped;
  std::size_t faces = 0;    // mesh files: in the file, not read
  std::string header;       // text files: the line of column names, if any
  std::size_t columns = 0;  // text files: of the first row
  // Text files with names of columns: those that were taken as x, y, z, and whether their names
  // told so; if not, they are the first three.
  std::array<std::string, 3> coordinate_names;
  bool told_columns = false;
  std::size_t named_columns = 0;  // text files: how many columns the header names
  // Text files without names of columns. All are read as points, but the user should know: of rows
  // of more than three columns (10 rows at least) the first numbers are n, n + 1, n + 2 ...; or the
  // first row is 0 1 2 ..., which pandas writes as names, and others are not all whole numbers.
  bool first_column_counts_rows = false;
  bool first_row_counts_columns = false;
  // Text files: the count in a first line of its own, if there is one. More points may follow.
  std::optional<std::size_t> announced;
  std::size_t surplus_lines = 0;  // ascii PLY: see MeshReadReport
  std::size_t first_surplus_line = 0;
  std::size_t trailing_bytes = 0;  // PLY, OFF, STL: behind the last element, not read
  VertexProperties properties;     // one row per point; no column unless asked for
};

// Text (.xyz .pts .txt .csv .npts .pwn .asc): one point a line, see io/formats/xyz.h. Mesh
// files (.ply .obj .off .stl) give their vertices; STL is welded exactly.
// Throws FileError, with the line where there is one, for another extension, for what cannot be
// read, for a coordinate that is not a finite number (NonFiniteError, see the options), and for a
// text without a point. A file that says it holds no points (PLY, OFF, STL, a text with the count
// 0) gives none. Complexity: O(bytes).
PointCloud read_points(const std::filesystem::path& path, const PointReadOptions& options = {});

// Writes .xyz .txt .csv .pts (text, all bits kept), .ply (options apply), .obj and .off. The file
// appears complete or not at all (io/atomic_file.h), with a batch together with the rest of it.
// Throws FileError for another extension, for a point that is not finite, and if the file cannot be
// written.
void write_points(const std::filesystem::path& path, Points points,
                  const MeshWriteOptions& options = {}, FileBatch* batch = nullptr);

}  // namespace cocoon
