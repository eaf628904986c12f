#include "update/checks/dense_trial.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "geom/errors.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// A square of 21 x 21 samples, 0.1 apart, far above the box.
std::vector<std::vector<Point>> grid_cloud() {
  std::vector<Point> cloud;
  for (int i = 0; i <= 20; ++i) {
    for (int k = 0; k <= 20; ++k) cloud.push_back({0.1 * i, 0.1 * k, 30});
  }
  return {cloud};
}

UpdateResult with_mesh(const TriangleMesh& model, const TriangleMesh& mesh) {
  UpdateResult result;
  result.mesh = mesh;
  for (const VertexId v : model.points.ids()) {
    result.replacement.point_of_vertex.push_back(PointId(v.value));
  }
  return result;
}

TEST(DenseTrial, SamplesAreAsFarApartAsThoseOfTheScanOrAsManyAsThereMayBe) {
  const TriangleMesh box = gallery::box(10, 10, 10);
  // The eighth neighbor in a grid is across the diagonal.
  EXPECT_NEAR(dense_spacing(box, grid_cloud()), 0.5 * 0.1 * std::sqrt(2), 1e-12);
  EXPECT_NEAR(dense_spacing(box, grid_cloud(), {.most_samples = 600}), 1, 1e-12);
  EXPECT_THROW(dense_spacing(box, grid_cloud(), {.most_samples = 0}), InputError);
}

TEST(DenseTrial, LargeIsWhatIsLargerThanTheScan) {
  const TriangleMesh box = gallery::box(10, 10, 10);
  EXPECT_TRUE(has_large_triangles(box, grid_cloud(), 1));
  EXPECT_FALSE(has_large_triangles(gallery::box(0.1, 0.1, 0.1), grid_cloud(), 0));
  // The smaller one, with a hundredth of the area, has no large triangles.
  const TriangleMesh both = gallery::join(
      gallery::box(1, 1, 1), gallery::translated(gallery::box(0.1, 0.1, 0.1), {20, 0, 0}));
  EXPECT_FALSE(has_large_triangles(both, grid_cloud(), 0.995));
  EXPECT_TRUE(has_large_triangles(both, grid_cloud(), 0.985));
}

TEST(DenseTrial, IsWorthItWhereLargeTrianglesLoseSurfaceOrTheUpdateIsRefused) {
  const TriangleMesh box = gallery::box(10, 10, 10);
  UpdateResult result;
  LostSurface lost;
  EXPECT_FALSE(is_worth_dense_trial(box, grid_cloud(), result, lost));
  lost.large_share = 0.02;
  EXPECT_TRUE(is_worth_dense_trial(box, grid_cloud(), result, lost));
  lost.large_share = 0;
  lost.warns = lost.is_coarse = true;
  EXPECT_TRUE(is_worth_dense_trial(box, grid_cloud(), result, lost));
  lost.is_coarse = false;
  EXPECT_FALSE(is_worth_dense_trial(box, grid_cloud(), result, lost));
  result.status = UpdateStatus::non_separating;
  EXPECT_TRUE(is_worth_dense_trial(box, grid_cloud(), result, {}));
  EXPECT_FALSE(is_worth_dense_trial(gallery::box(.1, .1, .1), grid_cloud(), result, {}));
}

// The first has only the lower box of two and something in between; the second, of the same made
// dense, has both.
TEST(DenseTrial, WhatKeepsMoreOfTheModelIsBetter) {
  const TriangleMesh lower = gallery::box(4, 4, 4);
  const TriangleMesh upper = gallery::translated(gallery::box(4, 4, 4), {0, 0, 10});
  const TriangleMesh model = gallery::join(lower, upper);
  const TriangleMesh between = gallery::translated(gallery::box(1, 1, 1), {0, 0, 7});
  const UpdateResult first = with_mesh(model, gallery::join(lower, between));
  const UpdateResult dense = with_mesh(model, model);
  const std::vector<std::vector<Point>> clouds = grid_cloud();
  const std::vector<Scan> scans = {{clouds[0], 0.1}};

  const KeptAreas areas = kept_areas({model, first}, {model, dense}, scans);
  EXPECT_NEAR(areas.all, 2 * 96, 1e-9);
  EXPECT_NEAR(areas.only_dense, 96, 1e-9);
  EXPECT_EQ(areas.only_first, 0);
  EXPECT_EQ(areas.neither, 0);
  EXPECT_NEAR(areas.made_up_by_first, 6, 1e-9);
  EXPECT_EQ(areas.made_up_by_dense, 0);
  EXPECT_TRUE(keeps_more(areas, true));
  EXPECT_FALSE(keeps_more(areas, true, {.max_given_up = -1}));
  EXPECT_FALSE(keeps_more(kept_areas({model, dense}, {model, dense}, scans), true));

  // The other way around the second is the worse one.
  const KeptAreas reverse = kept_areas({model, dense}, {model, first}, scans);
  EXPECT_NEAR(reverse.only_first, 96, 1e-9);
  EXPECT_NEAR(reverse.made_up_by_dense, 6, 1e-9);
  EXPECT_FALSE(keeps_more(reverse, true));
}

TEST(DenseTrial, AfterARefusalTheSecondHasToKeepNearlyAll) {
  const TriangleMesh model = gallery::box(4, 4, 4);
  UpdateResult refused;
  refused.status = UpdateStatus::no_overlap;
  const std::vector<std::vector<Point>> clouds = grid_cloud();
  const std::vector<Scan> scans = {{clouds[0], 0.1}};
  const UpdateResult whole = with_mesh(model, model);
  EXPECT_TRUE(keeps_more(kept_areas({model, refused}, {model, whole}, scans), false));
  const UpdateResult other = with_mesh(model, gallery::box(4, 4, 3));
  const KeptAreas areas = kept_areas({model, refused}, {model, other}, scans);
  EXPECT_GT(areas.neither, 16);
  EXPECT_FALSE(keeps_more(areas, false));
}

TEST(DenseTrial, OptionsSayHowMuchBetterItHasToBe) {
  KeptAreas areas = {.all = 100, .only_dense = 3, .made_up_by_first = 2};
  areas.only_first = 1;
  areas.made_up_by_dense = 1;
  EXPECT_TRUE(keeps_more(areas, true));  // 2 given up for 5
  EXPECT_TRUE(keeps_more(areas, true, {.max_given_up = 0.4}));
  EXPECT_FALSE(keeps_more(areas, true, {.max_given_up = 0.39}));
  areas = {.all = 100, .only_dense = 1.4};  // not worth it
  EXPECT_FALSE(keeps_more(areas, true));
  areas.only_dense = 1.6;
  EXPECT_TRUE(keeps_more(areas, true));
  areas = {.all = 100, .neither = 1, .made_up_by_dense = 0.9};
  EXPECT_TRUE(keeps_more(areas, false));
  areas.made_up_by_dense = 1.1;
  EXPECT_FALSE(keeps_more(areas, false));
}

// What the change of the dense model replaces is no loss.
TEST(DenseTrial, WhatTheChangeReplacesIsNotLost) {
  const TriangleMesh model = gallery::box(4, 4, 4);
  const UpdateResult first = with_mesh(model, model);
  UpdateResult dense = with_mesh(model, gallery::translated(model, {0, 0, 100}));
  for (PointId& p : dense.replacement.point_of_vertex) p = PointId();
  const std::vector<std::vector<Point>> clouds = grid_cloud();
  const std::vector<Scan> scans = {{clouds[0], 0.1}};
  EXPECT_EQ(kept_areas({model, first}, {model, dense}, scans).only_first, 0);
}

}  // namespace
}  // namespace cocoon
