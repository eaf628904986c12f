// The readers: any bytes are a mesh, points, or a FileError. What is read is sound, and reads back
// after it was written.
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include "geom/errors.h"
#include "io/file_bytes.h"
#include "io/formats/obj.h"
#include "io/formats/off.h"
#include "io/formats/ply.h"
#include "io/formats/stl.h"
#include "io/formats/xyz.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "io/polygons/polygon_soup.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/temporary_folder.h"

namespace cocoon::fuzz {

namespace {

FileBytes file_of(Bytes bytes, const char* name) {
  FileBytes file;
  file.path = name;
  file.size = bytes.size();
  file.data = std::make_unique<char[]>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), file.data.get());
  return file;
}

void require_sound(const TriangleMesh& mesh) {
  for (const Point& p : mesh.points) require(is_finite(p), "points are finite");
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) require(v.index() < mesh.points.size(), "corners are vertices");
    require(t[0] != t[1] && t[1] != t[2] && t[2] != t[0], "no triangle repeats a corner");
  }
}

// Meshes that are worth a file: the rest of the search is faster without.
bool is_small(const TriangleMesh& mesh) {
  return mesh.points.size() < 64 && mesh.triangles.size() < 64;
}

void read_faces(Bytes bytes, const char* name,
                const std::function<PolygonSoup(const FileBytes&)>& read) {
  const FileBytes file = file_of(bytes, name);
  TriangleMesh mesh;
  VertexProperties properties;
  try {
    PolygonSoup soup = read(file);
    properties = std::move(soup.properties);
    MeshReadReport report;
    mesh = triangles_of(std::move(soup), file.path, report);
  } catch (const FileError&) {
    return;
  }
  require_sound(mesh);
  if (!is_small(mesh)) return;
  const TemporaryFolder folder;
  for (const bool ascii : {false, true}) {
    MeshReadReport report;
    VertexProperties again;
    write_mesh(folder / "a.ply", mesh, properties, {.ascii = ascii});
    require(read_mesh(folder / "a.ply", report, again) == mesh, "PLY reads back");
    properties.left_out.clear();
    // Which NaN it was does not survive text.
    if (!ascii && !properties.columns.empty()) require(again == properties, "properties do, too");
    require(again.columns.size() == properties.columns.size(), "no property is lost");
  }
  write_mesh(folder / "a.off", mesh);
  require(read_mesh(folder / "a.off") == mesh, "OFF reads back");
}

}  // namespace

void read_ply_target(Bytes bytes) {
  read_faces(bytes, "a.ply", [](const FileBytes& file) { return read_ply(file, true); });
}
void read_obj_target(Bytes bytes) { read_faces(bytes, "a.obj", read_obj); }
void read_off_target(Bytes bytes) { read_faces(bytes, "a.off", read_off); }
void read_stl_target(Bytes bytes) { read_faces(bytes, "a.stl", read_stl); }

void read_text_points_target(Bytes bytes) {
  const FileBytes file = file_of(bytes, "a.xyz");
  PointCloud cloud;
  try {
    NonFinitePoints non_finite;
    cloud = read_xyz(file, non_finite);
    non_finite.finish(file.path, true);
  } catch (const FileError&) {
    return;
  }
  for (const Point& p : cloud.points) require(is_finite(p), "points are finite");
  // A text that announces 0 points is one; written as .xyz it would be an empty file.
  if (cloud.points.empty() || cloud.points.size() > 64) return;
  const TemporaryFolder folder;
  for (const char* name : {"a.xyz", "a.csv", "a.pts"}) {
    write_points(folder / name, cloud.points);
    require(read_points(folder / name).points == cloud.points, std::string(name) + " reads back");
  }
}

}  // namespace cocoon::fuzz
