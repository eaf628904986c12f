#include "app/resumed_session.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "app/arguments/update_options.h"
#include "app/files/pending_clouds.h"
#include "geom/errors.h"
#include "geom/random/random.h"
#include "io/point_file.h"
#include "tests/layered_views.h"
#include "tests/stop_after.h"
#include "tests/temporary_folder.h"
#include "tests/test_clouds.h"

namespace cocoon::app {
namespace {

void keep(const std::string& path, std::vector<std::string>& notes, const PendingUpdate& update) {
  FileBatch batch;
  save_pending_clouds(path, notes, update, batch);
  batch.commit();
  notes.insert(notes.end(), update.notes.begin(), update.notes.end());
}

// A sphere with two bumps to come, which wait beside the file of its session.
class ResumedSessionTest : public testing::Test {
 protected:
  ResumedSessionTest() {
    const std::vector<Point> sphere = points_of(test::whole_sphere(1500));
    const std::vector<Point> cap = points_of(test::sphere_cap(3000, 0.8, 0.3));
    UpdateSession session(sphere, update_options({}));
    save_session(path_, {session.snapshot(), {}, {"model"}});
    std::vector<std::string> notes = {"model"};
    for (const double side : {1.0, -1.0}) {
      std::vector<Point> cloud = cap;
      for (Point& p : cloud) p = side * p;
      keep(path_, notes, {{side > 0 ? "up" : "down"}, {cloud}, {}});
      EXPECT_EQ(session.apply({{cloud}}).result.status, UpdateStatus::ok);
    }
    keep(path_, notes, {{"no cloud"}, {}, {}, true});
    model_ = session.model();
  }

  void resume(ResumedSession& resumed, Progress* progress = nullptr) const {
    resume_session(path_, load_session(path_), {}, {1, progress}, resumed);
  }

  TriangleMesh model_;  // with both bumps

 private:
  std::vector<Point> points_of(const std::string& text) const {
    return read_points(folder_.write("cloud.xyz", text)).points;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("session");
};

TEST_F(ResumedSessionTest, HasAppliedItsPendingClouds) {
  ResumedSession resumed;
  resume(resumed);
  EXPECT_EQ(resumed.notes, (std::vector<std::string>{"model", "up", "down", "no cloud"}));
  EXPECT_EQ(resumed.pending, 3U);
  EXPECT_EQ(resumed.session->model().points, model_.points);
  EXPECT_EQ(resumed.session->model().triangles, model_.triangles);
}

// Not with those of updates to come.
TEST(ResumedSession, AppliesPendingCloudsWithTheirOwnOptions) {
  Random random(1);
  const std::vector<Point> ball = test::noisy_ball(0, random);
  test::layered_cap(0.35 * test::spacing_of_ball, random);
  const std::vector<Point> cap = test::layered_cap(0.35 * test::spacing_of_ball, random);
  std::vector<TriangleMesh> models;
  for (const bool keep_crowded : {false, true}) {
    const TemporaryFolder folder;
    const std::string path = folder.file("session");
    SurfaceArguments arguments;
    arguments.keep_crowded = keep_crowded;
    UpdateSession session(ball, update_options(arguments));
    save_session(path, {session.snapshot(), {}, {"ball"}});
    ASSERT_EQ(session.apply({{cap}}).result.status, UpdateStatus::ok);
    std::vector<std::string> notes = {"ball"};
    keep(path, notes, {{"layers"}, {cap}, {}, false, keep_crowded});
    ResumedSession resumed;
    resume_session(path, load_session(path), {}, {1}, resumed);
    EXPECT_TRUE(resumed.session->model() == session.model());
    EXPECT_TRUE(resumed.session->options().crowded.leave_out);
    models.push_back(session.model());
  }
  EXPECT_FALSE(models[0] == models[1]);
}

// Soon after that is asked for, not when all clouds are applied.
TEST_F(ResumedSessionTest, StopsWhileItAppliesThem) {
  const auto run = [&](Progress& progress) {
    ResumedSession resumed;
    resume(resumed, &progress);
  };
  EXPECT_GT(test::stop_everywhere(
                run, [](int) {}, 20),
            2);
}

}  // namespace
}  // namespace cocoon::app
