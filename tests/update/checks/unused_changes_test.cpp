#include "update/checks/unused_changes.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

// A plane with samples over it, one unit apart: some on it, some two units above.
struct ShelfOverAPlane {
  TriangleMesh plane = testing::grid_plane(20);
  ModelIndex model{plane};
  std::vector<Point> shelf;
  std::vector<Point> samples;

  ShelfOverAPlane() {
    for (int x = 0; x < 12; ++x) {
      for (int y = 0; y < 10; ++y) {
        samples.push_back({x + 4.5, y + 4.5, 0.1});
        if (x >= 4) continue;
        shelf.push_back({x + 8.5, y + 4.5, 2});
        samples.push_back(shelf.back());
      }
    }
  }
  UnusedChanges changes(const std::vector<Point>& unused,
                        const UnusedChangeOptions& options = {}) const {
    const Scan scan{samples, 1};
    return unused_changes(model, {&scan, 1}, {&unused, 1}, options);
  }
};

TEST(UnusedChanges, SamplesOffTheModel) {
  const ShelfOverAPlane scene;
  const UnusedChanges all = scene.changes(scene.shelf);
  EXPECT_EQ(all.samples, 40U);
  EXPECT_EQ(all.of, 40U);
  EXPECT_EQ(all.at, scene.shelf.front());
  EXPECT_TRUE(all.is_doubtful({}));
  EXPECT_EQ(scene.changes(scene.shelf, {.off_model = 2.5}).samples, 0U);
}

// Another layer of what is there, as several scans make it.
TEST(UnusedChanges, NotThoseOnTheModel) {
  const ShelfOverAPlane scene;
  std::vector<Point> layer;
  for (const Point& p : scene.samples) {
    if (p.z < 1) layer.push_back(p);
  }
  EXPECT_EQ(scene.changes(layer).samples, 0U);
  EXPECT_EQ(scene.changes({}).samples, 0U);
}

TEST(UnusedChanges, NotStrayPoints) {
  const ShelfOverAPlane scene;
  std::vector<Point> strays;
  strays.reserve(12);
  for (int k = 0; k < 12; ++k) strays.push_back({k + 4.0, 10, 3.0 * (k % 2) + 2});
  EXPECT_EQ(scene.changes(strays).samples, 0U);
  EXPECT_GT(scene.changes(strays, {.neighbors = 1}).samples, 5U);
}

// Two units are four spacings of a scan twice as dense, whose strays are twice as close.
TEST(UnusedChanges, AreMeasuredInSpacings) {
  const ShelfOverAPlane scene;
  const Scan dense{scene.samples, 0.5};
  const auto samples = [&](const UnusedChangeOptions& options) {
    return unused_changes(scene.model, {&dense, 1}, {&scene.shelf, 1}, options).samples;
  };
  EXPECT_EQ(samples({.off_model = 3.9, .reach = 3}), 40U);
  EXPECT_EQ(samples({.off_model = 4.1, .reach = 3}), 0U);
  EXPECT_EQ(samples({.reach = 1.9}), 0U);
}

TEST(UnusedChanges, HaveAPlaceOfTheFirstScan) {
  const ShelfOverAPlane scene;
  std::vector<Point> reversed(scene.shelf.rbegin(), scene.shelf.rend());
  std::vector<Point> lower = reversed;
  for (Point& p : lower) p.x -= 4;
  const Scan scans[] = {{scene.samples, 1}, {scene.samples, 1}};
  const std::vector<Point> unused[] = {reversed, lower};
  const UnusedChanges found = unused_changes(scene.model, scans, unused);
  EXPECT_EQ(found.samples, 80U);
  EXPECT_EQ(found.of, 80U);
  EXPECT_EQ(found.at, scene.shelf.front());
}

TEST(UnusedChanges, AreDoubtfulByCountOrShare) {
  EXPECT_FALSE(UnusedChanges{}.is_doubtful({}));
  EXPECT_TRUE((UnusedChanges{.samples = 50, .of = 100000}).is_doubtful({}));
  EXPECT_FALSE((UnusedChanges{.samples = 9, .of = 450}).is_doubtful({}));
  EXPECT_TRUE((UnusedChanges{.samples = 9, .of = 449}).is_doubtful({}));
}

}  // namespace
}  // namespace cocoon
