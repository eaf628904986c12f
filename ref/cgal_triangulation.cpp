#include "ref/cgal_triangulation.h"

#include <algorithm>
#include <ctime>
#include <iterator>
#include <utility>

namespace cocoon::ref::on_cgal {

Delaunay triangulation_of(Points points, double* processor_seconds) {
  std::vector<std::pair<Kernel::Point_3, VertexInfo>> labeled;
  labeled.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    VertexInfo info;
    info.id = static_cast<std::uint32_t>(i);
    labeled.emplace_back(Kernel::Point_3(points[i].x, points[i].y, points[i].z), info);
  }
  Delaunay delaunay;
  const std::clock_t begin = std::clock();
  delaunay.insert(labeled.begin(), labeled.end());
  if (processor_seconds != nullptr) {
    *processor_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }
  return delaunay;
}

std::array<Vec3, 3> sorted_places(const Facet& f) {
  std::array<Vec3, 3> places = {place(corner(f, 0)), place(corner(f, 1)), place(corner(f, 2))};
  std::sort(places.begin(), places.end());
  return places;
}

double circumradius(const Facet& f) {
  const auto [a, b, c] = sorted_places(f);
  const double twice_area = norm(cross(b - a, c - a));
  if (twice_area == 0) return infinity;
  return norm(b - a) * norm(c - a) * norm(c - b) / (2 * twice_area);
}

double dihedral_cosine(VertexHandle a, VertexHandle b, VertexHandle c, VertexHandle d) {
  const Vec3 edge = place(b) - place(a);
  const Vec3 u = cross(edge, place(c) - place(a));
  const Vec3 v = cross(edge, place(d) - place(a));
  return dot(u, v) / (norm(u) * norm(v));
}

std::vector<std::array<VertexHandle, 2>> link_of(const Delaunay& delaunay, VertexHandle v) {
  std::vector<std::array<VertexHandle, 2>> link;
  std::vector<Facet> facets;
  delaunay.finite_incident_facets(v, std::back_inserter(facets));
  for (const Facet& f : facets) {
    if (!is_surface(f)) continue;
    std::array<VertexHandle, 2> side;
    std::size_t n = 0;
    for (int k = 0; k < 3; ++k) {
      if (corner(f, k) != v) side[n++] = corner(f, k);
    }
    link.push_back(side);
  }
  return link;
}

}  // namespace cocoon::ref::on_cgal
