#include "cocone/energy/idle_samples.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <vector>

#include "cocone/facets/facet_size.h"
#include "tests/cocone/random_labeling.h"

namespace cocoon {
namespace {

// The definition, over all cells.
bool is_plainly_idle(const Labeling& labeling, VertexId v, const IdleOptions& options) {
  const Triangulation& t = labeling.stages.triangulation;
  std::vector<FacetId> facets;
  for (const CellId c : t.cells()) {
    for (int i = 0; i < 4; ++i) {
      if (labeling.out[c] != 0 || labeling.out[t.neighbor(c, i)] == 0) continue;
      const auto corners = t.facet_vertices(facet_id(c, i));
      if (std::find(corners.begin(), corners.end(), v) != corners.end()) {
        facets.push_back(facet_id(c, i));
      }
    }
  }
  if (facets.empty()) return false;
  std::vector<Vec3> normals;
  std::map<VertexId, double> distances;
  for (const FacetId f : facets) {
    std::vector<Point> p;
    for (const VertexId w : t.facet_vertices(f)) {
      p.push_back(t.point(w));
      if (w != v) distances[w] = distance(t.point(w), t.point(v));
    }
    std::sort(p.begin(), p.end());
    normals.push_back(cross(p[1] - p[0], p[2] - p[0]));
  }
  // The plane of the largest facet, ties by the larger normal.
  const Vec3 plane =
      unit(*std::max_element(normals.begin(), normals.end(), [](const Vec3& a, const Vec3& b) {
        return squared_norm(a) != squared_norm(b) ? squared_norm(a) < squared_norm(b) : a < b;
      }));
  std::vector<double> nearest;
  for (const auto& [w, distance] : distances) nearest.push_back(distance);
  std::sort(nearest.begin(), nearest.end());
  for (std::size_t k = 0; k < facets.size(); ++k) {
    if (std::abs(dot(unit(normals[k]), plane)) < options.flat_cosine) return false;
    const double radius = std::sqrt(size_of_facet(t, facets[k]).squared_circumradius);
    if (radius < options.ratio * nearest[1] * (1 - 1e-12)) return false;
  }
  return true;
}

TEST(IdleSamples, AreTheirDefinition) {
  std::size_t idle = 0;
  std::size_t others = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Labeling labeling(seed % 2 == 0 ? gallery::integer_grid(3) : shapes::random_cube(40, seed),
                      seed, 0.3);
    const Triangulation& t = labeling.stages.triangulation;
    for (const double flat_cosine : {IdleOptions{}.flat_cosine, 0.95, 0.8, 0.0}) {
      // Not such as circles of the lattice have.
      for (const double ratio : {0.33, 0.56, 0.63, 0.91, 1.7}) {
        const IdleOptions options{.flat_cosine = flat_cosine, .ratio = ratio};
        for (const VertexId v : t.vertices()) {
          const bool expected = is_plainly_idle(labeling, v, options);
          EXPECT_EQ(is_idle(t, labeling.stages.stars.star(v), labeling.out, v, options), expected)
              << "seed " << seed << ", vertex " << v.value;
          ++(expected ? idle : others);
        }
      }
    }
  }
  EXPECT_GT(idle, 100U);
  EXPECT_GT(others, 100U);
}

}  // namespace
}  // namespace cocoon
