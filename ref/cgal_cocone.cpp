#include "ref/cgal_cocone.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace cocoon::ref {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<PointId, Kernel>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using DataStructure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, DataStructure>;
using VertexHandle = Delaunay::Vertex_handle;
using CellHandle = Delaunay::Cell_handle;
using Facet = Delaunay::Facet;

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 to_vec3(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

// The dual of a facet: a Voronoi vertex, and another one or a direction.
struct Edge {
  Vec3 from;
  Vec3 to;
  bool is_ray = false;
};

struct Sample {
  Point position;
  Vec3 normal;
  double height = 0;
  double radius = 0;
  std::set<VertexHandle> in_cocone_of;  // all q with p in N_q
};

class PlainCocone {
 public:
  PlainCocone(Points points, const CgalCoconeOptions& options) : options_(options) {
    std::vector<std::pair<Kernel::Point_3, PointId>> labeled;
    for (std::size_t i = 0; i < points.size(); ++i) {
      labeled.emplace_back(Kernel::Point_3(points[i].x, points[i].y, points[i].z), PointId(i));
    }
    delaunay_.insert(labeled.begin(), labeled.end());
  }

  CgalCocone run(std::size_t count) {
    for (const VertexHandle v : delaunay_.finite_vertex_handles()) find_poles(v);
    for (const Facet& f : delaunay_.finite_facets()) look_at_facet(f);
    label();
    CgalCocone result{IdVector<PointId, std::uint8_t>(count, 0), {}};
    for (const auto& [v, sample] : samples_) result.boundary[v->info()] = !interior_.contains(v);
    for (const Facet& f : delaunay_.finite_facets()) {
      if (!is_candidate(f)) continue;
      std::array<PointId, 3> ids;
      for (int k = 0; k < 3; ++k) ids[static_cast<std::size_t>(k)] = corner(f, k)->info();
      std::sort(ids.begin(), ids.end());
      result.candidates.push_back(ids);
    }
    std::sort(result.candidates.begin(), result.candidates.end());
    return result;
  }

 private:
  static VertexHandle corner(const Facet& f, int k) {
    return f.first->vertex(Delaunay::vertex_triple_index(f.second, k));
  }

  Vec3 outward_normal(const CellHandle infinite_cell) const {
    const int i = infinite_cell->index(delaunay_.infinite_vertex());
    const CellHandle inside = infinite_cell->neighbor(i);
    const Vec3 apex = to_vec3(inside->vertex(inside->index(infinite_cell))->point());
    const Facet f{infinite_cell, i};
    const Vec3 a = to_vec3(corner(f, 0)->point());
    const Vec3 n =
        unit(cross(to_vec3(corner(f, 1)->point()) - a, to_vec3(corner(f, 2)->point()) - a));
    return dot(apex - a, n) > 0 ? -n : n;
  }

  Edge dual_edge(const Facet& f) const {
    const CellHandle here = f.first;
    const CellHandle there = here->neighbor(f.second);
    if (delaunay_.is_infinite(here))
      return {to_vec3(delaunay_.dual(there)), outward_normal(here), true};
    if (delaunay_.is_infinite(there))
      return {to_vec3(delaunay_.dual(here)), outward_normal(there), true};
    return {to_vec3(delaunay_.dual(here)), to_vec3(delaunay_.dual(there)), false};
  }

  void find_poles(VertexHandle v) {
    Sample sample;
    sample.position = to_vec3(v->point());
    std::vector<CellHandle> cells;
    delaunay_.incident_cells(v, std::back_inserter(cells));
    Vec3 hull_sum;
    Vec3 pole;
    std::size_t hull_facets = 0;
    for (const CellHandle c : cells) {
      if (delaunay_.is_infinite(c)) {
        hull_sum = hull_sum + outward_normal(c);
        ++hull_facets;
      } else if (const Vec3 x = to_vec3(delaunay_.dual(c)) - sample.position;
                 norm(x) > norm(pole)) {
        pole = x;
      }
    }
    sample.normal = unit(hull_facets == 0 ? pole : hull_sum);
    if (norm(hull_sum) < 0.1 * static_cast<double>(hull_facets)) degenerate_.insert(v);
    for (const CellHandle c : cells) {
      if (delaunay_.is_infinite(c)) {
        if (options_.tangent_plane_radius && dot(outward_normal(c), sample.normal) <= 0) {
          sample.radius = infinity;
        }
        continue;
      }
      const Vec3 x = to_vec3(delaunay_.dual(c)) - sample.position;
      if (dot(x, sample.normal) < 0) sample.height = std::max(sample.height, norm(x));
    }
    samples_[v] = sample;
  }

  // cos of the angle between y - p and the normal, in the double cone: 1 or -1, else 0.
  int nappe(const Vec3& x, const Vec3& n) const {
    const double along = dot(x, n);
    return std::abs(along) <= options_.theta_cosine * norm(x) ? 0 : along > 0 ? 1 : -1;
  }

  bool meets_cocone(const Edge& e, const Sample& s) const {
    const int from = nappe(e.from - s.position, s.normal);
    const int to = nappe(e.is_ray ? e.to : e.to - s.position, s.normal);
    return from == 0 || to == 0 || from != to;
  }

  // Where the edge leaves or enters { |y . n| <= cosine |y| }: bisection between the two ends,
  // which lie on different sides. cosine = 0 is the tangent plane.
  double crossing(Vec3 in, Vec3 out, const Vec3& n, double cosine) const {
    for (int i = 0; i < 200; ++i) {
      const Vec3 middle = 0.5 * (in + out);
      (std::abs(dot(middle, n)) <= cosine * norm(middle) ? in : out) = middle;
    }
    return norm(in);
  }

  double cocone_radius(const Edge& e, const Sample& s) const {
    const Vec3 x = e.from - s.position;
    const int from = nappe(x, s.normal);
    if (e.is_ray && nappe(e.to, s.normal) == 0) return infinity;
    const Vec3 y = e.is_ray ? x + 1e9 * (norm(x) + 1) * e.to : e.to - s.position;
    const int to = e.is_ray ? nappe(e.to, s.normal) : nappe(y, s.normal);
    if (from == 0 && to == 0) return std::max(norm(x), norm(y));
    if (from == 0) return std::max(norm(x), crossing(x, y, s.normal, options_.theta_cosine));
    if (to == 0) return std::max(norm(y), crossing(y, x, s.normal, options_.theta_cosine));
    const double t = dot(x, s.normal) / (dot(x, s.normal) - dot(y, s.normal));
    const Vec3 middle = x + t * (y - x);  // in the tangent plane, so in the cocone
    return std::max(crossing(middle, x, s.normal, options_.theta_cosine),
                    crossing(middle, y, s.normal, options_.theta_cosine));
  }

  double plane_radius(const Edge& e, const Sample& s) const {
    const Vec3 x = e.from - s.position;
    const Vec3 direction = e.is_ray ? e.to : e.to - e.from;
    const double t = -dot(x, s.normal) / dot(direction, s.normal);
    return t >= 0 && (e.is_ray || t <= 1) ? norm(x + t * direction) : 0;
  }

  void look_at_facet(const Facet& f) {
    const Edge e = dual_edge(f);
    for (int k = 0; k < 3; ++k) {
      Sample& s = samples_[corner(f, k)];
      if (!meets_cocone(e, s)) continue;
      s.radius = std::max(s.radius,
                          options_.tangent_plane_radius ? plane_radius(e, s) : cocone_radius(e, s));
      for (int j = 0; j < 3; ++j) {
        if (j != k) samples_[corner(f, j)].in_cocone_of.insert(corner(f, k));
      }
    }
  }

  bool ratio_condition(VertexHandle v) const {
    const Sample& s = samples_.at(v);
    return !degenerate_.contains(v) && s.radius <= options_.rho * s.height;
  }
  bool normals_agree(VertexHandle p, VertexHandle q) const {
    return std::abs(dot(samples_.at(p).normal, samples_.at(q).normal)) >= options_.alpha_cosine;
  }

  void label() {
    for (const auto& [p, s] : samples_) {
      const bool normals = std::all_of(s.in_cocone_of.begin(), s.in_cocone_of.end(),
                                       [&, v = p](VertexHandle q) { return normals_agree(v, q); });
      if (ratio_condition(p) && normals) interior_.insert(p);
    }
    for (std::size_t before = interior_.size() + 1; before != interior_.size();) {
      before = interior_.size();
      for (const auto& [p, s] : samples_) {
        if (!ratio_condition(p)) continue;
        for (const VertexHandle q : s.in_cocone_of) {
          if (interior_.contains(q) && normals_agree(p, q)) interior_.insert(p);
        }
      }
    }
  }

  bool is_candidate(const Facet& f) const {
    const Edge e = dual_edge(f);
    bool someone_votes = false;
    for (int k = 0; k < 3; ++k) {
      const VertexHandle v = corner(f, k);
      if (!interior_.contains(v)) continue;
      someone_votes = true;
      if (!meets_cocone(e, samples_.at(v))) return false;
    }
    return someone_votes;
  }

  CgalCoconeOptions options_;
  Delaunay delaunay_;
  std::map<VertexHandle, Sample> samples_;
  std::set<VertexHandle> degenerate_;
  std::set<VertexHandle> interior_;
};

}  // namespace

CgalCocone cgal_cocone(Points points, const CgalCoconeOptions& options) {
  return PlainCocone(points, options).run(points.size());
}

}  // namespace cocoon::ref
