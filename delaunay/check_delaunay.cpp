#include "delaunay/check_delaunay.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "delaunay/vertex_stars.h"
#include "geom/orient3d.h"
#include "geom/perturbation.h"

namespace cocoon {
namespace {

constexpr std::size_t grain = 4096;  // cells or vertices per chunk of the parallel loops

// Violations of one kind in one chunk.
struct Violations {
  std::size_t count = 0;
  std::string first;

  void add(const char* element, std::size_t id, const char* what) {
    if (count++ == 0)
      first.append(element).append(" ").append(std::to_string(id)).append(" ").append(what);
  }
};

// Runs test(index, violations) for all indices below `count`; returns the number of violations and
// enters the first one of them into the report.
template <class Test>
std::size_t run_tests(const Execution& execution, std::size_t count, DelaunayReport& report,
                      Test test) {
  std::vector<Violations> chunks((count + grain - 1) / grain);
  parallel_chunks(execution, count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) test(i, chunks[begin / grain]);
  });
  std::size_t sum = 0;
  for (const Violations& chunk : chunks) {
    if (report.first_violation.empty()) report.first_violation = chunk.first;
    sum += chunk.count;
  }
  return sum;
}

// Four different vertices in range; the infinite one in slot 3 of infinite cells and nowhere else.
bool is_well_formed(const Triangulation& triangulation, CellId c) {
  const Cell& cell = triangulation.cell(c);
  for (std::size_t i = 0; i < 4; ++i) {
    const VertexId v = cell.vertices[i];
    const bool must_be_infinite = i == 3 && triangulation.is_infinite(c);
    if (must_be_infinite ? v != infinite_vertex : v.index() >= triangulation.num_vertices()) {
      return false;
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (cell.vertices[j] == v) return false;
    }
  }
  return true;
}

// The same triangle, seen from its two sides.
bool are_two_sides(const Triangle& a, const Triangle& b) {
  const auto k = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return k < 3 && b[(k + 1) % 3] == a[2] && b[(k + 2) % 3] == a[1];
}

void check_neighbors(const Triangulation& triangulation, CellId c, Violations& violations) {
  for (int i = 0; i < 4; ++i) {
    const FacetId f = facet_id(c, i);
    const FacetId mirror = triangulation.mirror(f);
    if (cell_of(mirror).index() >= triangulation.num_cells() || cell_of(mirror) == c ||
        triangulation.mirror(mirror) != f ||
        !are_two_sides(triangulation.facet_vertices(mirror), triangulation.facet_vertices(f))) {
      violations.add("facet", f.value, "and its neighbor do not name each other");
    }
  }
}

bool is_positive(const Triangulation& triangulation, CellId c) {
  const auto& [a, b, p, q] = triangulation.cell(c).vertices;
  return orient3d(triangulation.point(a), triangulation.point(b), triangulation.point(p),
                  triangulation.point(q)) == Sign::positive;
}

bool is_in_sphere(const Triangulation& triangulation, CellId c, VertexId v) {
  const auto& [a, b, p, q] = triangulation.cell(c).vertices;
  return insphere_perturbed(triangulation.point(a), triangulation.point(b), triangulation.point(p),
                            triangulation.point(q), triangulation.point(v)) == Sign::positive;
}

// Facet 3 of an infinite cell is a hull facet; the vertices of the hull facets next to it must not
// lie beyond. Coplanar neighbors are allowed.
void check_hull(const Triangulation& triangulation, CellId c, Violations& violations) {
  const auto& [a, b, p, infinite] = triangulation.cell(c).vertices;
  for (int i = 0; i < 3; ++i) {
    const VertexId v = triangulation.opposite_vertex(triangulation.mirror(facet_id(c, i)));
    if (orient3d(triangulation.point(a), triangulation.point(b), triangulation.point(p),
                 triangulation.point(v)) == Sign::positive) {
      violations.add("cell", c.value, "(infinite) has a hull facet with a vertex beyond it");
    }
  }
}

// Corners name a place strictly inside of what they span: the first of them, moved by e towards the
// second, by e^2 towards the third and so on, e infinitesimal. This is the sign there of what is
// linear in the place: that at the first corner where it is not zero.
template <std::size_t N, class SignAt>
Sign sign_inside(const std::array<Point, N>& corners, SignAt sign_at) {
  for (const Point& corner : corners) {
    const Sign sign = sign_at(corner);
    if (sign != Sign::zero) return sign;
  }
  return Sign::zero;
}

// The hull as a whole. What check_hull accepts may still wind around twice, as the sides of a
// pentagram do: so each facet must be seen from one place inside, and a ray from there must meet
// only one of them.
void check_cover(const Triangulation& triangulation, DelaunayReport& report,
                 const Execution& execution) {
  const auto point = [&](CellId c, int i) {
    return triangulation.point(triangulation.vertex(c, i));
  };
  const std::size_t num_finite = triangulation.num_finite_cells();
  const std::size_t num_infinite = triangulation.num_cells() - num_finite;
  const auto facet = [&](std::size_t i) {
    const CellId c(num_finite + i);
    return std::array{point(c, 0), point(c, 1), point(c, 2)};
  };
  const CellId inner(0);
  const std::array from{point(inner, 0), point(inner, 1), point(inner, 2), point(inner, 3)};
  report.hidden_hull_facets =
      run_tests(execution, num_infinite, report, [&](std::size_t i, Violations& violations) {
        const auto [a, b, p] = facet(i);
        const Sign side = sign_inside(
            from, [&, &a = a, &b = b, &p = p](const Point& o) { return orient3d(a, b, p, o); });
        if (side == Sign::negative) return;
        violations.add("cell", num_finite + i, "(infinite) has a hull facet not seen from inside");
      });
  if (report.hidden_hull_facets != 0 || num_infinite == 0) return;
  const std::array<Point, 3> to = facet(0);
  const auto passes_left_of = [&](const Point& s, const Point& t) {
    return sign_inside(to, [&](const Point& q) {
             return sign_inside(from, [&](const Point& o) { return orient3d(o, s, t, q); });
           }) == Sign::positive;
  };
  report.hidden_hull_facets =
      run_tests(execution, num_infinite, report, [&](std::size_t i, Violations& violations) {
        const auto [a, b, p] = facet(i);
        if (i == 0 || !passes_left_of(a, b) || !passes_left_of(b, p) || !passes_left_of(p, a))
          return;
        violations.add("cell", num_finite + i, "(infinite) has a hull facet behind another");
      });
}

void check_facets_of_cell(const Triangulation& triangulation, CellId c, Violations& violations) {
  for (int i = 0; i < 4; ++i) {
    const FacetId f = facet_id(c, i);
    const FacetId mirror = triangulation.mirror(f);
    if (mirror < f || triangulation.is_infinite(cell_of(mirror))) continue;
    if (is_in_sphere(triangulation, c, triangulation.opposite_vertex(mirror))) {
      violations.add("facet", f.value, "is not locally Delaunay");
    }
  }
}

// The cells around `center` cut a small sphere around it into t triangles with n vertices; Euler:
// n - 3t/2 + t = 2.
bool has_euler_number_of_sphere(const Triangulation& triangulation, std::span<const CellId> star,
                                VertexId center) {
  std::vector<VertexId> neighbors;
  neighbors.reserve(3 * star.size());
  for (const CellId c : star) {
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (v != center) neighbors.push_back(v);
    }
  }
  std::sort(neighbors.begin(), neighbors.end());
  const auto end = std::unique(neighbors.begin(), neighbors.end());
  const auto num_neighbors = static_cast<std::size_t>(end - neighbors.begin());
  return 2 * num_neighbors == star.size() + 4;
}

void check_layout(const Triangulation& triangulation, DelaunayReport& report,
                  const Execution& execution) {
  const std::size_t num_cells = triangulation.num_cells();
  report.malformed_cells =
      run_tests(execution, num_cells, report, [&](std::size_t i, Violations& violations) {
        if (is_well_formed(triangulation, CellId(i))) return;
        violations.add("cell", i, "has a wrong set of vertices");
      });
  if (report.malformed_cells != 0) return;
  report.broken_neighbors =
      run_tests(execution, num_cells, report, [&](std::size_t i, Violations& violations) {
        check_neighbors(triangulation, CellId(i), violations);
      });
}

void check_vertices(const Triangulation& triangulation, DelaunayReport& report,
                    const Execution& execution) {
  const VertexStars stars = vertex_stars(triangulation, execution);
  const std::size_t num_vertices = triangulation.num_vertices();
  report.unused_vertices =
      run_tests(execution, num_vertices, report, [&](std::size_t i, Violations& violations) {
        if (stars.star(VertexId(i)).empty()) violations.add("vertex", i, "is in no cell");
      });
  report.bad_links =
      run_tests(execution, num_vertices, report, [&](std::size_t i, Violations& violations) {
        const std::span<const CellId> star = stars.star(VertexId(i));
        if (star.empty() || has_euler_number_of_sphere(triangulation, star, VertexId(i))) return;
        violations.add("vertex", i, "has cells around it that do not form a ball");
      });
  std::vector<CellId> hull;
  for (const CellId c : triangulation.infinite_cells()) hull.push_back(c);
  if (!has_euler_number_of_sphere(triangulation, hull, infinite_vertex)) {
    ++report.bad_links;
    if (report.first_violation.empty()) report.first_violation = "the hull is not a sphere";
  }
  report.vertices_without_point =
      run_tests(execution, num_vertices, report, [&](std::size_t i, Violations& violations) {
        if (triangulation.point_of_vertex(VertexId(i)).is_none()) {
          violations.add("vertex", i, "has no input point");
        }
      });
}

void check_geometry(const Triangulation& triangulation, DelaunayReport& report,
                    const Execution& execution) {
  const std::size_t num_finite = triangulation.num_finite_cells();
  report.misoriented_cells =
      run_tests(execution, num_finite, report, [&](std::size_t i, Violations& violations) {
        if (is_positive(triangulation, CellId(i))) return;
        violations.add("cell", i, "is flat or inside out");
      });
  report.reflex_hull_edges =
      run_tests(execution, triangulation.num_cells() - num_finite, report,
                [&](std::size_t i, Violations& violations) {
                  check_hull(triangulation, CellId(num_finite + i), violations);
                });
  // A place inside, and the in-sphere test, are defined for positive cells only.
  if (report.misoriented_cells != 0) return;
  check_cover(triangulation, report, execution);
  report.occupied_spheres =
      run_tests(execution, num_finite, report, [&](std::size_t i, Violations& violations) {
        check_facets_of_cell(triangulation, CellId(i), violations);
      });
}

}  // namespace

DelaunayReport check_delaunay(const Triangulation& triangulation, const Execution& execution) {
  DelaunayReport report;
  report_progress(execution, "check_delaunay", 0);
  if (triangulation.num_finite_cells() == 0) {
    report.malformed_cells = 1;
    report.first_violation = "there is no finite cell";
    return report;
  }
  check_layout(triangulation, report, execution);
  report_progress(execution, "check_delaunay", 0.2);
  if (report.malformed_cells == 0 && report.broken_neighbors == 0) {
    check_vertices(triangulation, report, execution);
    report_progress(execution, "check_delaunay", 0.4);
    check_geometry(triangulation, report, execution);
  }
  report_progress(execution, "check_delaunay", 1);
  return report;
}

}  // namespace cocoon
