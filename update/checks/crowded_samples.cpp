#include "update/checks/crowded_samples.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "geom/arrays/median.h"
#include "geom/arrays/points_of.h"
#include "geom/messages/require_size.h"
#include "geom/search/equal_points.h"
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

bool are_many(std::size_t closer, std::size_t of, const CrowdedOptions& options) {
  return closer > 0 && static_cast<double>(closer) >= options.min_share * static_cast<double>(of);
}

struct Thickness {
  double share = 0;
  double length = 0;
};

// `apart`: those that keep `distance`; `few`: of few_of_layers().
Thickness thickness_of(Points samples, std::span<const PointId> apart, double distance,
                       const FewSamples& few, const Execution& execution) {
  const bool are_few = few.distance < distance;
  const double reach = are_few ? few.distance : distance;
  const double share = layer_thickness(samples, are_few ? few.kept : apart, reach, execution);
  return {share, share * reach};
}

// Sets the flags of its members' samples but for those at these places, which are ascending.
// Returns how many.
std::size_t flag_all_but(Points places, const JoinedCloud& cloud,
                         std::span<const std::vector<Point>> clouds,
                         std::vector<SampleFlags>& flags) {
  std::size_t flagged = 0;
  for (const std::size_t member : cloud.members) {
    auto flag = flags[member].begin();
    for (const Point& sample : clouds[member]) {
      *flag = std::binary_search(places.begin(), places.end(), sample) ? 0 : 1;
      flagged += *flag++;
    }
  }
  return flagged;
}

}  // namespace

CrowdedSamples crowded_samples(const ModelIndex& model, std::span<const VertexId> removed,
                               std::span<const JoinedCloud> joined,
                               std::span<const std::vector<Point>> clouds,
                               const CrowdedOptions& options, const Execution& execution) {
  require_options("crowded_samples", options);
  CrowdedSamples found;
  found.distance = options.distance * median_edge_at(model, removed);
  for (const std::vector<Point>& cloud : clouds) found.is_in_layers.emplace_back(cloud.size());
  if (found.distance == 0) return found;
  const std::vector<JoinedCloud> alone = each_by_itself(joined.empty() ? clouds.size() : 0);
  for (const JoinedCloud& cloud : joined.empty() ? std::span<const JoinedCloud>(alone) : joined) {
    for (const std::size_t member : cloud.members) {
      require_index("crowded_samples", "cloud", member, clouds.size());
    }
    // Ascending; one that is given twice crowds nobody.
    const std::vector<Point> samples = distinct_points(samples_of(cloud, clouds));
    const std::vector<PointId> apart = thin_points(samples, found.distance);
    const std::size_t closer = samples.size() - apart.size();
    if (!are_many(closer, samples.size(), options)) continue;
    const FewSamples few = few_of_layers(samples, 1);
    if (found.distance > options.max_coarseness * few.distance) continue;
    const Thickness thickness = thickness_of(samples, apart, found.distance, few, execution);
    found.closer += closer;
    found.of += samples.size();
    found.thickness = std::max(found.thickness, thickness.share);
    found.depth = std::max(found.depth, thickness.length);
    if (thickness.share < options.min_thickness) continue;
    found.in_layers += flag_all_but(points_of(samples, apart), cloud, clouds, found.is_in_layers);
  }
  return found;
}

}  // namespace cocoon
