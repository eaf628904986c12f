#include "io/mesh_file.h"

#include <string>
#include <utility>
#include <vector>

#include "io/atomic_file.h"
#include "io/file_bytes.h"
#include "io/file_format.h"
#include "io/formats/obj.h"
#include "io/formats/off.h"
#include "io/formats/ply.h"
#include "io/formats/stl.h"
#include "io/read_polygon_soup.h"

namespace cocoon {

namespace {

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

// `properties`: null if nobody wants them.
TriangleMesh mesh_of(PolygonSoup&& soup, const std::filesystem::path& path, MeshReadReport& report,
                     VertexProperties* properties, const MeshReadOptions& options) {
  soup.properties.rows = soup.points.size();
  std::vector<std::size_t> skipped;
  if (options.skip_non_finite && soup.face_ends.empty()) {
    skipped = remove_non_finite(soup.points, soup.properties);
    soup.non_finite = {};
  }
  if (properties != nullptr) *properties = std::move(soup.properties);
  TriangleMesh mesh = triangles_of(std::move(soup), path, report);
  report.skipped = std::move(skipped);
  return mesh;
}

}  // namespace

bool has_mesh_extension(const std::filesystem::path& path) { return is_mesh(format_of(path)); }

TriangleMesh read_mesh(const std::filesystem::path& path, MeshReadReport& report,
                       const MeshReadOptions& options) {
  return mesh_of(read_polygon_soup(path), path, report, nullptr, options);
}

TriangleMesh read_mesh(const std::filesystem::path& path) {
  MeshReadReport report;
  return read_mesh(path, report);
}

TriangleMesh read_mesh(const std::filesystem::path& path, MeshReadReport& report,
                       VertexProperties& properties, const MeshReadOptions& options) {
  return mesh_of(read_polygon_soup(path, true), path, report, &properties, options);
}

FloatRounding write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                         const MeshWriteOptions& options, FileBatch* batch) {
  return write_mesh(path, mesh, VertexProperties{}, options, batch);
}

FloatRounding write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                         const VertexProperties& properties, const MeshWriteOptions& options,
                         FileBatch* batch) {
  const FileFormat format = format_of(path);
  if (!is_mesh(format)) {
    throw file_error(path, "meshes are not written with extension " +
                               in_quotes(extension_of(path)) + "; use .ply, .obj, .off or .stl");
  }
  check_writable(path, mesh);
  if (!properties.columns.empty() && properties.rows != mesh.points.size()) {
    throw file_error(path, "not written: properties of " + std::to_string(properties.rows) +
                               " vertices for " + std::to_string(mesh.points.size()));
  }
  AtomicFile file(path);
  if (format == FileFormat::ply) write_ply(file, mesh, properties, options);
  if (format == FileFormat::obj) write_obj(file, mesh);
  if (format == FileFormat::off) write_off(file, mesh);
  if (format == FileFormat::stl) write_stl(file, mesh, options);
  FloatRounding rounding;
  if (format == FileFormat::stl ? !options.ascii
                                : format == FileFormat::ply && options.single_precision) {
    rounding = float_rounding(mesh);
  }
  file.commit(batch);
  if (batch != nullptr && rounding.is_noticeable()) batch->note({path, rounding});
  return rounding;
}

}  // namespace cocoon
