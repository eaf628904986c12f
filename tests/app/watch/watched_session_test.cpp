#include "app/watch/watched_session.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments/update_options.h"
#include "geom/errors.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "tests/temporary_folder.h"
#include "tests/test_clouds.h"

namespace cocoon::app {
namespace {

class WatchedSessionTest : public testing::Test {
 protected:
  WatchedSessionTest() {
    arguments_.model = folder_.write("model.xyz", test::whole_sphere(1500)).string();
    arguments_.mesh = folder_.file("mesh.ply");
    cloud_ = read_points(folder_.write("cap.xyz", test::sphere_cap(3000, 0.8, 0.3))).points;
  }

  // As another run of the program has it.
  WatchedSession& restart() { return session_.emplace(arguments_, options_, job_); }
  void apply_and_keep() {
    ASSERT_EQ(session_->session().apply({{cloud_}}).result.status, UpdateStatus::ok);
    session_->keep({{"applied cap"}, {cloud_}, {}});
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  bool is_mesh_that_of_the_session() const {
    return read_mesh(arguments_.mesh).points == session_->model().points;
  }

  TemporaryFolder folder_;
  WatchArguments arguments_;
  std::vector<Point> cloud_;

 private:
  static SharedArguments silent() {
    SharedArguments shared;
    shared.quiet = true;
    return shared;
  }
  const UpdateOptions options_ = update_options({});
  Job job_{"watch", silent()};

 protected:
  std::optional<WatchedSession> session_;
};

TEST_F(WatchedSessionTest, GoesOnWithWhatWasKeptBesideIt) {
  EXPECT_TRUE(restart().begin());
  EXPECT_TRUE(is_mesh_that_of_the_session());
  EXPECT_TRUE(exists("mesh.ply.session"));
  apply_and_keep();
  EXPECT_TRUE(exists("mesh.ply.session.cloud-1"));
  EXPECT_TRUE(is_mesh_that_of_the_session());
  const TriangleMesh model = session_->model();

  EXPECT_FALSE(restart().begin());  // after a kill
  EXPECT_EQ(session_->model().points, model.points);
  EXPECT_EQ(session_->notes().back(), "applied cap");
  session_->finish();
  EXPECT_FALSE(exists("mesh.ply.session.cloud-1"));

  EXPECT_FALSE(restart().begin());
  EXPECT_EQ(session_->model().points, model.points);
  EXPECT_EQ(session_->notes().size(), 2U);
}

TEST_F(WatchedSessionTest, IsWrittenAsAWholeAfterSoManyClouds) {
  arguments_.save_every = 1;
  restart().begin();
  apply_and_keep();
  EXPECT_FALSE(exists("mesh.ply.session.cloud-1"));
  EXPECT_FALSE(restart().begin());
  EXPECT_EQ(session_->notes().back(), "applied cap");
}

// Another mesh takes the place of that of the file together with the first cloud.
TEST_F(WatchedSessionTest, IsBegunAnewOnDiskWithItsFirstCloud) {
  EXPECT_TRUE(restart().begin());
  EXPECT_FALSE(session_->is_mesh_of_file());  // but one of points
  const TriangleMesh model = session_->model();
  std::filesystem::remove(folder_.file("mesh.ply.session"));
  arguments_.model = folder_.write("tetrahedron.ply", test::tetrahedron_ply).string();
  EXPECT_FALSE(restart().begin());
  EXPECT_TRUE(session_->is_mesh_of_file());
  session_->begin_anew(model);
  EXPECT_FALSE(session_->is_mesh_of_file());
  session_->finish();

  EXPECT_FALSE(restart().begin());  // after a kill
  EXPECT_EQ(session_->model().points.size(), 4U);
  EXPECT_TRUE(session_->is_mesh_of_file());
  session_->begin_anew(model);
  apply_and_keep();
  const TriangleMesh updated = session_->model();
  EXPECT_TRUE(is_mesh_that_of_the_session());

  EXPECT_FALSE(restart().begin());
  EXPECT_EQ(session_->model(), updated);
  EXPECT_FALSE(session_->is_mesh_of_file());
}

TEST_F(WatchedSessionTest, IsOfOneModelAndItsParameters) {
  restart().begin();
  arguments_.parameters.alpha_deg = 25;
  EXPECT_THROW(restart().begin(), InputError);
  arguments_.parameters.alpha_deg.reset();
  folder_.write("model.xyz", test::whole_sphere(1600));
  EXPECT_THROW(restart().begin(), InputError);
}

}  // namespace
}  // namespace cocoon::app
