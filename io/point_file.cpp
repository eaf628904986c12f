#include "io/point_file.h"

#include <utility>
#include <vector>

#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/file_format.h"
#include "io/formats/obj.h"
#include "io/formats/off.h"
#include "io/formats/ply.h"
#include "io/formats/xyz.h"
#include "io/input_file.h"
#include "io/polygons/polygon_soup.h"
#include "io/read_polygon_soup.h"

namespace cocoon {

PointCloud read_points(const std::filesystem::path& path, const PointReadOptions& options) {
  const FileFormat format = format_of(path);
  if (format == FileFormat::other) {
    require_input(path);  // else its name is wrong in another way
    if (is_packed(path)) {
      throw file_error(path, "is packed (" + extension_of(path) + "); unpack it first");
    }
    throw file_error(
        path,
        "extension " + in_quotes(extension_of(path)) +
            " is not known; use .xyz, .pts, .txt, .csv, .ply, .obj, .off or .stl" +
            (is_scan_of_others(path) ? " (PDAL and CloudCompare convert such scans to PLY)" : ""));
  }
  PointCloud cloud;
  NonFinitePoints non_finite;
  if (format == FileFormat::text) {
    cloud = read_xyz(read_file(path), non_finite);
  } else {
    PolygonSoup soup = read_polygon_soup(path, options.keep_properties);
    check_corners(soup, path);
    non_finite = soup.non_finite;
    cloud.faces = soup.face_ends.size();
    cloud.points = std::move(soup.points);
    cloud.properties = std::move(soup.properties);
    cloud.surplus_lines = soup.surplus_lines;
    cloud.first_surplus_line = soup.first_surplus_line;
    cloud.trailing_bytes = soup.trailing_bytes;
  }
  cloud.properties.rows = cloud.points.size();
  if (options.skip_non_finite) {
    cloud.skipped = remove_non_finite(cloud.points, cloud.properties);
  } else {
    non_finite.finish(path, true);
  }
  return cloud;
}

void write_points(const std::filesystem::path& path, Points points, const MeshWriteOptions& options,
                  FileBatch* batch) {
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
  file.commit(batch);
}

}  // namespace cocoon
