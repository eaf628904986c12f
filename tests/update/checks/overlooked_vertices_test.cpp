#include "update/checks/overlooked_vertices.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/errors.h"
#include "geom/mesh_check.h"
#include "io/sample_models.h"
#include "tests/gallery.h"
#include "tests/update/hand_made_models.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

// A plane of 20 x 20 unit squares, scanned anew at its vertices in the square from 5 to 15.
struct ScannedPlane {
  TriangleMesh model = testing::grid_plane(20);
  ModelIndex index{model};
  std::vector<std::vector<Point>> clouds;
  std::vector<CloudRim> rims;
  std::vector<VertexId> removed;

  ScannedPlane() {
    TriangleMesh surface = testing::grid_plane(10);
    for (Point& p : surface.points) p = p + Vec3{5, 5, 0.1};
    rims = {cloud_rim(surface)};
    clouds = {surface.points.raw()};
  }
  // From now on those go for which it is true, and no others.
  template <class Test>
  void remove_where(Test goes) {
    removed.clear();
    for (const VertexId v : model.points.ids()) {
      if (goes(model.points[v])) removed.push_back(v);
    }
  }
  std::size_t count(const OverlookedOptions& options = {}) const {
    return found(options).vertices.size();
  }
  OverlookedVertices found(const OverlookedOptions& options = {}) const {
    return overlooked_vertices(index, removed, rims, nearest_point_trees(clouds), options);
  }
};

TEST(OverlookedVertices, ThoseThatStayAmongSamplesFarFromTheRim) {
  ScannedPlane scene;
  ASSERT_EQ(scene.rims[0].median_edge, 1);
  EXPECT_EQ(scene.count(), 25U);  // from 8 to 12
  const std::vector<VertexId> overlooked = scene.found().vertices;
  EXPECT_EQ(overlooked.size(), 25U);
  EXPECT_TRUE(std::is_sorted(overlooked.begin(), overlooked.end()));
  EXPECT_EQ(scene.model.points[scene.found().farthest], (Point{10, 10, 0}));
  EXPECT_EQ(scene.count({.min_rim_distance = 1.5}), 49U);
  EXPECT_EQ(scene.count({.reach = 0.09}), 0U);
  scene.remove_where([](const Point& p) { return p.x > 9.5; });
  EXPECT_EQ(scene.count(), 10U);
  EXPECT_EQ(scene.model.points[scene.found().farthest], (Point{9, 9, 0}));  // the first of three
  scene.rims[0].loops.clear();
  EXPECT_EQ(scene.count(), 0U);
}

// As many as stay far from the rims may go: what stays beside them tells as well.
TEST(OverlookedVertices, AreDoubtfulIfALargeShareOfWhatWasScannedStays) {
  ScannedPlane scene;
  const auto is_doubtful = [&](const OverlookedOptions& options = {}) {
    const OverlookedVertices found = scene.found(options);
    EXPECT_EQ(found.scanned, 121U);
    EXPECT_FALSE(found.are_many(options));
    EXPECT_EQ(found.is_doubtful(options), found.are_large_share(options));
    return found.is_doubtful(options);
  };
  const auto is_amid = [](const Point& p) { return p.x > 5.5 && p.x < 14.5; };
  scene.remove_where(is_amid);
  EXPECT_EQ(scene.found().kept, 22U);  // on two sides of the rim
  EXPECT_EQ(scene.count(), 0U);
  EXPECT_FALSE(is_doubtful());
  EXPECT_TRUE(is_doubtful({.max_kept_share = 0.18}));
  EXPECT_FALSE(is_doubtful({.max_kept_share = 0.19}));
  scene.remove_where([&](const Point& p) { return is_amid(p) && !(p.y < 6.5 && p.y > 4.5); });
  EXPECT_EQ(scene.found().kept, 40U);  // 18 more: a third
  EXPECT_TRUE(is_doubtful());
  EXPECT_FALSE(is_doubtful({.min_kept = 41}));
  EXPECT_EQ(scene.model.points[scene.found().farthest], (Point{6, 6, 0}));
}

// Of two clouds one without samples.
TEST(OverlookedVertices, AreLookedForAtAllClouds) {
  ScannedPlane scene;
  scene.rims.push_back(scene.rims[0]);
  scene.clouds.push_back({{50, 50, 50}});
  EXPECT_EQ(scene.count(), 25U);
}

TEST(OverlookedVertices, EveryRimNeedsTheSamplesOfItsCloud) {
  ScannedPlane scene;
  scene.clouds.clear();
  EXPECT_THROW(scene.found(), InputError);
}

TEST(OverlookedVertices, AreToldInEdgesOfTheCloud) {
  ScannedPlane scene;
  scene.rims[0].median_edge = 0.5;
  EXPECT_EQ(scene.count(), 49U);  // from 7 to 13
  EXPECT_EQ(scene.count({.reach = 0.19}), 0U);
}

// The test block has sharp edges, at which the surface of its scan is torn.
TEST(OverlookedVertices, AreCountedWhereTheScanIsTornAndWarnedOf) {
  const SampleModel sample = sample_model("block", {.seed = 1});
  const TriangleMesh model = reconstruct_tight(sample.initial).mesh;
  const auto warns = [&](const UpdateOptions& options, bool torn) {
    const UpdateResult result = update_model(model, sample.clouds, options);
    EXPECT_EQ(result.status, UpdateStatus::ok);
    EXPECT_EQ(result.clouds[0].surface.rim.seam_edges > 0, torn);
    bool found = false;
    for (const std::string& warning : result.warnings) {
      found = found || warning.find("in the midst of the new samples") != std::string::npos;
    }
    EXPECT_EQ(found, result.overlooked.are_many(options.overlooked));
    return found;
  };
  UpdateOptions wide;  // so that vertices beside the rim count as well
  wide.overlooked.reach = 3;
  wide.overlooked.min_rim_distance = 0;
  wide.overlooked.go = false;
  EXPECT_FALSE(warns({}, true));
  EXPECT_TRUE(warns(wide, true));
}

// Small groups of samples lie on the model, away from the change, not quite where it is: their
// surfaces are too small to be looked at, and model and samples would be two layers.
TEST(OverlookedVertices, GoWhereGroupsOfSamplesLieOnTheModel) {
  const TriangleMesh model = reconstruct_tight(gallery::even_sphere(3000)).mesh;
  std::vector<Point> cloud;
  for (const Point& p : gallery::even_sphere(3100)) {
    if (p.z > 0.8) cloud.push_back(p.z > 0.9 ? 1.1 * p : p);
  }
  std::size_t groups = 0;
  for (double turn = 0; turn < 6; turn += 0.6) {
    const Point center = {std::cos(turn), std::sin(turn), 0};
    for (const Point& p : gallery::even_sphere(3300)) {
      if (distance(p, center) < 0.1) cloud.push_back(1.01 * p);
    }
    ++groups;
  }
  const auto updated = [&](bool go) {
    UpdateOptions options;
    options.overlooked.go = go;
    return update_model(model, std::vector<std::vector<Point>>{cloud}, options);
  };
  const UpdateResult kept = updated(false);
  const UpdateResult result = updated(true);
  ASSERT_EQ(result.status, UpdateStatus::ok);
  EXPECT_EQ(kept.replacement.vertices.overlooked, 0U);
  EXPECT_GE(result.replacement.vertices.overlooked, groups);
  EXPECT_EQ(result.overlooked.vertices, kept.overlooked.vertices);
  EXPECT_EQ(result.replacement.vertices.replaced,
            kept.replacement.vertices.replaced + result.replacement.vertices.overlooked);
  EXPECT_LT(result.reconstruction.unused_points, kept.reconstruction.unused_points);
  const MeshReport report = mesh_check(result.mesh);
  EXPECT_TRUE(report.is_closed_manifold());
  EXPECT_EQ(report.euler, 2);
}

TEST(OverlookedVertices, RemovedOnesThatAreNotAscendingAreRefused) {
  ScannedPlane scene;
  scene.removed = {VertexId(5), VertexId(4)};
  EXPECT_THROW(scene.count(), InputError);
  scene.removed = {VertexId(scene.model.points.size())};
  EXPECT_THROW(scene.count(), InputError);
}

}  // namespace
}  // namespace cocoon
