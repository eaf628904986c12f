#include "cocone/prune_sharp_edges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "cocone/candidate_triangles.h"
#include "cocone/facets/cell_order.h"
#include "tests/cocone/octahedron.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

TEST(PruneSharpEdges, AFlapStaysWhereItsFreeEdgesHaveNoUmbrella) {
  // An inner facet hangs into the octahedron from the hull. At (1,0,0)-(0,1,0) the flap makes an
  // edge with three candidates; its other edges, with one candidate, end at the center, which has
  // no umbrella: pruning does not touch it.
  const Octahedron o;
  const PrunedCandidates guarded = prune_sharp_edges(o.triangulation, o.hull_with_flap());
  EXPECT_EQ(guarded.pruned, 0U);
  EXPECT_EQ(guarded.umbrellas, 6U);
}

TEST(PruneSharpEdges, AFreeEdgeBetweenUmbrellasIsPruned) {
  // The four inner facets in the plane z = 0 give the center an umbrella. A facet that stands on
  // them has one free edge, from the center to (0,0,1), both with an umbrella: it goes, alone.
  const Octahedron o;
  const VertexId x = o.vertex({1, 0, 0});
  const VertexId top = o.vertex({0, 0, 1});
  const VertexId bottom = o.vertex({0, 0, -1});
  FacetId standing;
  const FacetSet candidates = o.facets([&](FacetId f) {
    if (o.on_hull(f)) return true;
    if (!o.contains(f, top) && !o.contains(f, bottom)) return true;
    const bool is_standing = o.contains(f, top) && o.contains(f, x);
    if (is_standing) standing = f;
    return is_standing;
  });
  ASSERT_EQ(candidates.size(), 13U);
  const PrunedCandidates result = prune_sharp_edges(o.triangulation, candidates);
  EXPECT_EQ(result.umbrellas, 7U);
  EXPECT_EQ(result.pruned, 1U);
  EXPECT_FALSE(result.left.set.contains(standing));
}

TEST(PruneSharpEdges, DoesNotDependOnInputOrder) {
  const std::vector<Point> points = shapes::noisy_sphere(3000, 0.01, 2);
  const auto pruned_points = [](const std::vector<Point>& cloud) {
    const Stages s(cloud);
    const FacetSet candidates =
        candidate_triangles(s.triangulation, s.cocones, s.labels().boundary);
    const PrunedCandidates pruned = prune_sharp_edges(s.triangulation, candidates);
    EXPECT_GT(pruned.pruned, 20U);
    EXPECT_EQ(pruned.candidates - pruned.pruned, pruned.left.size());
    std::multiset<std::array<Point, 3>> left;
    pruned.left.set.for_each(s.triangulation,
                             [&](FacetId f) { left.insert(sorted_corners(s.triangulation, f)); });
    return left;
  };
  EXPECT_EQ(pruned_points(points), pruned_points(shapes::shuffled(points, 5)));
}

// Whether each triangle of `all` is pruned.
std::vector<std::uint8_t> pruned_flags(const LinkedFacets& all, const FacetSet& left) {
  std::vector<std::uint8_t> flags;
  for (const FacetId f : all.facets) flags.push_back(left.contains(f) ? 0 : 1);
  return flags;
}

// A part is pruned as the whole is, once no triangle at its rim ends in another way.
TEST(PruneSharpEdges, APartEndsAsTheWhole) {
  const Stages s(shapes::noisy_sphere(3000, 0.01, 2));
  const Triangulation& t = s.triangulation;
  const FacetSet candidates = candidate_triangles(t, s.cocones, s.labels().boundary);
  const LinkedFacets triangles = link_facets(t, candidates);
  const PrunedCandidates whole = prune_sharp_edges(t, candidates);
  const std::vector<std::uint8_t> expected = pruned_flags(triangles, whole.left.set);
  EXPECT_EQ(prune_part(triangles, VertexSet(t.num_vertices(), 1), whole.umbrella), expected);
  EXPECT_EQ(prune_part(triangles, VertexSet(t.num_vertices(), 0), whole.umbrella),
            std::vector<std::uint8_t>(triangles.size(), 0));

  VertexSet core(t.num_vertices(), 0);
  for (const VertexId v : t.vertices()) core[v] = t.point(v).x > 0.3 ? 1 : 0;
  const auto corners_in_core = [&](std::uint32_t k) {
    int count = 0;
    for (const VertexId v : triangles.corners[k]) count += core[v];
    return count;
  };
  std::vector<std::uint8_t> removed;
  for (bool grows = true; grows;) {
    removed = prune_part(triangles, core, whole.umbrella);
    std::vector<VertexId> more;
    for (std::uint32_t k = 0; k < removed.size(); ++k) {
      if (removed[k] == expected[k] || corners_in_core(k) != 1) continue;
      more.insert(more.end(), triangles.corners[k].begin(), triangles.corners[k].end());
    }
    for (const VertexId v : more) core[v] = 1;
    grows = !more.empty();
  }
  EXPECT_LT(2 * std::count(core.begin(), core.end(), 1), std::ptrdiff_t(t.num_vertices()));
  std::size_t pruned = 0;
  for (std::uint32_t k = 0; k < removed.size(); ++k) {
    if (corners_in_core(k) == 0) continue;
    EXPECT_EQ(removed[k], expected[k]);
    pruned += removed[k];
  }
  EXPECT_GT(pruned, 5U);
}

}  // namespace
}  // namespace cocoon
