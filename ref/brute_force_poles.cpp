#include "ref/brute_force_poles.h"

#include <algorithm>
#include <vector>

#include "cocone/samples/hull_normal.h"

namespace cocoon::ref {
namespace {

struct VoronoiCell {
  std::vector<Point> vertices;   // circumcenters of the finite cells at p
  std::vector<Vec3> directions;  // of its unbounded edges
};

VoronoiCell voronoi_cell(const Triangulation& triangulation, const Dual& dual, VertexId p) {
  VoronoiCell result;
  for (const CellId c : triangulation.cells()) {
    const auto& vertices = triangulation.cell(c).vertices;
    if (std::find(vertices.begin(), vertices.end(), p) == vertices.end()) continue;
    (triangulation.is_infinite(c) ? result.directions : result.vertices).push_back(dual.centers[c]);
  }
  return result;
}

Point farthest(const VoronoiCell& cell, const Point& p) {
  Point best = cell.vertices.front();
  for (const Point& c : cell.vertices) {
    const double difference = squared_distance(c, p) - squared_distance(best, p);
    if (difference > 0 || (difference == 0 && c < best)) best = c;
  }
  return best;
}

}  // namespace

Poles brute_force_poles(const Triangulation& triangulation, const Dual& dual) {
  const std::size_t count = triangulation.num_vertices();
  Poles poles{IdVector<VertexId, Vec3>(count), IdVector<VertexId, double>(count),
              VertexSet(count, 0), 0, 0};
  for (const VertexId v : triangulation.vertices()) {
    const Point& p = triangulation.point(v);
    VoronoiCell cell = voronoi_cell(triangulation, dual, v);
    if (cell.directions.empty()) {
      poles.normals[v] = unit(farthest(cell, p) - p);
    } else {
      ++poles.hull_vertices;
      std::sort(cell.directions.begin(), cell.directions.end());
      Vec3 sum;
      for (const Vec3& d : cell.directions) sum = sum + d;
      poles.normals[v] = unit(sum);
      if (norm(sum) < 0.1 * static_cast<double>(cell.directions.size())) {
        poles.normals[v] = hull_normal(cell.directions).normal;  // an eigenvector: not redone here
        poles.degenerate[v] = 1;
        ++poles.degenerate_vertices;
      }
    }
    for (const Point& c : cell.vertices) {
      if (dot(c - p, poles.normals[v]) < 0) {
        poles.heights[v] = std::max(poles.heights[v], distance(c, p));
      }
    }
  }
  return poles;
}

}  // namespace cocoon::ref
