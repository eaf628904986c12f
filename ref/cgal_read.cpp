#include "ref/cgal_read.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <vector>

#include "geom/errors.h"

namespace cocoon::ref {

TriangleMesh cgal_read_mesh(const std::filesystem::path& path) {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(path.string(), points, polygons)) {
    throw FileError(path.string() + ": CGAL cannot read it");
  }
  TriangleMesh mesh;
  for (const auto& p : points) mesh.points.push_back({p.x(), p.y(), p.z()});
  for (const std::vector<std::size_t>& polygon : polygons) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      mesh.triangles.push_back(
          {VertexId(polygon[0]), VertexId(polygon[i]), VertexId(polygon[i + 1])});
    }
  }
  return mesh;
}

}  // namespace cocoon::ref
