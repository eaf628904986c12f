#include "update/report/update_messages.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace cocoon {
namespace {

bool says(const std::vector<std::string>& warnings, const std::string& words) {
  for (const std::string& warning : warnings) {
    if (warning.find(words) != std::string::npos) return true;
  }
  return false;
}

// Right updates, too, have rims with gaps: that is a note.
TEST(UpdateMessages, CutsAreNotesAndScanEndsWarnings) {
  RegionCut cut;
  EXPECT_TRUE(warnings_of_cut(cut, {}).empty());
  EXPECT_TRUE(notes_of_cut(cut).empty());
  cut.cut_edges = 3;
  EXPECT_TRUE(warnings_of_cut(cut, {}).empty());
  EXPECT_TRUE(says(notes_of_cut(cut), "3 edges"));
  cut.scan_ends = 5;
  EXPECT_TRUE(warnings_of_cut(cut, {}).empty());
  cut.scan_ends = 6;
  EXPECT_TRUE(says(warnings_of_cut(cut, {}), "6 facets)"));
  EXPECT_TRUE(says(warnings_of_cut(cut, {.few_scan_ends = 0}), "6 facets)"));
}

TEST(UpdateMessages, ACutInMuchDoubtIsAWarning) {
  RegionCut cut;
  cut.seeds_under = 20;
  cut.seeds_outside = 50;
  cut.cut_length = 5;
  EXPECT_TRUE(warnings_of_cut(cut, {}).empty());
  cut.contradicted = 3;
  EXPECT_TRUE(says(warnings_of_cut(cut, {}), "(0.4 of what its weaker side says)"));
  EXPECT_TRUE(warnings_of_cut(cut, {.high_doubt = 0.5}).empty());
}

// One edge is missing in a rim of a hundred: it says where its sides are.
TEST(UpdateMessages, ACutThatHardlyCostsAnythingIsNotSaid) {
  RegionCut cut;
  cut.cut_edges = 1;
  cut.seeds_under = cut.seeds_outside = 100;
  cut.cut_length = 4;
  EXPECT_TRUE(notes_of_cut(cut).empty());
  cut.contradicted = 2;
  EXPECT_TRUE(says(notes_of_cut(cut), "1 edge)"));
  EXPECT_TRUE(notes_of_cut(cut, {.clear_doubt = 0.1}).empty());
}

TEST(UpdateMessages, ADoubtfulCutSaysWhatIsMissing) {
  RegionCut cut;
  cut.cut_length = 4.5;
  cut.contradicted = 2;
  cut.seeds_under = 7;
  EXPECT_TRUE(says({reason_of_doubtful_cut(cut)}, "none is left that tells where it ends"));
  cut.seeds_outside = 3;
  EXPECT_TRUE(
      says({reason_of_doubtful_cut(cut)},
           "4.5 median edges of cuts where it is missing, and 2 in contradiction, beside 3;"));
  cut.seeds_under = 0;
  EXPECT_TRUE(says({reason_of_doubtful_cut(cut)}, "none is left that tells where it ends"));
}

TEST(UpdateMessages, LossesHaveAPlace) {
  EXPECT_EQ(warning_of_unscanned({.far = 3, .vertices = 2, .distance = 4.25}, 3, {1, 2.5, -3}),
            "2 vertices of the model are gone though nothing was scanned within 3 spacings of "
            "them; the farthest is 4.25 spacings from all samples, at (1, 2.5, -3); look at the "
            "result, and scan there, too, or let the cloud reach less far");
  EXPECT_TRUE(says({warning_of_unscanned({.vertices = 1, .distance = 5}, 3, {})},
                   "1 vertex of the model is gone though nothing was scanned within 3 spacings of "
                   "it; it is 5 spacings"));
}

TEST(UpdateMessages, OverlookedVerticesAreToldByCountOrByShare) {
  OverlookedVertices found;
  found.vertices.resize(9);
  found.scanned = 50;
  found.kept = 30;
  EXPECT_TRUE(
      says({warning_of_overlooked(found, {1, 2, 3}, {}, 9)},
           "9 vertices of the model lie in the midst of the new samples, as at (1, 2, 3), and go "
           "with what was scanned: a part"));
  EXPECT_TRUE(
      says({warning_of_overlooked(found, {1, 2, 3}, {}, 2)},
           "9 vertices of the model lie in the midst of the new samples, as at (1, 2, 3), of which "
           "2 go: a part"));
  found.vertices.resize(2);
  EXPECT_TRUE(says({warning_of_overlooked(found, {1, 2, 3})},
                   "30 of 50 vertices of the model that were scanned anew stay, as at (1, 2, 3): "
                   "the rim runs through the scan"));
}

TEST(UpdateMessages, PinHolesAndSeamsAreCounted) {
  CloudRim rim;
  rim.pin_holes = 2;
  rim.seam_loops = 1;
  EXPECT_NE(reason_of_closed_cloud(rim).find("(2 pin-holes, 1 seam):"), std::string::npos);
}

// Half a spacing is as good as scans are registered; what is torn at edges is no reason to worry.
TEST(UpdateMessages, ARimOffTheModelIsSaid) {
  CloudReport cloud;
  cloud.surface.rim.spacing = 2;
  cloud.surface.rim.seam_loops = 3;
  cloud.surface.rim.non_orientable = 1;
  cloud.overlap.median_distance = 1.2;
  EXPECT_TRUE(warnings_of_cloud(cloud, {}, {}).empty());
  EXPECT_EQ(notes_of_cloud(cloud).size(), 2U);
  cloud.overlap.median_distance = 2.5;
  EXPECT_TRUE(says(warnings_of_cloud(cloud, {}, {}), "1.25 spacings off the model"));
  EXPECT_TRUE(warnings_of_cloud(cloud, {.step_distance = 1.5}, {}).empty());
  cloud.overlap.median_distance = 0.2;
  cloud.shift = 1.4;
  EXPECT_TRUE(warnings_of_cloud(cloud, {}, {}).empty());
  cloud.shift = 1.8;
  EXPECT_TRUE(says(warnings_of_cloud(cloud, {}, {}), "as if the cloud were moved by 0.9 spacings"));
  cloud.surface.rim.seamed_loops = 1;
  EXPECT_TRUE(says(warnings_of_cloud(cloud, {}, {}), "runs along seams"));
}

TEST(UpdateMessages, ALoopThatIsNoBorderIsSaid) {
  EXPECT_TRUE(says({warning_of_loop(true)}, "lies on other clouds"));
  EXPECT_TRUE(says({warning_of_loop(false)}, "along a seam inside the cloud"));
}

// Whether it matters is told by the gaps that are left.
TEST(UpdateMessages, ALoopOffTheModelIsANote) {
  CloudReport cloud;
  cloud.loops.resize(3);
  cloud.loops[1].match = LoopMatch::on_model;
  cloud.loops[2].pin_hole = true;
  EXPECT_TRUE(says(notes_of_cloud(cloud), "1 loop of its rim is off the model"));
  cloud.loops[2].pin_hole = false;
  EXPECT_TRUE(says(notes_of_cloud(cloud), "2 loops of its rim are off the model"));
}

TEST(UpdateMessages, GapsAreSaid) {
  EXPECT_EQ(warning_of_gaps({.triangles = 2, .longest = 4.5, .at = {1, 2, 3}}, 3),
            "2 triangles of the updated surface span more than 3 spacings where the model has "
            "changed, up to 4.5 at (1, 2, 3): nothing was scanned there, as in a shadow of the "
            "scanner; look at the result, or scan it, too");
}

// Where points are so far off that they have no facet, how many they are tells more.
TEST(UpdateMessages, ARimThatLeavesTheModelIsSaid) {
  CloudReport cloud;
  cloud.surface.rim.spacing = 1;
  cloud.surface.rim.leaves_model = true;
  cloud.overlap.largest_excess = 1.5;
  EXPECT_TRUE(warnings_of_cloud(cloud, {}, {}).empty());
  EXPECT_TRUE(says(notes_of_cloud(cloud),
                   "leaves the model here and there, by up to 1.5 spacings: there the scan ends"));
  cloud.overlap.in_shadow = 9;
  cloud.overlap.in_shadow_of = 40;
  EXPECT_TRUE(says(
      warnings_of_cloud(cloud, {}, {}),
      "leaves the model at 9 of 40 points of its longest loop, by more than 3 spacings: the scan"));
}

TEST(UpdateMessages, JoinedCloudsAreNamedAfterTheFirst) {
  const auto name = [](const std::vector<std::size_t>& members) {
    return name_of_clouds(members, 9);
  };
  EXPECT_EQ(name({2}), "cloud 3 of 9");
  EXPECT_EQ(name({2, 4}), "cloud 3 of 9 (with cloud 5 of 9)");
  EXPECT_EQ(name({2, 4, 6, 7}), "cloud 3 of 9 (with cloud 5 of 9, cloud 7 of 9 and cloud 8 of 9)");
}

TEST(UpdateMessages, AnglesAreInDegrees) {
  const std::vector<RegionVerdict> groups = {{RegionId(0), 90.1 / degrees_per_radian, 30, false},
                                             {RegionId(2), 89.9 / degrees_per_radian, 30, true}};
  EXPECT_TRUE(says({reason_of_ambiguity(1, groups)},
                   "differ by less than 1 degree (group 0: 90.1, group 2: 89.9); let the cloud "
                   "reach"));
  EXPECT_TRUE(
      reason_of_ambiguity(1, {}).ends_with("degree; let the cloud reach farther onto "
                                           "unchanged surface"));
  EXPECT_TRUE(says({reason_of_ambiguity(0.5, groups)}, "differ by less than 0.5 degrees ("));
  CloudReport turned_away;
  turned_away.groups = groups;
  turned_away.is_told_by_samples = true;
  EXPECT_TRUE(
      says({warning_of_turned_away(turned_away)}, "rim (group 0: 90.1, group 2: 89.9), as"));
  EXPECT_TRUE(says({warning_of_turned_away(turned_away)}, "so its samples tell which group goes"));
  turned_away.is_told_by_samples = false;
  EXPECT_TRUE(says({warning_of_turned_away(turned_away)},
                   "not tell which group goes, so the smaller angle does; look"));
  EXPECT_TRUE(says({reason_of_turned_away(groups)}, "surface, or say which group goes"));
  EXPECT_TRUE(reason_of_turned_away({}).ends_with("reach onto unchanged surface"));
  EXPECT_EQ(warning_of_narrow_margin(12.3456),
            "its regions differ by only 12.35 degrees; look at the result");
}

TEST(UpdateMessages, CloudsThatOverlapEachOther) {
  EXPECT_EQ(warning_of_clouds_apart("cloud 1 of 2 is closed"),
            "clouds overlap each other, but do not make one surface (cloud 1 of 2 is closed); each "
            "is taken by itself");
  EXPECT_EQ(warning_of_shared_regions(1), "1 region of the model lies under more than one cloud");
  EXPECT_EQ(warning_of_shared_regions(2), "2 regions of the model lie under more than one cloud");
}

TEST(UpdateMessages, OneTrialAloneIsSaid) {
  CloudSurfaceOptions options;
  EXPECT_EQ(hint_of_only_trial(options), "");
  options.start.rho = 0.001;
  options.finer.clear();
  EXPECT_EQ(hint_of_only_trial(options), "");
  options.coarser.clear();
  EXPECT_EQ(hint_of_only_trial(options),
            "; only rho 0.001 and alpha 30 degrees were tried, and others may do");
}

TEST(UpdateMessages, LimitsThatNoSampleMeetsAreSaid) {
  EXPECT_EQ(hint_of_limits({.rho = 1, .alpha_cosine = 1}),
            "; none of them meets rho 1 and alpha 0 degrees, and larger ones may do");
}

TEST(UpdateMessages, OtherUnitsAreSaid) {
  EXPECT_TRUE(says({reason_of_no_overlap(3, 4, 3, 0.5, 25.4)}, "multiplied by 25.4 it would"));
  EXPECT_TRUE(says({reason_of_no_overlap(3, 4, 3, 0.5, {})}, "register it to the model"));
}

TEST(UpdateMessages, OneHandleAndSeveral) {
  EXPECT_TRUE(says({warning_of_handles(1)}, "has 1 handle more than"));
  EXPECT_TRUE(says({warning_of_handles(1)}, "if the scans have it,"));
  EXPECT_TRUE(says({warning_of_handles(2)}, "if the scans have them,"));
}

TEST(UpdateMessages, SmallPartsAreNotes) {
  CloudReport cloud;
  EXPECT_TRUE(notes_of_cloud(cloud).empty());
  cloud.surface.rim.small_components = 2;
  EXPECT_TRUE(says(notes_of_cloud(cloud), "2 small parts"));
  cloud.surface.is_layered = true;
  cloud.surface.set_aside = 7;
  EXPECT_TRUE(says(notes_of_cloud(cloud), "7 samples were set aside to find its rim"));
}

}  // namespace
}  // namespace cocoon
