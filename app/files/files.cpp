#include "app/files/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "app/console/standard_streams.h"
#include "app/files/pending_clouds.h"
#include "app/files/replaceable_file.h"
#include "geom/errors.h"
#include "geom/messages/counted.h"
#include "io/atomic_file.h"
#include "io/file_format.h"
#include "io/lock_file.h"
#include "io/mesh_file.h"
#include "io/point_file.h"

namespace cocoon::app {

namespace fs = std::filesystem;

namespace {

// Other programs read standard input by this name. Here the extension of a name tells the format.
void require_named_input(const std::string& path) {
  const bool is_standard_input = path == "-" && access(path.c_str(), F_OK) != 0;
  const bool is_stream = fs::path(path).extension().empty() && own_descriptor(path) >= 0;
  if (!is_standard_input && !is_stream) return;
  throw UsageError(path +
                   ": a stream needs a name whose extension tells the format; make a link to it "
                   "(ln -s /dev/stdin in.xyz), and name that");
}

// What read() returns; its error names the option that would help.
template <class Read>
auto naming_the_option(Read read) {
  try {
    return read();
  } catch (const NonFiniteError& error) {
    if (!error.can_be_skipped()) throw;
    throw FileError(fmt::format("{}, or leave them out: --skip-non-finite", error.what()));
  }
}

// Which columns of a text file were taken, where it names them; a name that does not tell may be
// that of something else.
void tell_columns(Job& job, const std::string& path, const std::string& section,
                  const PointCloud& cloud) {
  const auto& [x, y, z] = cloud.coordinate_names;
  if (x.empty() && y.empty() && z.empty()) return;
  job.report().set(section + "/coordinate_columns", std::vector<std::string>{x, y, z});
  // Tables of R have one for the names of the rows.
  if (cloud.columns == cloud.named_columns + 1) {
    job.warn(path +
             ": rows have one column more than the header names; the first three are taken as x, "
             "y, z: if the first one numbers the rows, name it in the header");
  }
  if (cloud.told_columns) return;
  job.say("note: {}: no columns are named x, y, z; taken are the first three: {}, {}, {}", path, x,
          y, z);
}

// A file without names of columns that looks as if it had other ones than x, y, z.
void warn_of_counts(Job& job, const std::string& path, const std::string& section,
                    const PointCloud& cloud) {
  if (cloud.first_column_counts_rows) {
    job.report().set(section + "/first_column_counts_rows", true);
    job.warn(path +
             ": the first column counts the rows and was read as x; if it is none, name the "
             "columns in a first line: n x y z");
  }
  if (cloud.first_row_counts_columns) {
    job.report().set(section + "/first_row_counts_columns", true);
    job.warn(path +
             ": the first row, 0 1 2, was read as a point; if it names the columns, remove it");
  }
}

void warn_of_skipped(Job& job, const std::string& path, const std::string& section,
                     std::size_t points) {
  if (points == 0) return;
  job.report().add(section + "/skipped_non_finite", points);
  job.warn(fmt::format(
      "{}: {} left out", path,
      counted(points, "point is not finite and was", "points are not finite and were")));
}

// What lies behind the last element that a header announces may be what the user wants most.
void warn_of_trailing_bytes(Job& job, const std::string& path, const std::string& section,
                            std::size_t bytes) {
  if (bytes == 0) return;
  job.report().add(section + "/trailing_bytes", bytes);
  job.warn(fmt::format("{}: {} behind what its header announces", path,
                       counted(bytes, "byte was not read,", "bytes were not read,")));
}

// A list of corners whose count is too small above all: a face comes out that was not meant.
void warn_of_surplus_lines(Job& job, const std::string& path, const std::string& section,
                           std::size_t lines, std::size_t first) {
  if (lines == 0) return;
  job.report().add(section + "/surplus_lines", lines);
  job.warn(fmt::format(
      "{}:{}: {} more values than the header announces; the last ones were not read", path, first,
      lines == 1 ? "this line has" : fmt::format("this line and {} more have", lines - 1)));
}

// Where a name says nothing else, "-" is standard output (command_line.cpp).
void require_named_output(const OutputFile& output) {
  if (output.path != "-") return;
  if (output.extensions.empty()) throw UsageError("-: this is kept in a file; name one");
  throw UsageError(fmt::format(
      "-: standard output needs a name whose extension tells the format; make a link to it (ln -s "
      "/dev/stdout out{}), and name that",
      output.extensions.front()));
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

// A file is written as another one that is renamed over it (io/atomic_file.h), behind all links:
// its folder must be writable, whether it exists or not. What is no file, or open already, is
// written as it is.
void require_writable(const std::string& path) {
  require_possible_name(path);
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw FileError(path + ": is a folder; name a file to write");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (access(path.c_str(), W_OK) == 0) return;
    throw FileError(path + ": cannot be written (" + std::strerror(errno) + "); name another file");
  }
  if (own_descriptor(path) >= 0) return;
  const fs::path target = follow_links(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) {
    const std::string link = target == path ? "" : "is a link to " + target.string() + ", but ";
    throw FileError(path + ": " + link + "there is no folder " + folder.string() +
                    "; make it first");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw FileError(path + ": no file can be written or replaced in " + folder.string() + " (" +
                    std::strerror(errno) + "); name another folder, or check its permissions");
  }
  if (const std::string why = obstacle_to_replacing(target); !why.empty()) {
    throw FileError(path + ": cannot be replaced: " + why + "; name another file");
  }
}

// Where the report goes with "--json -"; not if what is written there is lost anyway.
void add_standard_output(std::vector<fs::path>& targets) {
  const fs::path target = place_of("/dev/stdout");
  if (target != "/dev/null") targets.push_back(target);
}

// A session takes these away when it is saved or let go.
void require_not_of_session(const std::string& path, const std::string& session) {
  const fs::path place = place_of(path);
  const bool is_cloud = is_pending_cloud_file(place, place_of(session).string());
  if (is_cloud || place == place_of(lock_of(session))) {
    throw UsageError(path + ": this name is kept for a file of the session " + session +
                     "; name another one");
  }
}

}  // namespace

void require_outputs(Job& job, std::vector<OutputFile> outputs,
                     const std::vector<std::string>& inputs) {
  if (job.shared().json != "-") outputs.push_back({job.shared().json});
  std::erase_if(outputs, [](const OutputFile& output) { return output.path.empty(); });
  std::vector<fs::path> targets;
  if (job.shared().json == "-") add_standard_output(targets);
  for (const OutputFile& output : outputs) {
    require_named_output(output);
    require_extension(output);
    require_writable(output.path);
    if (is_standard_output(output.path)) job.keep_standard_output();
    const fs::path target = place_of(output.path);
    if (std::find(targets.begin(), targets.end(), target) != targets.end()) {
      throw UsageError(output.path + ": two outputs cannot be the same file; name another one");
    }
    for (const std::string& input : inputs) {
      if (place_of(input) != target) continue;
      if (input == output.may_replace && extension_of(input) == extension_of(output.path)) continue;
      throw UsageError(output.path + ": is an input and would be overwritten; name another file");
    }
    targets.push_back(target);
  }
  for (const OutputFile& session : outputs) {
    if (!session.is_session) continue;
    for (const OutputFile& output : outputs) require_not_of_session(output.path, session.path);
    for (const std::string& input : inputs) require_not_of_session(input, session.path);
  }
}

void require_replaceable(const std::string& output, const std::string& input, std::size_t faces) {
  if (faces > 0 || place_of(output) != place_of(input)) return;
  throw UsageError(output +
                   ": is an input without faces, whose points would be overwritten; name another "
                   "file");
}

fs::path place_of(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  const fs::path found = fs::weakly_canonical(follow_links(absolute), error);
  return error ? path : found;
}

void require_possible_name(const std::string& path) {
  if (access(path.c_str(), F_OK) == 0) return;
  if (errno == ENAMETOOLONG) {
    throw FileError(path + ": this name is too long; use one of at most 255 bytes");
  }
  if (errno == ELOOP) {
    throw FileError(path + ": is a loop of symbolic links; use another name");
  }
}

void require_readable_again(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status)) return;
  throw FileError(path + ": is no regular file, and has to be read more than once; copy it to one");
}

void require_folder(const std::string& path) {
  require_possible_name(path);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return;
  throw FileError(path + (fs::exists(path, ignored)
                              ? ": is no folder; name the one in which scans will appear"
                              : ": there is no such folder; make it first"));
}

std::string in_folder(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

std::vector<Point> read_cloud(Job& job, const std::string& path, const std::string& section,
                              VertexProperties* properties, std::size_t* faces,
                              std::vector<std::size_t>* skipped) {
  require_named_input(path);
  PointReadOptions options;
  options.keep_properties = properties != nullptr;
  options.skip_non_finite = job.shared().skip_non_finite;
  PointCloud cloud = timed(job.execution(), "read", [&] {
    return naming_the_option([&] { return read_points(path, options); });
  });
  tell_columns(job, path, section, cloud);
  warn_of_counts(job, path, section, cloud);
  warn_of_skipped(job, path, section, cloud.skipped.size());
  const std::size_t points = cloud.points.size() + cloud.skipped.size();
  if (cloud.announced && *cloud.announced < points) {
    job.report().set(section + "/announced_points", *cloud.announced);
    job.warn(fmt::format("{}: announces {}, but {} follow; all of them were read", path,
                         counted(*cloud.announced, "point"), points));
  }
  warn_of_surplus_lines(job, path, section, cloud.surplus_lines, cloud.first_surplus_line);
  warn_of_trailing_bytes(job, path, section, cloud.trailing_bytes);
  if (properties != nullptr) *properties = std::move(cloud.properties);
  if (faces != nullptr) *faces = cloud.faces;
  if (skipped != nullptr) *skipped = std::move(cloud.skipped);
  return std::move(cloud.points);
}

void warn_of_left_out_faces(Job& job, const std::string& path, const std::string& section,
                            std::size_t before, std::size_t more) {
  if (more == 0) return;
  job.report().set(section + "/faces_left_out", before + more);
  job.warn(fmt::format("{}: {} left out", path,
                       counted(more, "face without area was", "faces without area were")));
}

Shape read_shape(Job& job, const std::string& path, const std::string& section,
                 VertexProperties* properties) {
  MeshReadReport read;
  if (!has_mesh_extension(path)) {
    IdVector<VertexId, Point> points(
        read_cloud(job, path, section, properties, nullptr, &read.skipped));
    return {{std::move(points), {}}, std::move(read)};
  }
  const MeshReadOptions options = {job.shared().skip_non_finite};
  TriangleMesh mesh = timed(job.execution(), "read", [&] {
    return naming_the_option([&] {
      return properties == nullptr ? read_mesh(path, read, options)
                                   : read_mesh(path, read, *properties, options);
    });
  });
  warn_of_skipped(job, path, section, read.skipped.size());
  job.report().set(section + "/faces", read.faces);
  if (read.polygons > 0) job.report().set(section + "/polygons_cut", read.polygons);
  warn_of_left_out_faces(job, path, section, 0, read.left_out());
  warn_of_surplus_lines(job, path, section, read.surplus_lines, read.first_surplus_line);
  warn_of_trailing_bytes(job, path, section, read.trailing_bytes);
  return {std::move(mesh), std::move(read)};
}

}  // namespace cocoon::app
