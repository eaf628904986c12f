#include "geom/signed_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "geom/mesh/halfedges.h"
#include "geom/search/closest_facet.h"
#include "geom/search/winding_number.h"
#include "geom/triangle_normal.h"
#include "geom/triangle_projection.h"
#include "geom/working_scale.h"

namespace cocoon {

namespace {

constexpr std::size_t grain = 1024;

// The angle-weighted normals of a mesh; they are sums and not of unit length.
class Pseudonormals {
 public:
  Pseudonormals(const TriangleMesh& mesh, HalfedgeRings rings)
      : mesh_(mesh), rings_(std::move(rings)), of_vertex_(mesh.points.size()) {
    for (const TriangleId t : mesh.triangles.ids()) {
      const TrianglePoints p = corners_of(mesh, t);
      of_facet_.push_back(unit(area_normal(p[0], p[1], p[2])));
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 u = p[(i + 1) % 3] - p[i];
        const Vec3 v = p[(i + 2) % 3] - p[i];
        const double angle = std::atan2(norm(cross(u, v)), dot(u, v));
        Vec3& sum = of_vertex_[mesh.triangles[t][i]];
        sum = sum + angle * of_facet_[t];
      }
    }
  }

  Vec3 at(TriangleId t, TriangleFeature feature) const {
    const Triangle& triangle = mesh_.triangles[t];
    switch (feature) {
      case TriangleFeature::vertex0:
        return of_vertex_[triangle[0]];
      case TriangleFeature::vertex1:
        return of_vertex_[triangle[1]];
      case TriangleFeature::vertex2:
        return of_vertex_[triangle[2]];
      case TriangleFeature::edge01:
        return at_edge(t, 2);
      case TriangleFeature::edge12:
        return at_edge(t, 0);
      case TriangleFeature::edge20:
        return at_edge(t, 1);
      case TriangleFeature::interior:
        break;
    }
    return of_facet_[t];
  }

 private:
  Vec3 at_edge(TriangleId t, std::size_t opposite_corner) const {
    const Halfedge halfedge = halfedge_of(t, opposite_corner);
    if (!rings_.has_edge(halfedge)) return of_facet_[t];
    Vec3 sum;  // from the first one on: the same from each of the triangles
    for_each_at_edge(rings_.links, first_at_edge(rings_.links, halfedge), [&](Halfedge at_edge) {
      sum = sum + of_facet_[TriangleId(triangle_of_halfedge(at_edge))];
    });
    return sum;
  }

  const TriangleMesh& mesh_;
  HalfedgeRings rings_;
  IdVector<TriangleId, Vec3> of_facet_;
  IdVector<VertexId, Vec3> of_vertex_;
};

// Tells inside from outside: winding numbers are exact as they are, normals want working sizes.
class InsideTest {
 public:
  InsideTest(const TriangleMesh& mesh, const TriangleMesh& scaled, const Execution& execution) {
    HalfedgeRings rings = link_halfedges(mesh, execution);
    if (is_balanced(mesh, rings, execution)) {
      numbers_.emplace(mesh, execution);
    } else {
      normals_.emplace(scaled, std::move(rings));
    }
  }

  // Of a point and itself scaled, with the closest one of the scaled mesh.
  bool contains(const Point& p, const Point& scaled, TriangleId closest,
                const ClosestPoint& foot) const {
    if (numbers_) return numbers_->at(p) != 0;
    return dot(scaled - foot.point, normals_->at(closest, foot.feature)) < 0;
  }

 private:
  std::optional<WindingNumbers> numbers_;  // of a closed mesh
  std::optional<Pseudonormals> normals_;   // of others
};

// From the corners in lexicographic order: the same bits as the tree's, in every rotation.
ClosestPoint foot_on(const Point& p, const TriangleMesh& mesh, TriangleId t) {
  const TrianglePoints corners = corners_of(mesh, t);
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return corners[i] < corners[j]; });
  ClosestPoint foot =
      closest_point_on_triangle(p, {corners[order[0]], corners[order[1]], corners[order[2]]});
  foot.feature = renumbered(foot.feature, order);
  return foot;
}

// `scaled`: the mesh times the scale, a power of two.
std::vector<double> distances_by_scale(const TriangleMesh& mesh, const TriangleMesh& scaled,
                                       double scale, Points points, const Execution& execution) {
  const ClosestFacetTree tree(scaled, execution, points.size());
  const InsideTest inside(mesh, scaled, execution);
  std::vector<double> distances(points.size());
  const StagePart part{"signed_distance"};
  parallel_chunks(execution, part, points.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t slot = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Point p = scale * points[i];
      const ClosestFacet facet = tree.closest(p, slot);
      const ClosestPoint foot = foot_on(p, scaled, facet.triangle);
      const double distance = std::sqrt(foot.squared_distance) / scale;
      distances[i] = inside.contains(points[i], p, facet.triangle, foot) ? -distance : distance;
    }
  });
  report_progress(execution, "signed_distance", 1);
  return distances;
}

}  // namespace

// Projections take fourth powers of lengths: beyond working sizes they would overflow or vanish.
std::vector<double> signed_distances(const TriangleMesh& mesh, Points points,
                                     const Execution& execution) {
  const double scale = common_scale(mesh.points.span(), points);
  if (scale == 1) return distances_by_scale(mesh, mesh, 1, points, execution);
  return distances_by_scale(mesh, scaled(mesh, scale), scale, points, execution);
}

}  // namespace cocoon
