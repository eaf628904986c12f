#include "update/report/unused_changes.h"

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

TEST(UnusedChanges, AreDoubtfulByCountOrShare) {
  EXPECT_FALSE(UnusedChanges{}.is_doubtful({}));
  EXPECT_TRUE((UnusedChanges{.samples = 50, .of = 100000}).is_doubtful({}));
  EXPECT_FALSE((UnusedChanges{.samples = 9, .of = 450}).is_doubtful({}));
  EXPECT_TRUE((UnusedChanges{.samples = 9, .of = 449}).is_doubtful({}));
}

}  // namespace
}  // namespace cocoon
