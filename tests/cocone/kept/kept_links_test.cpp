// Links that go on from those before are the ones of link_facets, whatever the history.
#include "cocone/kept/kept_links.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cocone/facets/facet_removal.h"
#include "cocone/live/known_candidates.h"
#include "geom/random/random.h"
#include "tests/cocone/kept/live_samples.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"
#include "tests/long_tests.h"

namespace cocoon {
namespace {

struct LinkedTriangle {
  FacetId mirror;
  Triangle corners;
  Vec3 normal;
  std::array<std::vector<FacetId>, 3> at_side;  // the facets at it, ascending
  friend bool operator==(const LinkedTriangle&, const LinkedTriangle&) = default;
};

std::map<FacetId, LinkedTriangle> by_facet(const LinkedFacets& linked) {
  std::map<FacetId, LinkedTriangle> triangles;
  for (std::uint32_t t = 0; t < linked.size(); ++t) {
    LinkedTriangle& triangle = triangles[linked.facets[t]];
    triangle = {linked.mirrors[t], linked.corners[t], linked.normals[t], {}};
    for (std::uint32_t i = 0; i < 3; ++i) {
      for_each_at_edge(linked.links, 3 * t + i, [&](Halfedge halfedge) {
        triangle.at_side[i].push_back(linked.facets[triangle_of_halfedge(halfedge)]);
      });
      std::sort(triangle.at_side[i].begin(), triangle.at_side[i].end());
    }
  }
  return triangles;
}

// Each steep edge by its halfedges.
using FacetSide = std::pair<FacetId, std::uint32_t>;
std::set<std::vector<FacetSide>> steep_by_facets(const LinkedFacets& linked) {
  std::set<std::vector<FacetSide>> steep;
  for (const Halfedge first : linked.steep) {
    EXPECT_TRUE(linked.is_first(first));
    std::vector<FacetSide> halfedges;
    for_each_at_edge(linked.links, first, [&](Halfedge halfedge) {
      halfedges.emplace_back(linked.facets[triangle_of_halfedge(halfedge)],
                             corner_of_halfedge(halfedge));
    });
    std::sort(halfedges.begin(), halfedges.end());
    EXPECT_TRUE(steep.insert(std::move(halfedges)).second);
  }
  return steep;
}

void run_steps(const std::vector<Point>& points, const std::vector<Point>& others, double reach,
               std::size_t count) {
  const std::size_t steps = count * test::long_factor();
  Random random(22);
  LiveSamples samples(points);
  KeptLinks kept;
  const auto follow = [&](const auto& what) {
    using What = std::decay_t<decltype(what)>;
    if constexpr (std::is_same_v<What, Renumbering>) {
      kept.renumber(what, samples.delaunay());
    } else {
      kept.update(samples.delaunay(), what);
    }
  };
  for (std::size_t step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    if (step > 0) samples.change(reach, others, random, follow);
    samples.lend([&](const Triangulation& triangulation) {
      const FacetSet left = candidates_left(samples.candidates());
      LinkedFacets actual = kept.link(triangulation, left);
      const LinkedFacets expected = link_facets(triangulation, left);
      ASSERT_EQ(actual.set, left);
      ASSERT_EQ(actual.size(), expected.size());
      ASSERT_TRUE(by_facet(actual) == by_facet(expected));
      ASSERT_EQ(steep_by_facets(actual), steep_by_facets(expected));
      // As after an extraction.
      std::vector<std::uint8_t> off_surface(actual.size());
      for (std::uint8_t& off : off_surface) off = random.below(20) == 0 ? 1 : 0;
      RemovedFacets rest;
      LinkedFacets surface = without(triangulation, std::move(actual), off_surface, &rest);
      kept.keep(std::move(surface), std::move(rest));
    });
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(KeptLinks, OnRandomSamples) {
  run_steps(shapes::sphere(1500, 3), shapes::sphere(1500, 4), 0.3, 25);
}

TEST(KeptLinks, OnNoise) {
  run_steps(shapes::noisy_sphere(1500, 0.02, 3), shapes::noisy_sphere(1500, 0.02, 4), 0.3, 25);
}

// Now fewer, now more than before: triangles move, and vertices, too.
TEST(KeptLinks, WhereTheNumberOfSamplesChanges) {
  run_steps(shapes::sphere(1500, 3), shapes::sphere(500, 4), 0.4, 15);
  run_steps(shapes::sphere(700, 3), shapes::sphere(2500, 4), 0.4, 15);
}

TEST(KeptLinks, OnABox) { run_steps(gallery::box_faces(8), gallery::box_faces(9), 0.4, 20); }

}  // namespace
}  // namespace cocoon
