#include "update/report/crowded_samples.h"

#include <utility>

#include "geom/arrays/median.h"
#include "geom/messages/require_size.h"
#include "geom/search/thin_points.h"
#include "update/cloud/layers.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// Of the edges of all triangles at the vertices, each as often as it has triangles there; 0 of
// none.
double median_edge_at(const ModelIndex& model, std::span<const VertexId> vertices) {
  const TriangleMesh& mesh = model.mesh();
  std::vector<double> lengths;
  for (const VertexId v : vertices) {
    require_index("crowded_samples", "vertex", v.index(), mesh.points.size());
    model.for_each_triangle_at(v, [&](TriangleId t) {
      for (const VertexId w : mesh.triangles[t]) {
        if (w != v) lengths.push_back(distance(mesh.points[v], mesh.points[w]));
      }
    });
  }
  return lengths.empty() ? 0 : median(std::move(lengths));
}

}  // namespace

CrowdedSamples crowded_samples(const ModelIndex& model, std::span<const VertexId> removed,
                               std::span<const std::vector<Point>> clouds,
                               const CrowdedOptions& options) {
  require_options("crowded_samples", options);
  CrowdedSamples found;
  found.distance = options.distance * median_edge_at(model, removed);
  std::vector<Point> samples;
  for (const std::vector<Point>& cloud : clouds) {
    samples.insert(samples.end(), cloud.begin(), cloud.end());
  }
  found.of = samples.size();
  const std::uint8_t is_any = found.distance > 0 ? 1 : 0;
  for (const std::vector<Point>& cloud : clouds) {
    found.is_closer.emplace_back(cloud.size(), is_any);
  }
  if (found.distance == 0) return found;
  const std::vector<PointId> apart = thin_points(samples, found.distance);
  found.closer = found.of - apart.size();
  found.thickness = layer_thickness(samples, apart, found.distance);
  std::size_t c = 0;
  std::size_t first = 0;  // of cloud c
  for (const PointId p : apart) {
    while (p.index() - first >= clouds[c].size()) first += clouds[c++].size();
    found.is_closer[c][PointId(p.index() - first)] = 0;
  }
  return found;
}

}  // namespace cocoon
