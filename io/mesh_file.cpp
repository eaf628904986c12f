#include "io/mesh_file.h"

#include <string>

#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/file_format.h"
#include "io/obj.h"
#include "io/off.h"
#include "io/ply.h"
#include "io/polygon_soup.h"
#include "io/stl.h"

namespace cocoon {

namespace {

void check_extension(const std::filesystem::path& path) {
  if (has_mesh_extension(path)) return;
  throw file_error(path, "extension " + in_quotes(extension_of(path)) +
                             " is not that of a mesh; use .ply, .obj, .off or .stl");
}

void check_writable(const std::filesystem::path& path, const TriangleMesh& mesh) {
  for (VertexId v : mesh.points.ids()) {
    if (is_finite(mesh.points[v])) continue;
    throw file_error(path, "not written: vertex " + std::to_string(v.value) +
                               " has a coordinate that is not a finite number");
  }
  for (TriangleId t : mesh.triangles.ids()) {
    for (VertexId v : mesh.triangles[t]) {
      if (v.index() < mesh.points.size()) continue;
      throw file_error(path, "not written: triangle " + std::to_string(t.value) +
                                 " has a corner that is no vertex");
    }
  }
}

}  // namespace

bool has_mesh_extension(const std::filesystem::path& path) {
  const FileFormat format = format_of(path);
  return format != FileFormat::text && format != FileFormat::other;
}

TriangleMesh read_mesh(const std::filesystem::path& path, MeshReadReport& report) {
  check_extension(path);
  PolygonSoup soup;
  {
    const FileBytes file = read_file(path);
    switch (format_of(path)) {
      case FileFormat::ply:
        soup = read_ply(file);
        break;
      case FileFormat::obj:
        soup = read_obj(file);
        break;
      case FileFormat::off:
        soup = read_off(file);
        break;
      case FileFormat::stl:
        soup = read_stl(file);
        break;
      case FileFormat::text:
      case FileFormat::other:
        break;
    }
  }
  return triangles_of(std::move(soup), path, report);
}

TriangleMesh read_mesh(const std::filesystem::path& path) {
  MeshReadReport report;
  return read_mesh(path, report);
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshWriteOptions& options) {
  check_extension(path);
  check_writable(path, mesh);
  AtomicFile file(path);
  switch (format_of(path)) {
    case FileFormat::ply:
      write_ply(file, mesh, options);
      break;
    case FileFormat::obj:
      write_obj(file, mesh);
      break;
    case FileFormat::off:
      write_off(file, mesh);
      break;
    case FileFormat::stl:
      write_stl(file, mesh, options);
      break;
    case FileFormat::text:
    case FileFormat::other:
      break;
  }
  file.commit();
}

}  // namespace cocoon
