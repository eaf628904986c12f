// A random change of a real shape, with a scan of the changed place and the truth about it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "geom/mesh/triangle_neighbors.h"
#include "geom/random/random.h"
#include "geom/random/random_point.h"
#include "geom/triangle_mesh.h"
#include "tests/end_to_end/local_update.h"
#include "tests/end_to_end/spread_points.h"

namespace cocoon::testing {

// A hill or a dent along one direction: what lies within `radius` of the center is moved.
struct RandomChange {
  Point center;
  Vec3 up;                        // unit
  double radius = 0;              // the scan reaches 1.3 times as far
  double height = 0;              // negative: a dent
  std::vector<TriangleId> place;  // the facets around the center that the scan may show

  double offset(const Point& p) const { return height * hill(distance(p, center), radius); }
  Point moved(const Point& p) const { return p + offset(p) * up; }
};

// Facets that hang together with `first` within `reach` of its first corner.
inline std::vector<TriangleId> facets_around(const TriangleMesh& mesh,
                                             const TriangleNeighbors& neighbors, TriangleId first,
                                             double reach) {
  const Point& center = mesh.points[mesh.triangles[first][0]];
  std::vector<TriangleId> found{first};
  IdVector<TriangleId, std::uint8_t> seen(mesh.triangles.size(), 0);
  seen[first] = 1;
  for (std::size_t next = 0; next < found.size(); ++next) {
    for (const TriangleId t : neighbors[found[next]]) {
      if (seen[t] != 0 || distance(mesh.points[mesh.triangles[t][0]], center) > reach) continue;
      seen[t] = 1;
      found.push_back(t);
    }
  }
  return found;
}

inline Vec3 area_vector(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return 0.5 * cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

// 8 to 14 spacings wide and at most a quarter of that high. Nothing where the surface turns too
// much for that: where it would meet itself.
inline std::optional<RandomChange> random_change(const TriangleMesh& mesh,
                                                 const TriangleNeighbors& neighbors, double spacing,
                                                 Random& random) {
  RandomChange change;
  const TriangleId first(random.below(mesh.triangles.size()));
  change.center = mesh.points[mesh.triangles[first][0]];
  change.radius = spacing * (8 + 6 * random.uniform());
  change.height = change.radius * 0.25 * (2 * random.uniform() - 1);
  change.place = facets_around(mesh, neighbors, first, 1.35 * change.radius);
  Vec3 sum{};
  for (const TriangleId t : change.place) {
    if (distance(mesh.points[mesh.triangles[t][0]], change.center) > change.radius) continue;
    sum = sum + area_vector(mesh, t);
  }
  change.up = unit(sum);
  for (const TriangleId t : change.place) {
    if (distance(mesh.points[mesh.triangles[t][0]], change.center) > change.radius) continue;
    if (dot(unit(area_vector(mesh, t)), change.up) < 0.2) return {};
  }
  return change;
}

// Samples of the changed place no closer to each other than 0.75 spacings, as if scanned anew.
inline std::vector<Point> scan_of(const TriangleMesh& mesh, const RandomChange& change,
                                  double spacing, Random& random) {
  std::vector<double> areas;
  for (const TriangleId t : change.place) {
    areas.push_back((areas.empty() ? 0 : areas.back()) + norm(area_vector(mesh, t)));
  }
  SpreadPoints scan(0.75 * spacing);
  const double darts = 60 * areas.back() / (spacing * spacing);
  for (double thrown = 0; thrown < darts; ++thrown) {
    const auto at = std::lower_bound(areas.begin(), areas.end(), random.uniform() * areas.back());
    const auto& [a, b, c] =
        mesh.triangles[change.place[static_cast<std::size_t>(at - areas.begin())]];
    const Point p = random_point_in(mesh.points[a], mesh.points[b], mesh.points[c], random);
    if (distance(p, change.center) > 1.3 * change.radius) continue;
    scan.add(change.moved(p));
  }
  return scan.points();
}

}  // namespace cocoon::testing
