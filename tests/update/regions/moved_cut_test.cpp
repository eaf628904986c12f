#include "update/regions/moved_cut.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <span>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "tests/update/plane_to_cut.h"

namespace cocoon {
namespace {

constexpr std::size_t side = testing::PlaneToCut::side;
constexpr double steps = testing::PlaneToCut::steps;

// A plane of unit squares cut at x = 20, between facets that pull at 5 and at 35. It was scanned
// where it is from `from` to `to`, and lies 2 below the samples in front of that.
struct CutPlane : testing::PlaneToCut {
  TriangleSet source = TriangleSet(mesh.triangles.size(), 0);
  std::vector<FacetPull> pulls;
  std::vector<Point> samples;

  CutPlane(double from, double to) {
    for (std::size_t y = 0; y < side; ++y) {
      pulls.push_back({at(5, y), std::int64_t{1} << 30});
      pulls.push_back({at(35, y), -(std::int64_t{1} << 30)});
    }
    for (const TriangleId t : source.ids()) source[t] = model.centroid(t).x < 20 ? 1 : 0;
    for (double x = 0.25; x < to; x += 0.5) {
      for (double y = 0.25; y < side; y += 0.5) samples.push_back({x, y, x < from ? 2.0 : 0.0});
    }
  }
  // Where the cut is: the least and the largest x of its facets.
  std::pair<double, double> place(const MovedCutOptions& options = {}) const {
    const Scan scan{samples, 1};
    const TriangleSet moved =
        moved_cut(model, border, pulls, steps, source, std::span(&scan, 1), options);
    double least = side;
    double largest = 0;
    for (const Halfedge h : halfedges_of_cut(model, border, moved)) {
      const double x = model.centroid(TriangleId(triangle_of_halfedge(h))).x;
      least = std::min(least, x);
      largest = std::max(largest, x);
    }
    return {least, largest};
  }
};

TEST(MovedCut, RunsWhereSamplesLieOnTheModel) {
  const CutPlane plane(22, 25);
  const auto [least, largest] = plane.place();
  EXPECT_GT(least, 21.5);
  EXPECT_LT(largest, 25);
}

// Of cuts that are as long the one with the fewest facets on the source side.
TEST(MovedCut, RunsAnywhereAmongThem) {
  const CutPlane plane(10, 25);
  const auto [least, largest] = plane.place();
  EXPECT_NEAR(least, 14.5, 0.5);
  EXPECT_NEAR(largest, 14.5, 0.5);
}

// Where nothing was scanned nothing speaks against it.
TEST(MovedCut, MayRunInAShadow) {
  CutPlane plane(22, 25);
  std::erase_if(plane.samples, [](const Point& p) { return p.x > 13 && p.x < 22; });
  const auto [least, largest] = plane.place();
  EXPECT_GT(least, 14);
  EXPECT_LT(largest, 19);
  EXPECT_GT(plane.place({.reach = 0}).first, 19);
}

TEST(MovedCut, DoesNotReachFarther) {
  const CutPlane plane(28, 32);
  EXPECT_LT(plane.place().second, 26);
  const CutPlane near(22, 25);
  EXPECT_LT(near.place({.reach = 0}).second, 20);
  EXPECT_LT(near.place({.unconfirmed_cost = 1}).second, 20.5);
  EXPECT_GT(near.place({.reach = 3}).first, 21.5);
}

TEST(MovedCut, WithoutACutOrSamplesNothingMoves) {
  CutPlane plane(22, 25);
  EXPECT_EQ(moved_cut(plane.model, plane.border, plane.pulls, steps, plane.source, {}),
            plane.source);
  const TriangleSet none(plane.border.size(), 0);
  const Scan scan{plane.samples, 1};
  EXPECT_EQ(moved_cut(plane.model, plane.border, plane.pulls, steps, none, std::span(&scan, 1)),
            none);
  EXPECT_THROW(moved_cut(plane.model, plane.border, plane.pulls, steps, {}, {}), InputError);
  EXPECT_THROW(plane.place({.reach = -1}), InputError);
  EXPECT_THROW(plane.place({.unconfirmed = {.near = -1}}), InputError);
}

}  // namespace
}  // namespace cocoon
