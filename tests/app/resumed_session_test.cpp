#include "app/resumed_session.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "app/arguments/update_options.h"
#include "app/files/pending_clouds.h"
#include "geom/errors.h"
#include "io/point_file.h"
#include "tests/stop_after.h"
#include "tests/temporary_folder.h"
#include "tests/test_clouds.h"

namespace cocoon::app {
namespace {

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
      keep(notes, {{side > 0 ? "up" : "down"}, {cloud}, {}});
      EXPECT_EQ(session.apply({{cloud}}).result.status, UpdateStatus::ok);
    }
    keep(notes, {{"no cloud"}, {}, {}, true});
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
  void keep(std::vector<std::string>& notes, const PendingUpdate& update) const {
    FileBatch batch;
    save_pending_clouds(path_, notes, update, batch);
    batch.commit();
    notes.insert(notes.end(), update.notes.begin(), update.notes.end());
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
