// What mesh files hold before it is a TriangleMesh: points and faces with any number of corners.
// All mesh readers fill one of these; turning it into triangles and checking the corners is common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/file_bytes.h"
#include "io/mesh_file_options.h"
#include "io/vertex_properties.h"

namespace cocoon {

struct PolygonSoup {
  std::vector<Point> points;
  std::vector<std::int64_t> corners;    // of all faces, as the file gives them, counted from 0
  std::vector<std::size_t> face_ends;   // face f has corners [face_ends[f - 1], face_ends[f])
  std::vector<std::size_t> face_lines;  // the line of each face; empty if the format has no lines
  NonFinitePoints non_finite;           // which points are not finite
  VertexProperties properties;          // PLY, if asked for
  std::size_t surplus_lines = 0;        // see MeshReadReport
  std::size_t first_surplus_line = 0;
  std::size_t trailing_bytes = 0;

  void end_face() { face_ends.push_back(corners.size()); }
};

// Throws FileError, naming the face, if a corner is no vertex. Complexity: O(corners).
void check_corners(const PolygonSoup& soup, const std::filesystem::path& path);

// Removes the points that are not finite, with their rows of `properties` (one row per point), and
// returns which they were, ascending. Complexity: O(points).
std::vector<std::size_t> remove_non_finite(std::vector<Point>& points,
                                           VertexProperties& properties);

// The triangles of the faces: polygons are cut by triangulate_polygon, faces with fewer than three
// corners and triangles with a repeated corner are left out and counted in `report`. Vertices and
// triangles keep the order of the file. Throws FileError if a corner is no vertex or a point not
// finite, naming it, or if there are more vertices than ids. Complexity: O(corners); O(n^2) for a
// polygon that is not convex.
TriangleMesh triangles_of(PolygonSoup&& soup, const std::filesystem::path& path,
                          MeshReadReport& report);

}  // namespace cocoon
