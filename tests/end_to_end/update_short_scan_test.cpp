// Scans that end before they meet the model: the foot of a boss was not scanned. The model turns
// away from such a rim on both sides, and the smaller angle may be that of the whole model.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "tests/end_to_end/boxy_part.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::BoxyPart;

constexpr double least = 0.5;  // between samples
constexpr double radius = 4;

double distance_from_axis(const Point& p) { return std::hypot(p.x - 12, p.y - 10); }

class UpdateShortScan : public ::testing::Test {
 protected:
  UpdateShortScan() {
    const TriangleMesh slab =
        testing::surface_of(BoxyPart{{24, 20, 8}, [](int, int, int) { return true; }});
    model = reconstruct_tight(testing::scan_of_mesh(slab, least, random, [](TriangleId) {
              return true;
            })).mesh;
  }
  // A round boss on the slab, six high, from so far above its foot.
  std::vector<Point> boss_above(double foot) {
    std::vector<Point> scan;
    const auto at = [](double r, double turn, double z) {
      return Point{12 + r * std::cos(turn), 10 + r * std::sin(turn), z};
    };
    for (double r = radius - least; r > 0; r -= least) {
      const double step = least / r;
      for (double turn = random.uniform(); turn < 2 * std::numbers::pi; turn += step) {
        scan.push_back(at(r + random.uniform(-0.05, 0.05), turn, 14));
      }
    }
    for (double z = 14; z > 8 + foot; z -= least) {
      const double begin = random.uniform();
      for (double turn = 0; turn < 2 * std::numbers::pi; turn += least / radius) {
        scan.push_back(at(radius, begin + turn, std::min(14.0, z + random.uniform(-0.05, 0.05))));
      }
    }
    return scan;
  }

  Random random{3};
  TriangleMesh model;
};

TEST_F(UpdateShortScan, ABossWithoutItsFootReplacesItsPlaceAlone) {
  for (const double foot : {0.2, 0.5, 1.0}) {
    const UpdateResult result = update_model(model, {{boss_above(foot)}});
    ASSERT_EQ(result.status, UpdateStatus::ok) << foot << result.message;
    const MeshReport report = mesh_check(result.mesh);
    EXPECT_TRUE(report.is_closed_manifold()) << foot;
    EXPECT_EQ(report.euler, 2) << foot;
    for (const VertexId v : model.points.ids()) {
      const Point& p = model.points[v];
      const double r = distance_from_axis(p);
      if (p.z == 8 && r < radius - 1) {
        EXPECT_TRUE(result.vertex_map[v].is_none()) << foot << ' ' << r;
      } else if (p.z < 8 || r > radius + 1.5) {
        EXPECT_FALSE(result.vertex_map[v].is_none()) << foot << ' ' << r;
      }
    }
  }
}

TEST_F(UpdateShortScan, IsToldByItsSamplesWithAWarning) {
  const UpdateResult result = update_model(model, {{boss_above(0.5)}});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_TRUE(result.clouds[0].is_told_by_samples);
  EXPECT_TRUE(std::any_of(result.warnings.begin(), result.warnings.end(), [](const auto& line) {
    return line.find("turns away from it on both sides of its rim (group 0: ") != line.npos;
  }));
}

// Along sharp edges its surface is torn. So its rim is partial, but no piece of it tells its sides
// apart.
TEST_F(UpdateShortScan, ABossWithSharpEdgesIsToldByItsSamplesToo) {
  const TriangleMesh part =
      testing::surface_of(BoxyPart{{24, 20, 14}, [](int x, int y, int z) {
                                     return z < 8 || (x >= 7 && x < 17 && y >= 5 && y < 15);
                                   }});
  std::size_t partial = 0;
  for (const double foot : {0.7, 0.8, 0.9}) {
    std::vector<Point> scan =
        testing::scan_of_mesh(part, 1.2 * least, random, [](TriangleId) { return true; });
    std::erase_if(scan, [&](const Point& p) { return p.z < 8 + foot; });
    const UpdateResult result = update_model(model, {{scan}});
    partial += result.clouds[0].surface.rim.is_partial() ? 1U : 0U;
    EXPECT_EQ(result.clouds[0].is_told_by_samples, result.clouds[0].cut.is_empty()) << foot;
    const MeshReport report = mesh_check(result.mesh);
    EXPECT_TRUE(report.is_closed_manifold()) << foot;
    EXPECT_EQ(report.euler, 2) << foot;
    EXPECT_EQ(report.components, 1U) << foot;
    for (const VertexId v : model.points.ids()) {
      const Point& p = model.points[v];
      const double outside = std::max(std::abs(p.x - 12), std::abs(p.y - 10)) - 5;
      if (p.z == 8 && outside < -1) {
        EXPECT_TRUE(result.vertex_map[v].is_none()) << foot << ' ' << outside;
      } else if (p.z < 8 || outside > 1.5) {
        EXPECT_FALSE(result.vertex_map[v].is_none()) << foot << ' ' << outside;
      }
    }
  }
  EXPECT_GT(partial, 0U);
}

// Then they are not asked, and there is nothing to warn of.
TEST_F(UpdateShortScan, IsNotToldByItsSamplesIfAPersonTells) {
  UpdateOptions options;
  options.overrides.kept = {RegionId(1U)};
  const UpdateResult result = update_model(model, {{boss_above(0.5)}}, options);
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_TRUE(result.replaced_groups.empty());
  EXPECT_FALSE(result.clouds[0].is_told_by_samples);
  for (const std::string& warning : result.warnings) {
    EXPECT_EQ(warning.find("turns away"), std::string::npos) << warning;
  }
}

TEST_F(UpdateShortScan, IsRefusedIfSamplesDoNotTell) {
  UpdateOptions options;
  options.sampled.min_share = 1;
  options.sampled.reach = 0;
  const UpdateResult result = update_model(model, {{boss_above(0.5)}}, options);
  EXPECT_EQ(result.status, UpdateStatus::ambiguous);
  EXPECT_NE(result.message.find("turns away from it on both sides of its rim (group 0: "),
            std::string::npos)
      << result.message;
  EXPECT_NE(result.message.find("or say which group goes"), std::string::npos);
}

// A pocket is filled, and the scan ends at its mouth. Its samples are near neither the walls nor
// the floor, but the model goes straight on from it on one side alone.
TEST_F(UpdateShortScan, AFilledPocketIsToldByAngles) {
  const TriangleMesh part =
      testing::surface_of(BoxyPart{{24, 20, 8}, [](int x, int y, int z) {
                                     return z < 2 || x < 7 || x >= 17 || y < 5 || y >= 15;
                                   }});
  const TriangleMesh pocket =
      reconstruct_tight(testing::scan_of_mesh(part, least, random, [](TriangleId) {
        return true;
      })).mesh;
  std::vector<Point> lid;
  for (const Point& p : model.points) {
    if (p.z == 8 && std::abs(p.x - 12) < 4.9 && std::abs(p.y - 10) < 4.9) lid.push_back(p);
  }
  const UpdateResult result = update_model(pocket, {{lid}});
  ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
  EXPECT_TRUE(result.clouds[0].is_told_by_sure_angles);
  EXPECT_FALSE(result.clouds[0].is_told_by_samples);
  EXPECT_TRUE(std::any_of(result.warnings.begin(), result.warnings.end(), [](const auto& line) {
    return line.find("so the smaller angle does") != line.npos;
  }));
  EXPECT_TRUE(mesh_check(result.mesh).is_closed_manifold());
  EXPECT_EQ(mesh_check(result.mesh).euler, 2);
  // Where the rim cuts across corners of the mouth, the walls over its chords stay.
  std::size_t walls = 0;
  std::size_t left = 0;
  for (const VertexId v : pocket.points.ids()) {
    const Point& p = pocket.points[v];
    const double outside = std::max(std::abs(p.x - 12), std::abs(p.y - 10)) - 5;
    if (outside < 0 && p.z == 2) {
      EXPECT_TRUE(result.vertex_map[v].is_none()) << outside;
    } else if (outside > 1 || p.z < 2) {
      EXPECT_FALSE(result.vertex_map[v].is_none()) << outside << ' ' << p.z;
    } else if (outside == 0 && p.z < 6) {
      ++walls;
      left += result.vertex_map[v].is_none() ? 0U : 1U;
    }
  }
  EXPECT_LT(50 * left, walls);
  UpdateOptions unsure;
  unsure.choice.sure_margin = std::numbers::pi;
  EXPECT_EQ(update_model(pocket, {{lid}}, unsure).status, UpdateStatus::ambiguous);
}

}  // namespace
}  // namespace cocoon
