#include "cocone/clean_up/handle_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "cocone/facets/cell_order.h"
#include "delaunay/circulate.h"
#include "tests/cocone/random_labeling.h"
#include "tests/cocone/renumbered.h"

namespace cocoon {
namespace {

struct Surface {
  explicit Surface(const Labeling& labeling) {
    const Triangulation& t = labeling.stages.triangulation;
    for (const CellId c : t.finite_cells()) {
      for (int i = 0; i < 4 && labeling.out[c] == 0; ++i) {
        const FacetId f = facet_id(c, i);
        if (labeling.out[t.neighbor(c, i)] == 0) continue;
        Triangle v = t.facet_vertices(f);
        facets.push_back(f);
        for (std::size_t k = 0; k < 3; ++k) directed[{v[k], v[(k + 1) % 3]}].push_back(f);
        std::sort(v.begin(), v.end());
        corners.insert(v);
      }
    }
  }
  bool has_edge(VertexId a, VertexId b) const { return directed.count({a, b}) != 0; }

  std::vector<FacetId> facets;  // seen from inside
  std::map<std::pair<VertexId, VertexId>, std::vector<FacetId>> directed;
  std::set<Triangle> corners;
};

// Facets hang together over edges off the loop if cells inside lead from one to the other around
// the edge: by labels that spread until nothing changes.
bool divides(const Labeling& labeling, const Surface& surface, const Triangle& loop) {
  const Triangulation& t = labeling.stages.triangulation;
  const auto on_loop = [&](VertexId v) { return v == loop[0] || v == loop[1] || v == loop[2]; };
  std::map<FacetId, FacetId> root;
  for (const FacetId f : surface.facets) root[f] = f;
  for (bool changed = true; changed;) {
    changed = false;
    for (const FacetId f : surface.facets) {
      const Triangle v = t.facet_vertices(f);
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = v[k];
        const VertexId b = v[(k + 1) % 3];
        if (on_loop(a) && on_loop(b)) continue;
        FacetId g = f;
        do {
          g = other_facet_at_edge(t, g, a, b);
          if (labeling.out[cell_of(t.mirror(g))] != 0) break;
          g = t.mirror(g);
        } while (true);
        changed = changed || root[f] != root[g];
        root[f] = root[g] = std::min(root[f], root[g]);
      }
    }
  }
  return root[surface.directed.at({loop[0], loop[1]})[0]] !=
         root[surface.directed.at({loop[1], loop[0]})[0]];
}

TEST(HandleLoops, AreAllEmptyTrianglesOfTheSurface) {
  for (const double bias : {0.3, 0.6}) {
    Labeling labeling(shapes::random_cube(60, 3), 7, bias);
    const DoubtfulRegion region = whole(labeling);
    const Surface surface(labeling);
    std::set<Triangle> expected;
    for (const auto& [edge, facets] : surface.directed) {
      const auto [a, b] = edge;
      for (const VertexId c : labeling.stages.triangulation.vertices()) {
        Triangle corners = {a, b, c};
        std::sort(corners.begin(), corners.end());
        if (!surface.has_edge(b, c) || !surface.has_edge(c, a)) continue;
        if (surface.corners.count(corners) == 0) expected.insert(corners);
      }
    }
    HandleLoops loops(labeling.stages.triangulation, labeling.stars, labeling.out);
    std::set<Triangle> found;
    for (Triangle loop : loops.find(region)) {
      for (std::size_t k = 0; k + 1 < 3; ++k)
        EXPECT_LT(region.rank[loop[k]], region.rank[loop[k + 1]]);
      std::sort(loop.begin(), loop.end());
      EXPECT_TRUE(found.insert(loop).second);
    }
    EXPECT_GT(found.size(), 20U);
    EXPECT_TRUE(found == expected);
  }
}

TEST(HandleLoops, AreHandlesIfTheyDoNotDivideTheSurface) {
  std::size_t handles = 0;
  std::size_t others = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Labeling labeling(shapes::random_cube(60, seed), seed, 0.25);
    const Surface surface(labeling);
    HandleLoops loops(labeling.stages.triangulation, labeling.stars, labeling.out);
    for (const Triangle& loop : loops.find(whole(labeling))) {
      const bool manifold = [&] {
        for (std::size_t k = 0; k < 3; ++k) {
          const VertexId a = loop[k];
          const VertexId b = loop[(k + 1) % 3];
          if (surface.directed.at({a, b}).size() != 1) return false;
        }
        return true;
      }();
      const bool expected = manifold && !divides(labeling, surface, loop);
      EXPECT_EQ(loops.is_handle(loop, 100000), expected);
      EXPECT_FALSE(loops.is_handle(loop, 0));
      handles += expected ? 1U : 0U;
      others += manifold && !expected ? 1U : 0U;
    }
  }
  EXPECT_GT(handles, 20U);
  EXPECT_GT(others, 20U);
}

// Cells are told by their corners to be IN, one of four is not.
Labeling told_by_corners(Triangulation triangulation) {
  Labeling labeling(std::move(triangulation));
  const Triangulation& t = labeling.stages.triangulation;
  for (const CellId c : t.finite_cells()) {
    double sum = 0;
    for (const Point& p : sorted_corners(t, c)) sum += 7 * p.x + 11 * p.y + 13 * p.z;
    labeling.out[c] = sum - std::floor(sum) < 0.25 ? 1 : 0;
  }
  return labeling;
}

TEST(HandleLoops, ALimitOfTheSearchTellsTheSameWhateverTheNumbers) {
  const auto handles = [](const Triangulation& triangulation, std::size_t most_facets) {
    Labeling labeling = told_by_corners(triangulation);
    const Triangulation& t = labeling.stages.triangulation;
    HandleLoops loops(t, labeling.stars, labeling.out);
    std::set<std::array<Point, 3>> found;
    for (const Triangle& loop : loops.find(whole(labeling))) {
      if (!loops.is_handle(loop, most_facets)) continue;
      found.insert({t.point(loop[0]), t.point(loop[1]), t.point(loop[2])});
    }
    return found;
  };
  std::size_t all = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Triangulation triangulation = delaunay(shapes::random_cube(60, seed)).triangulation;
    for (const std::size_t most_facets : {6U, 8U, 11U, 16U, 23U}) {
      const auto found = handles(triangulation, most_facets);
      EXPECT_TRUE(found == handles(renumbered(triangulation, seed), most_facets));
      all += found.size();
    }
  }
  EXPECT_GT(all, 20U);
}

}  // namespace
}  // namespace cocoon
