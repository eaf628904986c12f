#include "ref/cgal_cocone.h"

#include <algorithm>
#include <cmath>

#include "ref/cgal_triangulation.h"

namespace cocoon::ref::on_cgal {
namespace {

// The dual of a facet: a Voronoi vertex, and another one or a direction.
struct DualEdge {
  Vec3 from;
  Vec3 to;
  bool is_ray = false;
};

class Labels {
 public:
  Labels(Delaunay& delaunay, const CgalCoconeOptions& options)
      : delaunay_(delaunay), options_(options) {}

  void find_candidates() {
    neighbors_.resize(delaunay_.number_of_vertices());
    for (const CellHandle c : delaunay_.finite_cell_handles()) {
      c->info().center = to_vec3(delaunay_.dual(c));
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
    Vec3 hull_sum;
    Vec3 pole;
    std::size_t hull_facets = 0;
    for (const CellHandle c : cells_) {
      if (delaunay_.is_infinite(c)) {
        hull_sum = hull_sum + outward_normal(delaunay_, c);
        ++hull_facets;
      } else if (const Vec3 x = c->info().center - place(v); norm(x) > norm(pole)) {
        pole = x;
      }
    }
    info.normal = unit(hull_facets == 0 ? pole : hull_sum);
    info.degenerate = norm(hull_sum) < 0.1 * static_cast<double>(hull_facets);
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
    const Vec3 x = e.from - place(v);
    const Vec3 d = e.is_ray ? e.to : e.to - e.from;
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

void find_candidates(Delaunay& delaunay, const CgalCoconeOptions& options) {
  Labels(delaunay, options).find_candidates();
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
