#include "update/stage_options.h"

#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "tests/mesh_gallery.h"
#include "update/checks/closed_openings.h"
#include "update/checks/contradicted_samples.h"
#include "update/checks/dense_trial.h"
#include "update/checks/lost_surface.h"
#include "update/checks/lost_triangles.h"
#include "update/checks/overlooked_vertices.h"
#include "update/checks/rim_shift.h"
#include "update/checks/unscanned_losses.h"
#include "update/checks/unused_changes.h"
#include "update/cloud/rim_seams.h"
#include "update/cloud/samples_with_flag.h"
#include "update/cloud/trim_long_edges.h"
#include "update/scan_ends.h"
#include "update/stray_samples.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Change = void (*)(UpdateOptions&);

// One wrong number each, of every stage.
const std::vector<Change> wrong = {
    [](UpdateOptions& o) { o.join.reach = -1; },
    [](UpdateOptions& o) { o.join.min_share = 1.5; },
    [](UpdateOptions& o) { o.cloud.start.rho = nan; },
    [](UpdateOptions& o) { o.cloud.coarser.back().alpha_cosine = 30; },
    [](UpdateOptions& o) { o.cloud.layers.spread = nan; },
    [](UpdateOptions& o) { o.cloud.trim.max_edge = nan; },
    [](UpdateOptions& o) { o.cloud.rim.min_outline_share = -1; },
    [](UpdateOptions& o) { o.cloud.rim.loops.min_component_share = -0.1; },
    [](UpdateOptions& o) { o.cloud.seams.max_seam_share = 2; },
    [](UpdateOptions& o) { o.pin_holes.max_distance = nan; },
    [](UpdateOptions& o) { o.overlap.min_normal_cosine = 67.5; },
    [](UpdateOptions& o) { o.shared.reach = -1; },
    [](UpdateOptions& o) { o.cut.max_doubt = nan; },
    [](UpdateOptions& o) { o.cut.box_reach = nan; },
    [](UpdateOptions& o) { o.cut.clearer_rim = -1; },
    [](UpdateOptions& o) { o.cut.min_told = nan; },
    [](UpdateOptions& o) { o.cut.ends.off_model = nan; },
    [](UpdateOptions& o) { o.cut.disproved.apart = -1; },
    [](UpdateOptions& o) { o.cut.disproved.step = 0; },
    [](UpdateOptions& o) { o.cut.moved.reach = nan; },
    [](UpdateOptions& o) { o.cut.moved.unconfirmed_cost = -1; },
    [](UpdateOptions& o) { o.cut.moved.unconfirmed.height = nan; },
    [](UpdateOptions& o) { o.cut.disproved.min_side_cosine = nan; },
    [](UpdateOptions& o) { o.angles.min_relative_height = 2; },
    [](UpdateOptions& o) { o.choice.ambiguous_margin = 10; },  // degrees
    [](UpdateOptions& o) { o.choice.turned_away = 100; },      // degrees
    [](UpdateOptions& o) { o.choice.sure_margin = 40; },       // degrees
    [](UpdateOptions& o) { o.sampled.min_share = 2; },
    [](UpdateOptions& o) { o.walls.reach = -1; },
    [](UpdateOptions& o) { o.walls.min_way_cosine = 2; },
    [](UpdateOptions& o) { o.islands.min_normal_cosine = 60; },
    [](UpdateOptions& o) { o.replace.thinning_distance = -1; },
    [](UpdateOptions& o) { o.sight.step = -1; },
    [](UpdateOptions& o) { o.sight.clearance = -1; },
    [](UpdateOptions& o) { o.overlooked.reach = nan; },
    [](UpdateOptions& o) { o.overlooked.max_kept_share = nan; },
    [](UpdateOptions& o) { o.unscanned.max_explained_share = 2; },
    [](UpdateOptions& o) { o.unused_changes.min_share = nan; },
    [](UpdateOptions& o) { o.contradicted.min_share = -1; },
    [](UpdateOptions& o) { o.openings.reach = nan; },
    [](UpdateOptions& o) { o.shadow.max_unmatched_share = 2; },
    [](UpdateOptions& o) { o.shadow.max_distance = nan; },
    [](UpdateOptions& o) { o.shift.max_shift = nan; },
    [](UpdateOptions& o) { o.shift.fit_distance = nan; },
    [](UpdateOptions& o) { o.outward.min_part_cosine = 2; },
    [](UpdateOptions& o) { o.outward.min_agreement = nan; },
    [](UpdateOptions& o) { o.outward.min_view_cosine = nan; },
    [](UpdateOptions& o) { o.cut.disproved.island_reach = nan; },
    [](UpdateOptions& o) { o.cut.disproved.island_share = 2; },
};

TEST(StageOptions, OneNumberOutOfRangeIsRefusedBeforeAnythingBegins) {
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    UpdateOptions options;
    wrong[i](options);
    EXPECT_THROW(require_options("stage", options), InputError) << i;
    try {
      update_model({}, {}, options);
      ADD_FAILURE() << i;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("update: ")) << error.what();
      EXPECT_EQ(std::string(error.what()).find("no cloud given"), std::string::npos) << i;
    }
    EXPECT_THROW(UpdateSession(TriangleMesh(), options), InputError) << i;
  }
}

// They name regions of an update that has not begun.
TEST(StageOptions, ASessionRefusesOverridesOfItsOwn) {
  UpdateOptions options;
  options.overrides.replaced = {RegionId(1U)};
  EXPECT_THROW(UpdateSession(TriangleMesh(), options), InputError);
}

// What an experimenter calls alone says which stage it was.
void expect_refused(const std::string& stage, const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << stage;
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(stage + ": ")) << error.what();
  }
}

TEST(StageOptions, StagesCalledAloneRefuseThemToo) {
  const TriangleMesh mesh = gallery::tetrahedron();
  const ModelIndex model(mesh);
  CloudRim rim;
  const std::vector<Scan> scans(1);
  expect_refused("cloud_rim", [&] { cloud_rim(mesh, {.loops = {}, .min_outline_share = -1}); });
  expect_refused("mark_rim_seams", [&] { mark_rim_seams({}, rim, {.reach = nan}); });
  expect_refused("trim_long_edges", [&] { trim_long_edges(mesh, {.max_edge = nan}); });
  expect_refused("scan_ends", [&] { scan_ends(model, {}, scans, {.scanned = nan}); });
  expect_refused("reaches_beyond", [&] { reaches_beyond(model, {}, scans, {.scanned = nan}); });
  expect_refused("rim_shift", [&] { rim_shift(model, rim, {}, {.max_residual = nan}); });
  expect_refused("outward_normals",
                 [&] { outward_normals(model, {}, {}, {}, {.min_agreement = nan}); });
  expect_refused("overlooked_vertices",
                 [&] { overlooked_vertices(model, {}, {}, {}, {.reach = nan}); });
  expect_refused("crowded_samples", [&] { crowded_samples(model, {}, {}, {}, {.distance = nan}); });
  expect_refused("unused_changes", [&] { unused_changes(model, {}, {}, {.off_model = nan}); });
  expect_refused("closed_openings", [&] { closed_openings(model, {}, mesh, {}, {.reach = nan}); });
  expect_refused("unscanned_losses",
                 [&] { unscanned_losses(model, {}, scans, {}, false, {.reach = nan}); });
  expect_refused("contradicted_samples", [&] { contradicted_samples({}, {}, {.reach = nan}); });
  for (const DenseTrialOptions& options :
       {DenseTrialOptions{.min_large_share = 2}, DenseTrialOptions{.neighbor = 0},
        DenseTrialOptions{.neighbor_share = nan}, DenseTrialOptions{.max_given_up = -2},
        DenseTrialOptions{.lost = {.astray = {.reach = nan}}}}) {
    expect_refused("dense_spacing", [&] { dense_spacing(mesh, {}, options); });
  }
  expect_refused("lost_surface",
                 [&] { lost_surface(mesh, scans, {}, {}, mesh, {.min_area_share = 2}); });
  expect_refused("astray_triangles",
                 [&] { astray_triangles(mesh, {}, mesh, scans, {.tolerance = nan}); });
}

TEST(StageOptions, PartsOfAnotherUpdateAreRefused) {
  const TriangleMesh mesh = gallery::tetrahedron();
  const ModelIndex model(mesh);
  CloudRim rim;
  rim.loops.resize(1);
  const std::vector<Scan> scans(1);
  Replacement replacement;
  replacement.points.resize(4);
  const std::vector<std::vector<Point>> clouds(1);
  expect_refused("rim_shift", [&] { rim_shift(model, rim, {}); });
  expect_refused("unused_changes", [&] { unused_changes(model, scans, {}); });
  expect_refused("unscanned_losses", [&] { unscanned_losses(model, {}, scans, {}, false); });
  expect_refused("lost_vertices", [&] { lost_vertices(model, replacement, {}, false); });
  expect_refused("samples_with_flag", [&] { samples_with_flag(replacement, {}, {}, {}); });
  expect_refused("samples_with_flag", [&] {
    samples_with_flag(replacement, {}, clouds, IdVector<PointId, std::uint8_t>(4, 0));
  });
}

TEST(StageOptions, DefaultsAndWhatSwitchesAStageOffAreTaken) {
  EXPECT_NO_THROW(require_options("stage", UpdateOptions()));
  EXPECT_NO_THROW(require_options("stage", paper_update_options()));
  EXPECT_NO_THROW(require_options("stage", StrayOptions()));
  UpdateOptions options;
  options.cloud.layers.spread = 0;
  options.overlap.max_distance = infinity;
  options.cut.max_doubt = infinity;
  options.overlooked.max_kept_share = infinity;
  options.cloud.max_seam_share = 1;
  EXPECT_NO_THROW(require_options("stage", options));
}

}  // namespace
}  // namespace cocoon
