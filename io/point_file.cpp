#include "io/point_file.h"

#include <utility>

#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/file_format.h"
#include "io/mesh_file.h"
#include "io/obj.h"
#include "io/off.h"
#include "io/ply.h"
#include "io/xyz.h"

namespace cocoon {

PointCloud read_points(const std::filesystem::path& path) {
  if (format_of(path) == FileFormat::text) return read_xyz(read_file(path));
  if (!has_mesh_extension(path)) {
    throw file_error(path,
                     "extension " + in_quotes(extension_of(path)) +
                         " is not known; use .xyz, .pts, .txt, .csv, .ply, .obj, .off or .stl");
  }
  PointCloud cloud;
  cloud.points = std::move(read_mesh(path).points.raw());
  return cloud;
}

void write_points(const std::filesystem::path& path, Points points,
                  const MeshWriteOptions& options) {
  const std::string extension = extension_of(path);
  const bool is_text =
      extension == ".xyz" || extension == ".txt" || extension == ".csv" || extension == ".pts";
  const FileFormat format = format_of(path);
  if (!is_text && format != FileFormat::ply && format != FileFormat::obj &&
      format != FileFormat::off) {
    throw file_error(path, "points are not written with extension " + in_quotes(extension) +
                               "; use .xyz, .txt, .csv, .pts, .ply, .obj or .off");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_finite(points[i])) continue;
    throw file_error(path, "not written: point " + std::to_string(i) +
                               " has a coordinate that is not a finite number");
  }
  AtomicFile file(path);
  if (is_text) write_xyz(file, points, extension);
  if (format == FileFormat::ply) write_ply(file, points, options);
  if (format == FileFormat::obj) write_obj(file, points);
  if (format == FileFormat::off) write_off(file, points);
  file.commit();
}

}  // namespace cocoon
