// Which files a command reads and writes, checked before any work is done.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/job.h"
#include "geom/errors.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/mesh_file_options.h"
#include "io/vertex_properties.h"

namespace cocoon::app {

inline const std::vector<std::string> mesh_extensions = {".ply", ".obj", ".off", ".stl"};

// One file to write.
struct OutputFile {
  std::string path;                          // empty: not wanted
  std::vector<std::string> extensions = {};  // that its format can have; empty: any
  // The one input that it may be, if that was named with the same extension, which tells how it is
  // read; empty: none. Once that is read, require_replaceable() is to be asked.
  std::string may_replace = {};
  bool is_session = false;  // files beside it are its own: FILE.lock, FILE.cloud-K
};

// Checks what a command is going to write, so that nobody waits an hour for "no such folder". If
// one of them goes to standard output, the job says nothing there from now on.
// Throws UsageError if two of the files, or one of them and an input, are the same, by whatever
// names and links, or one is what a session keeps beside itself, or if an extension is none of
// those listed, and FileError if a file cannot be made there. The report file of the job is one of
// them.
void require_outputs(Job& job, std::vector<OutputFile> outputs,
                     const std::vector<std::string>& inputs = {});

// Throws UsageError if the mesh to be written would take the place of an input without faces: not
// all points of a scan need be on the surface that is made of it.
void require_replaceable(const std::string& output, const std::string& input, std::size_t faces);

// Where a file lies or would lie, behind all symbolic links: one place has one such path, however
// it is spelled. For paths that cannot be looked up, the path as it is.
std::filesystem::path place_of(const std::filesystem::path& path);

// Throws FileError if there can be no file of this name: it is too long, or a loop of links.
void require_possible_name(const std::string& path);

// Throws FileError if it is there and cannot be read more than once: a pipe, a terminal.
void require_readable_again(const std::string& path);

// Throws FileError if there is no such folder.
void require_folder(const std::string& path);

// "FOLDER/NAME"
std::string in_folder(const std::string& folder, const std::string& name);

// Reads points; times it as stage "read". What the reader left out is counted in the report's
// section `section` ("input"), of all files together, and warned of. `properties`, if not null,
// gets what a PLY file says of its vertices beside their position, `faces` how many faces the file
// has, which are not used, `skipped` which of its points are left out for not being finite,
// ascending.
std::vector<Point> read_cloud(Job& job, const std::string& path, const std::string& section,
                              VertexProperties* properties = nullptr, std::size_t* faces = nullptr,
                              std::vector<std::size_t>* skipped = nullptr);

// Tells of faces that are left out, as they have no area; `before`: of those of the file that the
// user was told of before.
void warn_of_left_out_faces(Job& job, const std::string& path, const std::string& section,
                            std::size_t before, std::size_t more);

struct Shape {
  TriangleMesh mesh;
  MeshReadReport read;
};

// Reads what may be a mesh or a point cloud: a file without triangles gives points alone.
Shape read_shape(Job& job, const std::string& path, const std::string& section,
                 VertexProperties* properties = nullptr);

// Runs `body` and puts the name of the file in front of what the library says of its content.
template <class Body>
auto naming_input(const std::string& path, Body body) {
  try {
    return body();
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace cocoon::app
