#include "geom/mesh_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geom/mesh/halfedges.h"
#include "geom/triangle_normal.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// Carries what each addition rounds off.
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

EdgeLengths measure_edges(const TriangleMesh& mesh) {
  std::vector<double> lengths;
  const HalfedgeRings rings = link_halfedges(mesh);
  for (Halfedge halfedge = 0; halfedge < rings.links.size(); ++halfedge) {
    if (!rings.has_edge(halfedge) || !rings.is_last(halfedge)) continue;
    const auto [a, b] = ends_of_halfedge(mesh, halfedge);
    lengths.push_back(distance(mesh.points[a], mesh.points[b]));
  }
  if (lengths.empty()) return {};
  std::sort(lengths.begin(), lengths.end());
  const std::size_t n = lengths.size();
  CompensatedSum sum;
  for (const double length : lengths) sum.add(length);
  return {.count = n,
          .min = lengths.front(),
          .first_decile = lengths[n / 10],
          .median = lengths[n / 2],
          .last_decile = lengths[9 * n / 10],
          .max = lengths.back(),
          .mean = sum.value() / static_cast<double>(n)};
}

Box box_of_corners(const TriangleMesh& mesh) {
  Box box;
  for (const TriangleId t : mesh.triangles.ids()) {
    for (const Point& p : finite_corners_of(mesh, t)) box.include(p);
  }
  return box;
}

// Preconditions: valid triangles with finite corners, coordinates of working size.
MeshMeasure measure_at_working_size(const TriangleMesh& mesh, const Box& box) {
  MeshMeasure measure;
  measure.box = box;
  measure.edge_lengths = measure_edges(mesh);
  const Point origin = box.center();
  CompensatedSum area;
  CompensatedSum volume;
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto [p, q, r] = corners_of(mesh, t);
    area.add(norm(area_normal(p, q, r)) / 2);
    volume.add(volume_over(mesh, t, origin));
  }
  measure.area = area.value();
  measure.signed_volume = volume.value();
  return measure;
}

}  // namespace

// Areas take fourth powers of lengths: beyond working sizes they would overflow or vanish.
MeshMeasure mesh_measure(const TriangleMesh& mesh) {
  require_valid_triangles(mesh);
  const Box box = box_of_corners(mesh);
  const double scale = working_scale(std::array{box.low, box.high});
  if (scale == 1) return measure_at_working_size(mesh, box);
  const TriangleMesh copy = scaled(mesh, scale);
  MeshMeasure measure = measure_at_working_size(copy, box_of_corners(copy));
  measure.box = box;
  measure.area = measure.area / scale / scale;
  measure.signed_volume = measure.signed_volume / scale / scale / scale;
  EdgeLengths& edges = measure.edge_lengths;
  for (double* length : {&edges.min, &edges.first_decile, &edges.median, &edges.last_decile,
                         &edges.max, &edges.mean}) {
    *length /= scale;
  }
  return measure;
}

}  // namespace cocoon
