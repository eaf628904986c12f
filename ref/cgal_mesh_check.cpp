#include "ref/cgal_mesh_check.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <algorithm>
#include <boost/variant/get.hpp>
#include <iterator>
#include <utility>

namespace cocoon::ref {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = SurfaceMesh::Face_index;

ExactKernel::Triangle_3 exact(const std::array<Point, 3>& t) {
  const auto point = [](const Point& p) { return ExactKernel::Point_3(p.x, p.y, p.z); };
  return {point(t[0]), point(t[1]), point(t[2])};
}

}  // namespace

std::optional<CgalMeshMeasure> cgal_mesh_check(const TriangleMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const Point& p : mesh.points) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::vector<std::size_t>> polygons;
  for (const Triangle& t : mesh.triangles) {
    polygons.push_back({t[0].index(), t[1].index(), t[2].index()});
  }
  if (!pmp::is_polygon_soup_a_polygon_mesh(polygons)) return std::nullopt;
  SurfaceMesh surface;
  pmp::polygon_soup_to_polygon_mesh(points, polygons, surface);

  CgalMeshMeasure measure;
  measure.closed = CGAL::is_closed(surface);
  measure.area = CGAL::to_double(pmp::area(surface));
  if (measure.closed) measure.volume = CGAL::to_double(pmp::volume(surface));
  const auto component = surface.add_property_map<Face, std::size_t>("f:component", 0).first;
  measure.components = pmp::connected_components(surface, component);
  std::vector<SurfaceMesh::Halfedge_index> cycles;
  pmp::extract_boundary_cycles(surface, std::back_inserter(cycles));
  measure.boundary_cycles = cycles.size();
  std::vector<std::pair<Face, Face>> pairs;
  pmp::self_intersections(surface, std::back_inserter(pairs));
  measure.self_intersections = pairs.size();
  return measure;
}

bool cgal_triangles_intersect(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
  const auto shared = std::count_if(a.begin(), a.end(), [&b](const Point& p) {
    return std::find(b.begin(), b.end(), p) != b.end();
  });
  // What they share is in the intersection; so it is the intersection iff that has its dimension
  // and, for a segment, its length.
  const auto common = CGAL::intersection(exact(a), exact(b));
  if (!common) return false;
  if (shared == 1) return boost::get<ExactKernel::Point_3>(&*common) == nullptr;
  const auto* segment = boost::get<ExactKernel::Segment_3>(&*common);
  if (shared != 2 || segment == nullptr) return true;
  std::vector<ExactKernel::Point_3> ends;
  for (const Point& p : a) {
    if (std::find(b.begin(), b.end(), p) != b.end()) ends.emplace_back(p.x, p.y, p.z);
  }
  return CGAL::squared_distance(ends[0], ends[1]) != segment->squared_length();
}

}  // namespace cocoon::ref
