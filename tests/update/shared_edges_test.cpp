#include "update/shared_edges.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// Square surfaces of 10 x 10 unit cells whose clouds are their points.
struct Squares {
  std::vector<CloudRim> rims;
  std::vector<std::vector<Point>> clouds;

  std::vector<std::size_t> mark(std::size_t c) {
    std::vector<Scan> scans;
    for (std::size_t i = 0; i < rims.size(); ++i) {
      scans.push_back({clouds[i], rims[i].median_edge});
    }
    return mark_shared_edges(c, scans, rims[c]);
  }

  void add(const Vec3& at) {
    TriangleMesh mesh = testing::grid_plane(10);
    for (Point& p : mesh.points) p = p + at;
    rims.push_back(cloud_rim(mesh));
    const Points points = mesh.points.span();
    clouds.emplace_back(points.begin(), points.end());
  }
};

TEST(SharedEdges, AreThoseThatAnotherCloudGoesOnBeyond) {
  Squares squares;
  squares.add({0, 0, 0});
  squares.add({6.4, 0.3, 0.2});
  squares.add({40, 0, 0});
  EXPECT_EQ(squares.mark(0), (std::vector<std::size_t>{1}));
  EXPECT_EQ(squares.mark(1), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(squares.mark(2).empty());
  const RimLoop& loop = squares.rims[0].loops.at(0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point& a = loop.points[i];
    const Point& b = loop.points[loop.next(i)];
    const double x = 0.5 * (a.x + b.x);
    if (a.x == 10 && b.x == 10) {
      EXPECT_TRUE(loop.is_inner(i)) << a.y;  // in the midst of the other square
    }
    if (x < 5 || (a.y == 0 && b.y == 0)) {
      EXPECT_FALSE(loop.is_inner(i)) << x << " " << a.y;  // the other one ends beside it, or before
    }
  }
  EXPECT_GE(squares.rims[0].shared_edges, 10U);
  EXPECT_TRUE(squares.rims[0].is_partial());
  EXPECT_FALSE(squares.rims[2].is_partial());
}

// What lies in another cloud altogether has no end of its own.
TEST(SharedEdges, AreAllOfARimInTheMidstOfAnotherCloud) {
  Squares squares;
  squares.add({0, 0, 0});
  std::vector<Point> wide;
  for (double x = -5; x <= 15; ++x) {
    for (double y = -5; y <= 15; ++y) wide.push_back({x + 0.3, y + 0.4, 0});
  }
  squares.rims.push_back({});
  squares.rims[1].spacing = squares.rims[1].median_edge = 1;
  squares.clouds.push_back(wide);
  EXPECT_EQ(squares.mark(0), (std::vector<std::size_t>{1}));
  EXPECT_EQ(squares.rims[0].shared_edges, 40U);
}

TEST(SharedEdges, SeamsAreNotCountedAgain) {
  Squares squares;
  squares.add({0, 0, 0});
  squares.add({6.4, 0.3, 0.2});
  squares.rims[0].loops[0].inner.assign(40, 1);
  EXPECT_EQ(squares.mark(0), (std::vector<std::size_t>{1}));
  EXPECT_EQ(squares.rims[0].shared_edges, 0U);
}

TEST(SharedEdges, CloudsHangTogetherByOthers) {
  const std::vector<std::vector<std::size_t>> others = {{}, {4}, {}, {4}, {}};
  EXPECT_EQ(lowest_sharing_clouds(others), (std::vector<std::size_t>{0, 1, 2, 1, 1}));
}

// The place beyond an edge lies a step of the coarser cloud away.
TEST(SharedEdges, AreLookedForInTheCoarserSpacing) {
  Squares squares;
  squares.add({0, 0, 0});
  squares.rims.push_back(squares.rims[0]);
  squares.rims[1].median_edge = 4;
  squares.clouds.push_back({{14, 5, 0}});
  EXPECT_EQ(squares.mark(0), (std::vector<std::size_t>{1}));
  squares.rims[1].median_edge = 1;
  EXPECT_TRUE(squares.mark(0).empty());
}

}  // namespace
}  // namespace cocoon
