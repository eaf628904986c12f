#include "app/coarse_model.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "app/report/lost_surface_report.h"
#include "geom/mesh_measure.h"

namespace cocoon::app {
namespace {

// A box of 12 triangles, 12 x 12 x 1.5.
TriangleMesh plate() {
  TriangleMesh mesh;
  for (const double z : {0.0, 1.5}) {
    for (const auto& [x, y] : {std::pair{-3., -3.}, {9., -3.}, {9., 9.}, {-3., 9.}}) {
      mesh.points.push_back({x, y, z});
    }
  }
  const auto quad = [&](unsigned a, unsigned b, unsigned c, unsigned d) {
    mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
    mesh.triangles.push_back({VertexId(a), VertexId(c), VertexId(d)});
  };
  quad(3, 2, 1, 0);
  quad(4, 5, 6, 7);
  for (unsigned k = 0; k < 4; ++k) quad(k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k);
  return mesh;
}

// A boss on its upper side, of samples about `1.8 / sqrt(count)` apart.
std::vector<Point> boss(int count = 330) {
  std::vector<Point> cloud;
  for (int i = 0; i < count; ++i) {
    const double radius = std::sqrt((i + 0.5) / count);
    const double bump = std::max(0.0, 1 - 2.5 * radius * radius);
    cloud.push_back({radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), 1.5 + bump * bump});
  }
  return cloud;
}

UpdateInput update_of(const TriangleMesh& model, const std::vector<Point>& cloud) {
  UpdateInput input;
  input.model_name = "plate";
  input.model = model;
  input.is_mesh_of_file = true;
  input.cloud_names = {"boss"};
  input.clouds = {cloud};
  return input;
}

SharedArguments silent() {
  SharedArguments shared;
  shared.quiet = true;
  return shared;
}

bool reports(Job& job, const std::string& what) {
  return job.report().text().find(what) != std::string::npos;
}

TEST(CoarseModel, IsMadeDenseWhereItsSurfaceWouldBeLost) {
  Job job("update", silent());
  UpdateInput input = update_of(plate(), boss());
  const UpdateOutcome outcome = updated_dense_enough(job, input, {});
  ASSERT_EQ(outcome.update.result.status, UpdateStatus::ok);
  EXPECT_FALSE(outcome.lost.warns);
  EXPECT_GT(input.model.points.size(), 10'000U);  // what was updated
  EXPECT_EQ(job.warnings().size(), 1U);
  EXPECT_NEAR(mesh_measure(outcome.update.result.mesh).signed_volume, 12 * 12 * 1.5 + 0.42, 0.05);
  EXPECT_TRUE(reports(job, "\"made_dense\": true"));
  EXPECT_TRUE(reports(job, "added_samples"));
}

// As it is, and nothing is told of what was tried but why it was not taken.
TEST(CoarseModel, StaysAsItIsWhereThatKeepsNoMore) {
  Job job("update", silent());
  UpdateInput input = update_of(plate(), boss());
  const UpdateOutcome outcome = updated_dense_enough(job, input, {}, {.max_given_up = -1});
  EXPECT_EQ(input.model, plate());
  EXPECT_EQ(job.warnings().size(), 0U);
  EXPECT_TRUE(reports(job, "\"made_dense\": false"));
  EXPECT_FALSE(reports(job, "added_samples"));
  EXPECT_FALSE(reports(job, "densify"));
  EXPECT_NE(outcome.tried.find("keeps no more"), std::string::npos);
  EXPECT_TRUE(outcome.lost.warns);
  EXPECT_NE(warning_of_lost_surface(outcome.lost, outcome.tried, "plate", input.model)
                .find("keeps no more"),
            std::string::npos);
}

// An open model has a warning when it is made dense: not if that is not taken.
TEST(CoarseModel, WarningsOfATrialThatIsNotTakenAreForgotten) {
  TriangleMesh open = plate();
  open.triangles.raw().erase(open.triangles.raw().begin());  // below
  Job job("update", silent());
  UpdateInput input = update_of(open, boss());
  updated_dense_enough(job, input, {}, {.max_given_up = -1});
  EXPECT_TRUE(reports(job, "\"made_dense\": false"));
  EXPECT_EQ(job.warnings().size(), 0U);
  Job taken("update", silent());
  updated_dense_enough(taken, input, {}, {.max_given_up = 10});
  EXPECT_TRUE(reports(taken, "\"made_dense\": true"));
  EXPECT_GT(taken.warnings().size(), 1U);
}

TEST(CoarseModel, IsSampledLessDenselyWhereThatTakesTooMany) {
  Job job("update", silent());
  UpdateInput input = update_of(plate(), boss());
  updated_dense_enough(job, input, {}, {.most_samples = 1000});
  EXPECT_TRUE(reports(job, "\"made_dense\": true"));
  EXPECT_TRUE(reports(job, "\"spacing\": 0.6"));  // of 360 of area
  EXPECT_LT(input.model.points.size(), 2000U);
}

// For an update that is yet to come.
TEST(CoarseModel, IsMadeDenseBeforeItsUpdate) {
  Job job("watch", silent());
  UpdateInput input = update_of(plate(), boss());
  EXPECT_EQ(make_dense_enough(job, input, {}), "");
  EXPECT_FALSE(input.is_mesh_of_file);
  Job at_once("update", silent());
  UpdateInput other = update_of(plate(), boss());
  updated_dense_enough(at_once, other, {});
  EXPECT_EQ(input.model, other.model);
  EXPECT_EQ(job.warnings(), at_once.warnings());

  input = update_of(plate(), boss());
  EXPECT_NE(make_dense_enough(job, input, {}, {.max_given_up = -1}).find("keeps no more"),
            std::string::npos);
  EXPECT_EQ(input.model, plate());
}

// A box within the box, which the scan is far from.
TEST(CoarseModel, KeepsItsHollow) {
  TriangleMesh model;
  const auto add_box = [&](double low, double high, bool inward) {
    const auto first = static_cast<unsigned>(model.points.size());
    TriangleMesh box = plate();
    for (Point& p : box.points) {
      p = {p.x < 0 ? low : high, p.y < 0 ? low : high, p.z > 0 ? high : low};
      model.points.push_back(p);
    }
    for (Triangle t : box.triangles) {
      for (VertexId& v : t) v = VertexId(v.value + first);
      if (inward) std::swap(t[1], t[2]);
      model.triangles.push_back(t);
    }
  };
  add_box(-3, 3, false);
  add_box(-1.5, 1.2, true);
  std::vector<Point> cloud = boss();
  for (Point& p : cloud) p.z += 1.5;
  Job job("update", silent());
  UpdateInput input = update_of(model, cloud);
  const UpdateOutcome outcome = updated_dense_enough(job, input, {});
  ASSERT_EQ(outcome.update.result.status, UpdateStatus::ok);
  EXPECT_TRUE(reports(job, "\"made_dense\": true"));
  EXPECT_NEAR(mesh_measure(outcome.update.result.mesh).signed_volume,
              6 * 6 * 6 - 2.7 * 2.7 * 2.7 + 0.42, 0.1);
}

// Samples as far apart as its vertices: there is nothing to add.
TEST(CoarseModel, IsOneForItsScansOnly) {
  Job job("update", silent());
  UpdateInput input = update_of(plate(), boss());
  for (Point& p : input.clouds[0]) p = {12 * p.x, 12 * p.y, p.z};
  updated_dense_enough(job, input, {});
  EXPECT_EQ(input.model, plate());
  EXPECT_FALSE(reports(job, "coarse_model"));
}

}  // namespace
}  // namespace cocoon::app
