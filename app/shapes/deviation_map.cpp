#include "app/shapes/deviation_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geom/mesh/used_vertices.h"
#include "geom/search/nearest_point.h"
#include "geom/signed_distance.h"
#include "geom/working_scale.h"
#include "io/mesh_file.h"

namespace cocoon::app {

namespace {

std::vector<double> distances_from(const TriangleMesh& b, Points points,
                                   const Execution& execution) {
  if (!b.triangles.empty()) return signed_distances(b, points, execution);
  const double scale = common_scale(points, b.points.span());
  const std::vector<Point> scaled_b = scaled(b.points.span(), scale);
  const NearestPointTree tree(scaled_b);
  std::vector<double> distances(points.size());
  const StagePart part{"nearest_point"};
  parallel_chunks(execution, part, points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      distances[i] = std::sqrt(tree.nearest(scale * points[i]).squared_distance) / scale;
    }
  });
  return distances;
}

// Those of vertices on the surface, if there is one.
std::vector<double> without_unused(const TriangleMesh& mesh, const std::vector<double>& distances) {
  if (mesh.triangles.empty()) return distances;
  const IdVector<VertexId, std::uint8_t> is_used = used_vertices(mesh);
  std::vector<double> used;
  for (const VertexId v : is_used.ids()) {
    if (is_used[v] != 0) used.push_back(distances[v.index()]);
  }
  return used;
}

// Relative to the largest, whose square may not be in the range of double.
double root_mean_square(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (largest == 0) return 0;
  double sum = 0;
  for (const double value : values) sum += (value / largest) * (value / largest);
  return largest * std::sqrt(sum / static_cast<double>(values.size()));
}

using Channels = std::array<std::vector<std::uint8_t>, 3>;

// White at 0, red from `full` on, blue from -full on; where that is 0, next to 0.
Channels colors_of(std::span<const double> distances, double full) {
  Channels channels;
  for (const double distance : distances) {
    const double share = distance == 0 ? 0
                         : full > 0    ? std::clamp(distance / full, -1.0, 1.0)
                                       : std::copysign(1.0, distance);
    const auto faded = static_cast<std::uint8_t>(std::lround(255 * (1 - std::abs(share))));
    channels[0].push_back(share < 0 ? faded : 255);
    channels[1].push_back(faded);
    channels[2].push_back(share > 0 ? faded : 255);
  }
  return channels;
}

}  // namespace

void write_deviation(Job& job, const TriangleMesh& a, const TriangleMesh& b,
                     const DeviationOutput& output) {
  const std::vector<double> distances = timed(job.execution(), "deviation", [&] {
    return distances_from(b, a.points.span(), job.execution());
  });
  constexpr double spread = 3;
  const double full =
      std::min(output.full_color.value_or(spread * root_mean_square(without_unused(a, distances))),
               std::numeric_limits<double>::max());
  VertexProperties properties;
  properties.rows = distances.size();
  properties.columns.push_back(property_of("distance", distances));
  const Channels channels = colors_of(distances, full);
  constexpr std::array names = {"red", "green", "blue"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    properties.columns.push_back(property_of(names[i], channels[i]));
  }
  timed(job.execution(), "write",
        [&] { write_mesh(output.file, a, properties, output.writing, job.outputs()); });
  const bool has_signs = !b.triangles.empty();
  job.report().set("deviation/signed", has_signs);
  job.report().set("deviation/full_color", full);
  job.say_outputs("A with its distances from B -> {} (red {} from {:.6g} on{})", output.file,
                  has_signs ? "outside" : "away", full, has_signs ? ", blue inside" : "");
}

}  // namespace cocoon::app
