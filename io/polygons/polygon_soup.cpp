#include "io/polygons/polygon_soup.h"

#include <algorithm>
#include <string>

#include "io/file_bytes.h"
#include "io/polygons/triangulate_polygon.h"

namespace cocoon {

namespace {

[[noreturn]] void fail_corner(const PolygonSoup& soup, std::size_t corner,
                              const std::filesystem::path& path) {
  const auto face = static_cast<std::size_t>(
      std::upper_bound(soup.face_ends.begin(), soup.face_ends.end(), corner) -
      soup.face_ends.begin());
  throw file_error(path, soup.face_lines.empty() ? 0 : soup.face_lines[face],
                   "face " + std::to_string(face) + " has the corner " +
                       std::to_string(soup.corners[corner]) + " (both counted from 0), but there " +
                       "are " + std::to_string(soup.points.size()) +
                       " vertices; the file is damaged or incomplete");
}

}  // namespace

void check_corners(const PolygonSoup& soup, const std::filesystem::path& path) {
  for (std::size_t i = 0; i < soup.corners.size(); ++i) {
    // A negative one becomes larger than any count.
    if (static_cast<std::uint64_t>(soup.corners[i]) >= soup.points.size()) {
      fail_corner(soup, i, path);
    }
  }
}

std::vector<std::size_t> remove_non_finite(std::vector<Point>& points,
                                           VertexProperties& properties) {
  std::vector<std::size_t> removed;
  std::vector<std::uint8_t> kept(points.size(), 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_finite(points[i])) continue;
    kept[i] = 0;
    removed.push_back(i);
  }
  if (removed.empty()) return removed;
  std::erase_if(points, [](const Point& point) { return !is_finite(point); });
  properties = select_properties(properties, kept);
  return removed;
}

TriangleMesh triangles_of(PolygonSoup&& soup, const std::filesystem::path& path,
                          MeshReadReport& report) {
  if (soup.points.size() >= Id<VertexTag>::none_value - 1) {
    throw file_error(path, "has " + std::to_string(soup.points.size()) +
                               " vertices, more than 32-bit ids can number; split it");
  }
  soup.non_finite.finish(path, soup.face_ends.empty());
  check_corners(soup, path);
  report = {};
  report.faces = soup.face_ends.size();
  report.surplus_lines = soup.surplus_lines;
  report.first_surplus_line = soup.first_surplus_line;
  report.trailing_bytes = soup.trailing_bytes;

  TriangleMesh mesh;
  mesh.triangles.reserve(soup.face_ends.size());
  std::vector<VertexId> polygon;
  std::vector<Triangle> triangles;
  std::size_t begin = 0;
  for (std::size_t face = 0; face < soup.face_ends.size(); ++face) {
    const std::size_t end = soup.face_ends[face];
    polygon.clear();
    for (std::size_t i = begin; i < end; ++i) {
      polygon.push_back(VertexId(static_cast<std::size_t>(soup.corners[i])));
    }
    begin = end;
    if (polygon.size() < 3) {
      ++report.short_faces;
      continue;
    }
    if (polygon.size() > 3) ++report.polygons;
    triangulate_polygon(soup.points, polygon, triangles);
    for (const Triangle& t : triangles) {
      if (repeats_a_vertex(t)) {
        ++report.degenerate_triangles;
      } else {
        mesh.triangles.push_back(t);
      }
    }
  }
  mesh.points = IdVector<VertexId, Point>(std::move(soup.points));
  return mesh;
}

}  // namespace cocoon
