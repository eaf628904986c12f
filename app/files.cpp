#include "app/files.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "geom/counted.h"
#include "geom/errors.h"
#include "io/file_format.h"
#include "io/mesh_file.h"
#include "io/point_file.h"

namespace cocoon::app {

namespace fs = std::filesystem;

namespace {

// What lies behind the last element that a header announces may be what the user wants most.
void warn_of_trailing_bytes(Job& job, const std::string& path, const std::string& section,
                            std::size_t bytes) {
  if (bytes == 0) return;
  job.report().set(section + "/trailing_bytes", bytes);
  job.warn(fmt::format("{}: {} behind what its header announces", path,
                       counted(bytes, "byte was not read,", "bytes were not read,")));
}

void require_extension(const OutputFile& output) {
  std::error_code ignored;
  if (output.extensions.empty() || fs::is_directory(output.path, ignored)) return;  // said below
  const std::string extension = extension_of(output.path);
  std::string known;
  for (const std::string& candidate : output.extensions) {
    if (extension == candidate) return;
    known += fmt::format(" {}", candidate);
  }
  throw UsageError(
      fmt::format("{}: unknown kind of output '{}'; one of{}", output.path, extension, known));
}

void require_writable(const std::string& path) {
  std::error_code ignored;
  const fs::path target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (fs::is_directory(target, ignored)) {
    throw FileError(path + ": is a folder; name a file to write");
  }
  if (!fs::is_directory(folder, ignored)) {
    throw FileError(path + ": there is no folder " + folder.string() + "; make it first");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0 && access(path.c_str(), W_OK) != 0) {
    throw FileError(path + ": no permission to write in " + folder.string());
  }
}

}  // namespace

void require_outputs(const Job& job, const std::vector<OutputFile>& outputs) {
  std::vector<std::string> paths;
  for (const OutputFile& output : outputs) {
    if (output.path.empty()) continue;
    require_extension(output);
    paths.push_back(output.path);
  }
  if (!job.shared().json.empty() && job.shared().json != "-") paths.push_back(job.shared().json);
  std::vector<fs::path> targets;
  for (const std::string& path : paths) {
    require_writable(path);
    const fs::path target = fs::weakly_canonical(path);
    if (std::find(targets.begin(), targets.end(), target) != targets.end()) {
      throw UsageError(path + ": two outputs cannot be the same file");
    }
    targets.push_back(target);
  }
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw FileError(path + ": cannot make this folder: " + error.message());
}

std::string in_folder(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

std::vector<Point> read_cloud(Job& job, const std::string& path, const std::string& section,
                              VertexProperties* properties) {
  PointReadOptions options;
  options.keep_properties = properties != nullptr;
  options.skip_non_finite = job.shared().skip_non_finite;
  PointCloud cloud = timed(job.execution(), "read", [&] { return read_points(path, options); });
  if (cloud.skipped > 0) {
    job.report().set(section + "/skipped_non_finite", cloud.skipped);
    job.warn(fmt::format(
        "{}: {} left out", path,
        counted(cloud.skipped, "point is not finite and was", "points are not finite and were")));
  }
  if (cloud.announced && *cloud.announced < cloud.points.size() + cloud.skipped) {
    job.report().set(section + "/announced_points", *cloud.announced);
    job.warn(fmt::format("{}: announces {}, but {} follow; all of them were read", path,
                         counted(*cloud.announced, "point"), cloud.points.size() + cloud.skipped));
  }
  warn_of_trailing_bytes(job, path, section, cloud.trailing_bytes);
  if (properties != nullptr) *properties = std::move(cloud.properties);
  return std::move(cloud.points);
}

TriangleMesh read_shape(Job& job, const std::string& path, const std::string& section,
                        VertexProperties* properties) {
  if (!has_mesh_extension(path)) {
    return {IdVector<VertexId, Point>(read_cloud(job, path, section, properties)), {}};
  }
  MeshReadReport read;
  TriangleMesh mesh = timed(job.execution(), "read", [&] {
    return properties == nullptr ? read_mesh(path, read) : read_mesh(path, read, *properties);
  });
  job.report().set(section + "/faces", read.faces);
  if (read.polygons > 0) job.report().set(section + "/polygons_cut", read.polygons);
  const std::size_t left_out = read.short_faces + read.degenerate_triangles;
  if (left_out > 0) {
    job.report().set(section + "/faces_left_out", left_out);
    job.warn(fmt::format("{}: {} left out", path,
                         counted(left_out, "face without area was", "faces without area were")));
  }
  warn_of_trailing_bytes(job, path, section, read.trailing_bytes);
  return mesh;
}

}  // namespace cocoon::app
