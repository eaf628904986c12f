#include "cocone/umbrella.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "cocone/facets/cell_order.h"
#include "cocone/facets/facet_removal.h"
#include "cocone/prune_sharp_edges.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"

namespace cocoon {
namespace {

// The octahedron with its center: eight tetrahedra, eight hull facets, twelve inner facets.
struct Octahedron {
  Octahedron()
      : triangulation(
            delaunay(
                std::vector<Point>{
                    {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}})
                .triangulation) {}

  VertexId vertex(const Point& p) const {
    for (const VertexId v : triangulation.vertices()) {
      if (triangulation.point(v) == p) return v;
    }
    return {};
  }
  bool on_hull(FacetId f) const {
    return triangulation.is_infinite(cell_of(f)) ||
           triangulation.is_infinite(cell_of(triangulation.mirror(f)));
  }
  // Facets for which `wanted` holds.
  template <class Wanted>
  FacetSet facets(Wanted wanted) const {
    FacetSet set(triangulation.num_cells());
    for (const CellId c : triangulation.finite_cells()) {
      for (int i = 0; i < 4; ++i) {
        if (wanted(facet_id(c, i))) set.insert(triangulation, facet_id(c, i));
      }
    }
    return set;
  }
  bool contains(FacetId f, VertexId v) const {
    const auto corners = triangulation.facet_vertices(f);
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  }

  Triangulation triangulation;
};

VertexSet no_boundary(const Triangulation& t) { return VertexSet(t.num_vertices(), 0); }

// The facets at each edge of each facet.
using Neighbors = std::map<std::pair<FacetId, std::uint32_t>, std::set<FacetId>>;

Neighbors neighbors(const LinkedFacets& triangles) {
  Neighbors found;
  for (Halfedge halfedge = 0; halfedge < triangles.links.size(); ++halfedge) {
    auto& at_edge =
        found[{triangles.facets[triangle_of_halfedge(halfedge)], corner_of_halfedge(halfedge)}];
    for_each_at_edge(triangles.links, halfedge, [&](Halfedge other) {
      at_edge.insert(triangles.facets[triangle_of_halfedge(other)]);
    });
  }
  return found;
}

TEST(LinkedFacets, WithoutSomeTrianglesAreTheOthersLinked) {
  const Stages s(shapes::random_torus(400, 0.4, 5));
  Random random(9);
  for (const double share : {0.0, 0.01, 0.6, 1.0}) {
    FacetSet all(s.triangulation.num_cells());  // many at each edge
    for (const CellId c : s.triangulation.finite_cells()) {
      for (int i = 0; i < 4; ++i) all.insert(s.triangulation, facet_id(c, i));
    }
    const LinkedFacets triangles = link_facets(s.triangulation, all);
    std::vector<std::uint8_t> removed;
    for (const FacetId f : triangles.facets) {
      removed.push_back(random.uniform(0, 1) < share ? 1 : 0);
      if (removed.back() != 0) all.erase(s.triangulation, f);
    }
    const LinkedFacets left = without(s.triangulation, triangles, removed);
    const LinkedFacets anew = link_facets(s.triangulation, all);
    EXPECT_EQ(left.set, anew.set);
    EXPECT_EQ(left.size(), anew.size());
    EXPECT_EQ(neighbors(left), neighbors(anew));
    const auto count_edges = [](const LinkedFacets& of) {
      std::size_t count = 0;
      for (Halfedge halfedge = 0; halfedge < of.links.size(); ++halfedge)
        count += of.is_first(halfedge) ? 1U : 0U;
      return count;
    };
    EXPECT_EQ(count_edges(left), count_edges(anew));
  }
}

TEST(Umbrella, ClosedSurfaceHasGoodVertices) {
  const Octahedron o;
  ASSERT_EQ(o.triangulation.num_finite_cells(), 8U);
  const FacetSet hull = o.facets([&](FacetId f) { return o.on_hull(f); });
  const LinkedFacets fans = link_facets(o.triangulation, hull);
  EXPECT_EQ(fans.size(), 8U);
  const GoodVertices good = good_vertices(fans, no_boundary(o.triangulation));
  EXPECT_EQ(good.count, 6U);
  EXPECT_EQ(good.good[o.vertex({0, 0, 0})], 0);
  const VertexSet umbrella = vertices_with_umbrella(fans, o.triangulation.num_vertices(), 0.5);
  EXPECT_EQ(std::count(umbrella.begin(), umbrella.end(), 1), 6);
}

TEST(Umbrella, AMissingTriangleMakesItsCornersPoor) {
  const Octahedron o;
  const VertexId x = o.vertex({1, 0, 0});
  const VertexId y = o.vertex({0, 1, 0});
  const VertexId z = o.vertex({0, 0, 1});
  const FacetSet torn = o.facets([&](FacetId f) {
    return o.on_hull(f) && !(o.contains(f, x) && o.contains(f, y) && o.contains(f, z));
  });
  const LinkedFacets fans = link_facets(o.triangulation, torn);
  const GoodVertices good = good_vertices(fans, no_boundary(o.triangulation));
  EXPECT_EQ(good.count, 3U);
  for (const VertexId v : {x, y, z}) EXPECT_EQ(good.good[v], 0);
  // around the corners of the hole nothing closes either
  const VertexSet umbrella = vertices_with_umbrella(fans, o.triangulation.num_vertices(), 0.5);
  for (const VertexId v : {x, y, z}) EXPECT_EQ(umbrella[v], 0);
}

TEST(Umbrella, AThirdTriangleAtASpokeMakesAVertexPoorButLeavesItsUmbrella) {
  const Octahedron o;
  const VertexId x = o.vertex({1, 0, 0});
  const VertexId y = o.vertex({0, 1, 0});
  const VertexId center = o.vertex({0, 0, 0});
  const FacetSet flap = o.facets([&](FacetId f) {
    return o.on_hull(f) || (o.contains(f, x) && o.contains(f, y) && o.contains(f, center));
  });
  const LinkedFacets fans = link_facets(o.triangulation, flap);
  ASSERT_EQ(fans.size(), 9U);
  const GoodVertices good = good_vertices(fans, no_boundary(o.triangulation));
  EXPECT_EQ(good.good[x], 0);
  EXPECT_EQ(good.good[y], 0);
  EXPECT_EQ(good.count, 4U);
  EXPECT_EQ(vertices_with_umbrella(fans, o.triangulation.num_vertices(), 0.5)[x], 1);
}

TEST(Umbrella, BoundarySamplesAtCreasesAreDemoted) {
  // The dihedral of the octahedron is 109.5 degrees. Taken as a crease, its boundary samples are
  // poor; taken as a fold, every vertex is.
  const Octahedron o;
  const FacetSet hull = o.facets([&](FacetId f) { return o.on_hull(f); });
  const LinkedFacets fans = link_facets(o.triangulation, hull);
  VertexSet boundary = no_boundary(o.triangulation);
  boundary[o.vertex({1, 0, 0})] = 1;
  EXPECT_EQ(good_vertices(fans, boundary).count, 6U);
  const GoodVertices creased = good_vertices(fans, boundary, {.crease_cosine = -0.5});
  EXPECT_EQ(creased.count, 5U);
  EXPECT_EQ(creased.folded.size(), 1U);
  EXPECT_EQ(good_vertices(fans, boundary, {.fold_cosine = -0.5}).folded.size(), 6U);
}

// The number of cycles that the triangles at v make, two at each spoke; 0 if some spoke has another
// number.
std::size_t cycles_at(const LinkedFacets& triangles, VertexId v) {
  std::vector<std::uint32_t> fan;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Triangle& corners = triangles.corners[t];
    if (std::find(corners.begin(), corners.end(), v) != corners.end()) fan.push_back(t);
  }
  std::set<std::uint32_t> met;
  std::size_t cycles = 0;
  for (const std::uint32_t first : fan) {
    cycles += met.contains(first) ? 0U : 1U;
    for (std::vector<std::uint32_t> open = {first}; !open.empty();) {
      const std::uint32_t t = open.back();
      open.pop_back();
      if (!met.insert(t).second) continue;
      for (Halfedge halfedge = 3 * t; halfedge < 3 * t + 3; ++halfedge) {
        if (triangles.corners[t][corner_of_halfedge(halfedge)] == v) continue;
        if (!triangles.has_two_triangles(halfedge)) return 0;
        open.push_back(triangle_of_halfedge(triangles.links[halfedge]));
      }
    }
  }
  return cycles;
}

// Bodies that touch themselves at vertices and edges.
TEST(Umbrella, OneCycleOfTrianglesIsGood) {
  const Stages s(shapes::random_cube(400, 7));
  Random random(3);
  std::size_t pinched = 0;
  for (const double share : {0.01, 0.05, 0.2}) {
    IdVector<CellId, std::uint8_t> body(s.triangulation.num_cells(), 0);
    for (const CellId c : s.triangulation.finite_cells()) {
      body[c] = random.uniform(0, 1) < share ? 1 : 0;
    }
    FacetSet boundary(s.triangulation.num_cells());
    for (const CellId c : s.triangulation.finite_cells()) {
      for (int i = 0; i < 4; ++i) {
        if (body[c] == body[s.triangulation.neighbor(c, i)]) continue;
        boundary.insert(s.triangulation, facet_id(c, i));
      }
    }
    const LinkedFacets triangles = link_facets(s.triangulation, boundary);
    const GoodVertices good =
        good_vertices(triangles, no_boundary(s.triangulation), {.fold_cosine = 2});
    for (const VertexId v : s.triangulation.vertices()) {
      const std::size_t cycles = cycles_at(triangles, v);
      EXPECT_EQ(good.good[v] != 0, cycles == 1);
      pinched += cycles > 1 ? 1U : 0U;
    }
  }
  EXPECT_GT(pinched, 20U);
}

TEST(PruneSharpEdges, AFlapStaysWhereItsFreeEdgesHaveNoUmbrella) {
  // An inner facet hangs into the octahedron from the hull. At (1,0,0)-(0,1,0) the flap makes an
  // edge with three candidates; its other edges, with one candidate, end at the center, which has
  // no umbrella: pruning does not touch it.
  const Octahedron o;
  const VertexId x = o.vertex({1, 0, 0});
  const VertexId y = o.vertex({0, 1, 0});
  const VertexId center = o.vertex({0, 0, 0});
  const FacetSet flap = o.facets([&](FacetId f) {
    return o.on_hull(f) || (o.contains(f, x) && o.contains(f, y) && o.contains(f, center));
  });
  const PrunedCandidates guarded = prune_sharp_edges(o.triangulation, flap);
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
