#include "ref/cgal_cocone.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <algorithm>
#include <cmath>
#include <span>

#include "ref/cgal_triangulation.h"

namespace cocoon::ref::on_cgal {
namespace {

// The dual of a facet: a Voronoi vertex, and another one or a direction.
struct DualEdge {
  Vec3 from;
  Vec3 to;
  bool is_ray = false;
};

// The Voronoi vertex of a finite cell: in rational numbers where the cell is so flat that few
// digits would be left of it.
Vec3 center_of(const Delaunay& delaunay, CellHandle c) {
  constexpr double flat = 1e-6;
  const Vec3 u = place(c->vertex(1)) - place(c->vertex(0));
  const Vec3 v = place(c->vertex(2)) - place(c->vertex(0));
  const Vec3 w = place(c->vertex(3)) - place(c->vertex(0));
  if (std::abs(dot(cross(u, v), w)) > flat * norm(u) * norm(v) * norm(w)) {
    return to_vec3(delaunay.dual(c));
  }
  using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const CGAL::Cartesian_converter<Kernel, Rational> exact;
  const auto center =
      CGAL::circumcenter(exact(c->vertex(0)->point()), exact(c->vertex(1)->point()),
                         exact(c->vertex(2)->point()), exact(c->vertex(3)->point()));
  return {CGAL::to_double(center.x()), CGAL::to_double(center.y()), CGAL::to_double(center.z())};
}

// The eigenvector of sum d d^T with the largest eigenvalue: squared often enough, the matrix is
// that vector times itself. Of its two signs the lexicographically greater.
Vec3 principal_direction(std::span<const Vec3> directions) {
  std::array<Vec3, 3> rows;
  for (const Vec3& d : directions) {
    rows = {rows[0] + d.x * d, rows[1] + d.y * d, rows[2] + d.z * d};
  }
  for (int k = 0; k < 60; ++k) {
    std::array<Vec3, 3> square;
    for (std::size_t i = 0; i < 3; ++i) {
      square[i] = rows[i].x * rows[0] + rows[i].y * rows[1] + rows[i].z * rows[2];
    }
    const double trace = square[0].x + square[1].y + square[2].z;
    rows = {square[0] / trace, square[1] / trace, square[2] / trace};
  }
  const Vec3 axis =
      unit(*std::max_element(rows.begin(), rows.end(), [](const Vec3& a, const Vec3& b) {
        return squared_norm(a) < squared_norm(b);
      }));
  return axis < Vec3{} ? -axis : axis;
}

class Labels {
 public:
  Labels(Delaunay& delaunay, const CgalCoconeOptions& options)
      : delaunay_(delaunay), options_(options) {}

  void find_candidates() {
    neighbors_.resize(delaunay_.number_of_vertices());
    for (const CellHandle c : delaunay_.finite_cell_handles()) {
      c->info().center = center_of(delaunay_, c);
    }
    for (const VertexHandle v : delaunay_.finite_vertex_handles()) find_poles(v);
    for (const Facet& f : delaunay_.finite_facets()) look_at_facet(f);
    label();
    for (const Facet& f : delaunay_.finite_facets()) {
      if (is_candidate(f)) set_surface(delaunay_, f, true);
    }
  }

 private:
  DualEdge dual_edge(const Facet& f) const {
    const CellHandle here = f.first;
    const CellHandle there = here->neighbor(f.second);
    if (delaunay_.is_infinite(here))
      return {there->info().center, outward_normal(delaunay_, here), true};
    if (delaunay_.is_infinite(there))
      return {here->info().center, outward_normal(delaunay_, there), true};
    return {here->info().center, there->info().center, false};
  }

  void find_poles(VertexHandle v) {
    VertexInfo& info = v->info();
    cells_.clear();
    delaunay_.incident_cells(v, std::back_inserter(cells_));
    std::vector<Vec3> hull_normals;
    Vec3 hull_sum;
    for (const CellHandle c : cells_) {
      if (!delaunay_.is_infinite(c)) continue;
      hull_normals.push_back(outward_normal(delaunay_, c));
      hull_sum = hull_sum + hull_normals.back();
    }
    info.degenerate = norm(hull_sum) < 0.1 * static_cast<double>(hull_normals.size());
    info.normal = hull_normals.empty() ? unit(farthest_center(v) - place(v))
                  : info.degenerate    ? principal_direction(hull_normals)
                                       : unit(hull_sum);
    for (const CellHandle c : cells_) {
      if (delaunay_.is_infinite(c)) {
        if (options_.tangent_plane_radius && dot(outward_normal(delaunay_, c), info.normal) <= 0) {
          info.radius = infinity;
        }
        continue;
      }
      const Vec3 x = c->info().center - place(v);
      if (dot(x, info.normal) < 0) info.height = std::max(info.height, norm(x));
    }
  }

  // Of the cells in cells_. Of equally far ones the lexicographically smallest.
  Vec3 farthest_center(VertexHandle v) const {
    Vec3 farthest = place(v);
    for (const CellHandle c : cells_) {
      const Vec3& center = c->info().center;
      const double length = distance(center, place(v));
      const double longest = distance(farthest, place(v));
      if (length > longest || (length == longest && center < farthest)) farthest = center;
    }
    const Vec3 wanted = v->info().normal_at_ties;
    Vec3 chosen = farthest;
    for (const CellHandle c : cells_) {
      const Vec3 arm = c->info().center - place(v);
      if (norm(arm) < (1 - rounding) * distance(farthest, place(v))) continue;
      if (dot(unit(arm), wanted) > dot(unit(chosen - place(v)), wanted)) chosen = place(v) + arm;
    }
    v->info().took_tie = distance(chosen, farthest) > 1e-9 * distance(farthest, place(v));
    return v->info().took_tie ? chosen : farthest;
  }

  // 1 or -1 in the double cone around the normal, else 0.
  int nappe(const Vec3& x, const Vec3& n) const {
    const double along = dot(x, n);
    return std::abs(along) <= options_.theta_cosine * norm(x) ? 0 : along > 0 ? 1 : -1;
  }
  bool meets_cocone(const DualEdge& e, VertexHandle v) const {
    const Vec3 p = place(v);
    const Vec3& n = v->info().normal;
    const int from = nappe(e.from - p, n);
    const int to = nappe(e.is_ray ? e.to : e.to - p, n);
    return from == 0 || to == 0 || from != to;
  }

  // The largest distance from v of a point of the dual edge in its cocone, or where the edge meets
  // the tangent plane.
  double radius_at(const DualEdge& e, VertexHandle v) const {
    // From the nearer end: flat cells have centers so far away that few digits of a sum are left.
    const bool from_other = !e.is_ray && distance(e.to, place(v)) < distance(e.from, place(v));
    const Vec3 x = (from_other ? e.to : e.from) - place(v);
    const Vec3 d = e.is_ray ? e.to : from_other ? e.from - e.to : e.to - e.from;
    const Vec3& n = v->info().normal;
    if (options_.tangent_plane_radius) {
      const double t = -dot(x, n) / dot(d, n);
      return t >= 0 && (e.is_ray || t <= 1) ? norm(x + t * d) : 0;
    }
    if (e.is_ray && nappe(d, n) == 0) return infinity;
    double radius = nappe(x, n) == 0 ? norm(x) : 0;
    if (!e.is_ray && nappe(x + d, n) == 0) radius = std::max(radius, norm(x + d));
    // Where the line crosses the cone: (x.n + t d.n)^2 = cos^2 |x + t d|^2.
    const double square = options_.theta_cosine * options_.theta_cosine;
    const double a = dot(d, n) * dot(d, n) - square * squared_norm(d);
    const double b = dot(x, n) * dot(d, n) - square * dot(x, d);
    const double c = dot(x, n) * dot(x, n) - square * squared_norm(x);
    const double discriminant = b * b - a * c;
    if (discriminant < 0 || a == 0) return radius;
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-b + sign * std::sqrt(discriminant)) / a;
      if (t >= 0 && (e.is_ray || t <= 1)) radius = std::max(radius, norm(x + t * d));
    }
    return radius;
  }

  void look_at_facet(const Facet& f) {
    const DualEdge e = dual_edge(f);
    for (int k = 0; k < 3; ++k) {
      const VertexHandle v = corner(f, k);
      if (!meets_cocone(e, v)) continue;
      v->info().radius = std::max(v->info().radius, radius_at(e, v));
      for (int j = 0; j < 3; ++j) {
        if (j != k) neighbors_[corner(f, j)->info().id].push_back(v);
      }
    }
  }

  bool ratio_condition(VertexHandle v) const {
    const VertexInfo& info = v->info();
    return !info.degenerate && info.radius <= options_.rho * info.height;
  }
  bool normals_agree(VertexHandle p, VertexHandle q) const {
    return std::abs(dot(p->info().normal, q->info().normal)) >= options_.alpha_cosine;
  }

  // neighbors_[p]: all q such that p is in the cocone neighborhood of q. A sample that is interior
  // passes it on to those of these that fulfil the ratio condition.
  void label() {
    std::vector<std::vector<VertexHandle>> passed_to(neighbors_.size());
    std::vector<VertexHandle> queue;
    for (const VertexHandle p : delaunay_.finite_vertex_handles()) {
      const std::uint32_t id = p->info().id;
      const auto agrees = [&](VertexHandle q) { return normals_agree(p, q); };
      for (const VertexHandle q : neighbors_[id]) passed_to[q->info().id].push_back(p);
      if (!ratio_condition(p) ||
          !std::all_of(neighbors_[id].begin(), neighbors_[id].end(), agrees)) {
        continue;
      }
      p->info().interior = true;
      queue.push_back(p);
    }
    while (!queue.empty()) {
      const VertexHandle q = queue.back();
      queue.pop_back();
      for (const VertexHandle p : passed_to[q->info().id]) {
        if (p->info().interior || !ratio_condition(p) || !normals_agree(p, q)) continue;
        p->info().interior = true;
        queue.push_back(p);
      }
    }
  }

  bool is_candidate(const Facet& f) const {
    const DualEdge e = dual_edge(f);
    bool someone_votes = false;
    for (int k = 0; k < 3; ++k) {
      const VertexHandle v = corner(f, k);
      if (!v->info().interior) continue;
      someone_votes = true;
      if (!meets_cocone(e, v)) return false;
    }
    return someone_votes;
  }

  Delaunay& delaunay_;
  const CgalCoconeOptions& options_;
  std::vector<std::vector<VertexHandle>> neighbors_;
  std::vector<CellHandle> cells_;
};

}  // namespace

bool find_candidates(Delaunay& delaunay, const CgalCoconeOptions& options) {
  Labels(delaunay, options).find_candidates();
  const auto vertices = delaunay.finite_vertex_handles();
  return std::any_of(vertices.begin(), vertices.end(),
                     [](VertexHandle v) { return v->info().interior; });
}

}  // namespace cocoon::ref::on_cgal

namespace cocoon::ref {

CgalCocone cgal_cocone(Points points, const CgalCoconeOptions& options) {
  using namespace on_cgal;
  Delaunay delaunay = triangulation_of(points);
  find_candidates(delaunay, options);
  CgalCocone result{IdVector<PointId, std::uint8_t>(points.size(), 0), {}};
  for (const VertexHandle v : delaunay.finite_vertex_handles()) {
    result.boundary[PointId(v->info().id)] = !v->info().interior;
  }
  for (const Facet& f : delaunay.finite_facets()) {
    if (!is_surface(f)) continue;
    std::array<PointId, 3> ids;
    for (int k = 0; k < 3; ++k) {
      ids[static_cast<std::size_t>(k)] = PointId(corner(f, k)->info().id);
    }
    std::sort(ids.begin(), ids.end());
    result.candidates.push_back(ids);
  }
  std::sort(result.candidates.begin(), result.candidates.end());
  return result;
}

}  // namespace cocoon::ref
