#include "bench/rivals/cgal.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <array>
#include <utility>
#include <vector>

#include "bench/place_set_hash.h"

namespace cocoon::rivals {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 to_cgal(const Point& p) { return {p.x, p.y, p.z}; }

}  // namespace

TimedBuild cgal_delaunay(Points points) {
  std::vector<Kernel::Point_3> input;
  input.reserve(points.size());
  for (const Point& p : points) input.push_back(to_cgal(p));

  const bench::Stopwatch stopwatch;
  const CGAL::Delaunay_triangulation_3<Kernel> triangulation(input.begin(), input.end());
  return {stopwatch.elapsed(), triangulation.number_of_finite_cells()};
}

struct CgalDynamicDelaunay::State {
  CGAL::Delaunay_triangulation_3<Kernel> triangulation;
};

CgalDynamicDelaunay::CgalDynamicDelaunay(Points points) : state_(std::make_unique<State>()) {
  std::vector<Kernel::Point_3> input;
  for (const Point& p : points) input.push_back(to_cgal(p));
  state_->triangulation.insert(input.begin(), input.end());
}
CgalDynamicDelaunay::~CgalDynamicDelaunay() = default;
CgalDynamicDelaunay::CgalDynamicDelaunay(CgalDynamicDelaunay&&) noexcept = default;
CgalDynamicDelaunay& CgalDynamicDelaunay::operator=(CgalDynamicDelaunay&&) noexcept = default;

TimedReplacement CgalDynamicDelaunay::replace(Points removed, Points inserted) {
  auto& triangulation = state_->triangulation;
  std::vector<CGAL::Delaunay_triangulation_3<Kernel>::Vertex_handle> vertices;
  for (const Point& p : removed) {
    const auto hint = vertices.empty() ? triangulation.infinite_vertex() : vertices.back();
    vertices.push_back(triangulation.nearest_vertex(to_cgal(p), hint->cell()));
  }
  std::vector<Kernel::Point_3> input;
  for (const Point& p : inserted) input.push_back(to_cgal(p));

  TimedReplacement result;
  const bench::Stopwatch removal;
  triangulation.remove_cluster(vertices.begin(), vertices.end());
  result.removal = removal.elapsed();
  const bench::Stopwatch insertion;
  triangulation.insert(input.begin(), input.end());
  result.insertion = insertion.elapsed();
  return result;
}

std::uint64_t CgalDynamicDelaunay::place_set_hash() const {
  std::uint64_t sum = 0;
  for (const auto& cell : state_->triangulation.finite_cell_handles()) {
    std::array<Point, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const Kernel::Point_3& p = cell->vertex(i)->point();
      corners[static_cast<std::size_t>(i)] = {p.x(), p.y(), p.z()};
    }
    sum += bench::place_hash(corners);
  }
  return sum;
}

}  // namespace cocoon::rivals
