// Clouds for models of any shape, and what must hold for an UpdateSession after every step.
#pragma once

#include <algorithm>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <vector>

#include "geom/mesh/triangle_order.h"
#include "geom/random/random.h"
#include "tests/cocone/equal_reconstructions.h"
#include "update/update_session.h"

namespace cocoon {

using Clouds = std::vector<std::vector<Point>>;

// The normals of a mesh at its vertices, weighted by area.
inline std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    const Point& a = mesh.points[t[0]];
    const Vec3 area = cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a);
    for (const VertexId v : t) normals[v.index()] = normals[v.index()] + area;
  }
  for (Vec3& normal : normals) normal = unit(normal);
  return normals;
}

// A scan of the part of the model within `reach` of a vertex: as many points as there are vertices,
// beside them on the surface, raised by a smooth hill of the given height in the inner two thirds.
inline std::vector<Point> scan_of(const TriangleMesh& model, VertexId center, double reach,
                                  double height, double jitter, Random& random) {
  const std::vector<Vec3> normals = vertex_normals(model);
  const Vec3 up = normals[center.index()];
  std::vector<Point> points;
  for (const VertexId v : model.points.ids()) {
    const Point& p = model.points[v];
    const double t = distance(p, model.points[center]) / (reach * 2 / 3);
    if (t > 1.5) continue;
    const Vec3 step = jitter * random.on_unit_sphere();
    const Vec3& normal = normals[v.index()];
    const Point beside = p + (step - dot(step, normal) * normal);
    points.push_back(t < 1 ? beside + height * (1 - t * t) * (1 - t * t) * up : beside);
  }
  return points;
}

inline double mean_edge(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      sum += distance(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]);
    }
  }
  return sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

// One or two scans of random places: hills, dents, and unchanged surface. Heights are at most
// `steepness` times the reach.
inline Clouds random_scans(const TriangleMesh& model, Random& random, double steepness = 0.5) {
  const double edge = mean_edge(model);
  Clouds clouds(random.below(4) == 0 ? 2 : 1);
  for (std::vector<Point>& cloud : clouds) {
    const VertexId center(random.below(model.points.size()));
    const double reach = edge * (4 + 6 * random.uniform());
    cloud = scan_of(model, center, reach, steepness * reach * (2 * random.uniform() - 1),
                    0.2 * edge, random);
  }
  return clouds;
}

// `actual` without its mesh.
inline void expect_equal_reports(const UpdateResult& actual, const UpdateResult& expected) {
  ASSERT_EQ(actual.status, expected.status) << actual.message << " / " << expected.message;
  EXPECT_EQ(actual.message, expected.message);
  EXPECT_EQ(actual.warnings, expected.warnings);
  EXPECT_TRUE(actual.vertex_map == expected.vertex_map);
  EXPECT_TRUE(actual.regions.region_of_facet == expected.regions.region_of_facet);
  EXPECT_TRUE(actual.regions.group_of_vertex == expected.regions.group_of_vertex);
  EXPECT_EQ(actual.regions.regions.size(), expected.regions.regions.size());
  EXPECT_EQ(actual.replaced_groups, expected.replaced_groups);
  EXPECT_EQ(actual.replacement.vertices.replaced, expected.replacement.vertices.replaced);
  EXPECT_EQ(actual.replacement.vertices.kept, expected.replacement.vertices.kept);
  EXPECT_EQ(actual.replacement.duplicates, expected.replacement.duplicates);
  EXPECT_EQ(actual.unscanned.far, expected.unscanned.far);
  EXPECT_EQ(actual.unscanned.vertices, expected.unscanned.vertices);
  EXPECT_EQ(actual.unscanned.farthest, expected.unscanned.farthest);
  EXPECT_EQ(actual.overlooked.vertices, expected.overlooked.vertices);
  EXPECT_EQ(actual.unused_changes.samples, expected.unused_changes.samples);
  EXPECT_EQ(actual.closed_openings.edges, expected.closed_openings.edges);
  EXPECT_EQ(actual.loose_parts.count, expected.loose_parts.count);
  EXPECT_EQ(actual.unexplained_handles, expected.unexplained_handles);
  EXPECT_EQ(actual.sampled_handles, expected.sampled_handles);
  EXPECT_EQ(actual.gaps.triangles, expected.gaps.triangles);
  EXPECT_EQ(actual.gaps.longest, expected.gaps.longest);
  EXPECT_EQ(actual.gaps.at, expected.gaps.at);
  EXPECT_EQ(actual.euler_before, expected.euler_before);
  EXPECT_EQ(actual.euler, expected.euler);
  ASSERT_EQ(actual.clouds.size(), expected.clouds.size());
  for (std::size_t c = 0; c < actual.clouds.size(); ++c) {
    EXPECT_EQ(actual.clouds[c].overlapping_facets, expected.clouds[c].overlapping_facets);
    EXPECT_EQ(actual.clouds[c].border.facets, expected.clouds[c].border.facets);
    EXPECT_EQ(actual.clouds[c].margin_deg, expected.clouds[c].margin_deg);
    EXPECT_EQ(actual.clouds[c].contradicted.count, expected.clouds[c].contradicted.count);
  }
  expect_equal_reconstruction(actual.reconstruction, expected.reconstruction);
}

// The change leads from one mesh to the other, and says nothing too much.
inline void expect_change(const TriangleMesh& before, const TriangleMesh& after,
                          const MeshChange& change) {
  const auto sorted = [](std::vector<Triangle> triangles) {
    for (Triangle& t : triangles) t = smallest_first(t);
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  const std::vector<Triangle> old = sorted(before.triangles.raw());
  std::vector<Triangle> kept;
  std::set_difference(old.begin(), old.end(), change.removed.begin(), change.removed.end(),
                      std::back_inserter(kept));
  ASSERT_EQ(kept.size() + change.removed.size(), old.size());
  for (Triangle& t : kept) {
    for (VertexId& v : t) {
      const VertexId mapped = change.vertex_map[v];
      ASSERT_FALSE(mapped.is_none());
      ASSERT_EQ(after.points[mapped], before.points[v]);
      v = mapped;
    }
  }
  const std::vector<Triangle> stay = sorted(kept);
  for (const Triangle& t : sorted(change.added)) {
    ASSERT_FALSE(std::binary_search(stay.begin(), stay.end(), t));
  }
  kept.insert(kept.end(), change.added.begin(), change.added.end());
  ASSERT_EQ(sorted(kept), sorted(after.triangles.raw()));
}

// Applies the clouds to the session and, from scratch, to its model; both must agree in everything.
// Returns whether the model was updated.
inline bool apply_and_compare(UpdateSession& session, const Clouds& clouds,
                              const Execution& execution = {}) {
  const TriangleMesh before = session.model();
  const std::size_t levels = session.undo_levels();
  const UpdateResult expected = update_model(before, clouds, session.options());
  SessionUpdate actual = session.apply(clouds, execution);
  if (actual.result.status == UpdateStatus::ok) {
    actual.result.reconstruction = session.reconstruction();
    const Points points = session.points();
    EXPECT_TRUE(std::equal(points.begin(), points.end(), expected.replacement.points.begin(),
                           expected.replacement.points.end()));
  }
  expect_equal_reports(actual.result, expected);
  if (expected.status != UpdateStatus::ok) {
    EXPECT_TRUE(session.model() == before);
    EXPECT_TRUE(actual.change.empty());
    EXPECT_EQ(session.undo_levels(), levels);
    return false;
  }
  EXPECT_TRUE(session.model() == expected.mesh);
  expect_change(before, session.model(), actual.change);
  return true;
}

}  // namespace cocoon
