// Views in layers: a surface without the samples that crowd, and by a session, too.
#include "update/steps/make_surface.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/search/thin_points.h"
#include "tests/layered_views.h"
#include "tests/stop_after.h"
#include "tests/update/session_checks.h"
#include "update/report/vertex_origins.h"
#include "update/update_session.h"

namespace cocoon {
namespace {

std::size_t faults(const UpdateResult& result) {
  return result.unexplained_handles + result.loose_parts.count;
}

class LayeredViews : public testing::Test {
 protected:
  // Have handles or parts between the layers.
  std::vector<Clouds> trials() {
    std::vector<Clouds> found;
    for (int trial = 0; trial < 6; ++trial) {
      Clouds clouds = {test::layered_cap(0.35 * test::spacing_of_ball, random_)};
      UpdateOptions all;
      all.crowded.leave_out = false;
      const UpdateResult result = update_model(model_, clouds, all);
      if (faults(result) == 0) continue;
      EXPECT_EQ(result.replacement.left_out, 0U);
      EXPECT_GT(result.crowded.in_layers, 0U);
      found.push_back(std::move(clouds));
    }
    EXPECT_GE(found.size(), 2U);
    return found;
  }

  Random random_ = Random(1);
  std::vector<Point> ball_ = test::noisy_ball(0, random_);
  TriangleMesh model_ = reconstruct_tight(ball_).mesh;
};

TEST_F(LayeredViews, AreMendedWithoutTheSamplesThatCrowd) {
  for (const Clouds& clouds : trials()) {
    const UpdateResult result = update_model(model_, clouds);
    ASSERT_EQ(result.status, UpdateStatus::ok);
    EXPECT_EQ(faults(result), 0U);
    EXPECT_EQ(result.replacement.left_out, result.crowded.in_layers);
    EXPECT_GT(result.replacement.left_out, clouds[0].size() / 4);
    EXPECT_EQ(result.unused_changes.samples, 0U);
    for (const VertexOrigin& origin : vertex_origins(result)) {
      if (origin.input == 0) continue;
      EXPECT_EQ(result.crowded.is_in_layers[0][PointId(origin.index)], 0);
    }
  }
}

// Where that does not mend it all samples come in, as if it had not been tried.
TEST_F(LayeredViews, KeepAllWhereFewerHaveAsManyHandles) {
  std::size_t tried = 0;
  for (const Clouds& clouds : trials()) {
    for (const double distance : {0.05, 0.1, 0.2}) {
      UpdateOptions little;
      little.crowded = {.distance = distance, .min_share = 0, .min_thickness = 0};
      const UpdateResult result = update_model(model_, clouds, little);
      if (result.replacement.left_out > 0 || result.crowded.in_layers == 0) continue;
      little.crowded.leave_out = false;
      const UpdateResult expected = update_model(model_, clouds, little);
      EXPECT_TRUE(result.mesh == expected.mesh);
      expect_equal_reports(result, expected);
      little.crowded.leave_out = true;
      UpdateSession session(ball_, little);
      EXPECT_EQ(session.apply(clouds).result.status, UpdateStatus::ok);
      EXPECT_TRUE(session.model() == expected.mesh);
      ++tried;
    }
  }
  EXPECT_GE(tried, 1U);
}

// A surface of fewer samples that is none, or refuted, leaves no trace.
TEST_F(LayeredViews, KeepAllWhereFewerHaveNoSurface) {
  UpdateOptions all;
  all.crowded.leave_out = false;
  for (const Clouds& clouds : trials()) {
    const UpdateResult expected = update_model(model_, clouds, all);
    for (const SurfaceStatus failure : {SurfaceStatus::no_surface, SurfaceStatus::refuted}) {
      const ModelIndex index(model_);
      std::size_t calls = 0;
      const UpdateParts parts{
          [&](const Execution&) -> const ModelIndex& { return index; },
          [&](const Replacement& replacement, const OldSurface& old, const Execution& execution) {
            ReconstructResult result =
                reconstruct_tight_with_labels(replacement.points, old.labels, {}, execution);
            if (++calls == 2) result.status = failure;
            const std::size_t triangles = result.mesh.triangles.size();
            return UpdatedSurface{std::move(result), triangles, {}};
          }};
      const UpdateResult result = update_model(model_, clouds, parts);
      EXPECT_EQ(calls, 3U);
      EXPECT_TRUE(result.mesh == expected.mesh);
      EXPECT_EQ(result.replacement.left_out, 0U);
      expect_equal_reports(result, expected);
    }
  }
}

// Whenever that is, between the attempts, too.
TEST_F(LayeredViews, CanBeStoppedInASession) {
  const Clouds clouds = trials().front();
  const TriangleMesh expected = update_model(model_, clouds).mesh;
  UpdateSession session(ball_);
  const TriangleMesh before = session.model();
  const auto run = [&](Progress& progress) { session.apply(clouds, {1, &progress}); };
  const auto go_on = [&](int reports) {
    EXPECT_TRUE(session.model() == before);
    if (reports % 60 != 1) return;
    session.apply(clouds);
    EXPECT_TRUE(session.model() == expected) << reports;
    session.undo();
  };
  EXPECT_GT(test::stop_everywhere(run, go_on, 20), 4);
  EXPECT_TRUE(session.model() == expected);
}

TEST_F(LayeredViews, GiveASessionTheSameSurface) {
  UpdateSession session(ball_);
  const TriangleMesh before = session.model();
  for (const Clouds& clouds : trials()) {
    const SessionUpdate update = session.apply(clouds);
    const UpdateResult expected = update_model(before, clouds);
    EXPECT_TRUE(session.model() == expected.mesh);
    EXPECT_EQ(update.result.replacement.left_out, expected.replacement.left_out);
    expect_change(before, session.model(), update.change);
    // The next update goes on from there, as from a mesh.
    const Clouds next = random_scans(session.model(), random_);
    const UpdateResult after = update_model(expected.mesh, next);
    const bool is_applied = session.apply(next).result.status == UpdateStatus::ok;
    EXPECT_EQ(is_applied, after.status == UpdateStatus::ok);
    if (is_applied) {
      EXPECT_TRUE(session.model() == after.mesh);
      session.undo();
    }
    EXPECT_TRUE(session.model() == expected.mesh);
    session.undo();
    EXPECT_TRUE(session.model() == before);
  }
}

// The faces of a plate of this thickness, and the wall of a bore through it, seen by several views.
// Of a model without a bore the radius is 0.
std::vector<Point> plate(double half_width, double spacing, double radius, double thickness) {
  std::vector<Point> points;
  for (double x = -half_width; x < half_width + spacing / 2; x += spacing) {
    for (double y = -half_width; y < half_width + spacing / 2; y += spacing) {
      if (std::hypot(x, y) < radius + spacing / 4) continue;
      points.push_back({x, y, 0});
      points.push_back({x, y, thickness});
    }
  }
  const double around = std::ceil(2 * std::numbers::pi * radius / spacing);
  for (double k = 0; k < around; ++k) {
    const double angle = 2 * std::numbers::pi * k / around;
    for (double z = 0; z < thickness + spacing / 2; z += spacing) {
      points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }
  return points;
}

// A bore that leads through the model is none of the samples' own handles, though its rims are not
// found, and though it would be closed without the samples that crowd.
TEST(LayeredBore, Stays) {
  constexpr double thickness = 3;
  Random random(2);
  std::vector<Point> before = plate(16, 1, 0, thickness);
  for (double x = -16; x < 16.5; ++x) {
    for (double z = 1; z < thickness; ++z) {
      for (const double side : {-16.0, 16.0}) {
        before.push_back({x, side, z});
        if (std::abs(x) < 16) before.push_back({side, x, z});
      }
    }
  }
  std::vector<Point> cloud;
  for (int view = 0; view < 5; ++view) {
    const Vec3 by = 0.15 * random.on_unit_sphere();
    for (const Point& p : plate(6, 0.45, 0.65, thickness)) {
      cloud.push_back(p + by + 0.1 * random.on_unit_sphere());
    }
  }
  const TriangleMesh model = reconstruct_tight(before).mesh;
  const UpdateResult result = update_model(model, {{cloud}});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_EQ(result.euler_before, 2);
  EXPECT_EQ(result.euler, 0);
  std::vector<Point> thinned;
  for (const PointId p : thin_points(cloud, 0.75)) thinned.push_back(cloud[p.index()]);
  EXPECT_EQ(update_model(model, {{thinned}}).euler, 2);
}

}  // namespace
}  // namespace cocoon
