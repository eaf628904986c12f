// Points as text, one a line: .xyz .pts .txt .csv and their relatives with normals or colors.
#pragma once

#include <string_view>

#include "geom/point.h"
#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/point_file.h"

namespace cocoon {

// Reads rows "x y z ...": the first three columns, or those that a header names x, y, z
// (io/encoding/column_names.h); others are not read.
//   - Columns are separated by blanks, by commas or by semicolons (blanks around those do not
//     matter). A row that mixes them among its first columns is refused: "0,5 1 2" is a decimal
//     comma. Rows separated by commas must all have the same number of columns, for the same
//     reason.
//   - # and // start a comment where a row or a column could start; blank lines are skipped.
//   - The first line may be a count alone (then as many rows must follow; more are read, too, and
//     the caller can tell by PointCloud::announced) or a header: names in its first three columns.
//     If some of x, y, z are named in it, then all three; PointCloud tells which columns were
//     taken. A comment before the rows that names all three is a header, too, if the first row has
//     as many columns. The first name may be empty, as pandas has it for the numbers of the rows;
//     names of rows in quotes need none.
//   - A .pwn file of a count, so many points, and then as many rows of three numbers of length 1
//     (within 1 %) has its normals there: these rows are left out.
// Throws FileError with the line for a row that has fewer than three columns or no number where one
// belongs (hexadecimal and Fortran's D are none), and for no rows. Rows that are not finite are
// kept and noted. Complexity: O(bytes).
PointCloud read_xyz(const FileBytes& file, NonFinitePoints& non_finite);

// Writes rows "x y z"; for ".csv" separated by commas under a header "x,y,z"; for ".pts" under a
// count.
void write_xyz(AtomicFile& file, Points points, std::string_view extension);

}  // namespace cocoon
