#include "update/stage_options.h"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "geom/errors.h"
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
    [](UpdateOptions& o) { o.cloud.rim.loops.min_component_share = -0.1; },
    [](UpdateOptions& o) { o.pin_holes.max_distance = nan; },
    [](UpdateOptions& o) { o.torn.reach = -1; },
    [](UpdateOptions& o) { o.overlap.min_normal_cosine = 67.5; },
    [](UpdateOptions& o) { o.split.max_reach = nan; },
    [](UpdateOptions& o) { o.shared.reach = -1; },
    [](UpdateOptions& o) { o.cut.max_doubt = nan; },
    [](UpdateOptions& o) { o.angles.min_relative_height = 2; },
    [](UpdateOptions& o) { o.choice.ambiguous_margin = 10; },  // degrees
    [](UpdateOptions& o) { o.islands.min_normal_cosine = 60; },
    [](UpdateOptions& o) { o.replace.thinning_distance = -1; },
    [](UpdateOptions& o) { o.overlooked.reach = nan; },
    [](UpdateOptions& o) { o.overlooked.max_kept_share = nan; },
    [](UpdateOptions& o) { o.unscanned.max_explained_share = 2; },
    [](UpdateOptions& o) { o.unused_changes.min_share = nan; },
    [](UpdateOptions& o) { o.contradicted.min_share = -1; },
    [](UpdateOptions& o) { o.shift.max_shift = nan; },
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
