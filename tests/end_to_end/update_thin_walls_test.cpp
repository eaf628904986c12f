// A thin-walled part through the program: an open enclosure with ribs, of which one is cut out and
// a socket is put in beside it. The walls are two and a half spacings thick, all edges are sharp:
// the surface of the new scan is torn along its edges and along its rim, as those of real parts
// are.
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/search/closest_facet.h"
#include "geom/search/nearest_point.h"
#include "geom/surface_distance.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "tests/end_to_end/boxy_part.h"
#include "tests/run_program.h"

namespace cocoon {
namespace {

using test::run_program;
using test::TemporaryFolder;
using testing::BoxyPart;

constexpr std::array<int, 3> size = {26, 18, 9};
constexpr double least = 0.4;  // between samples

bool is_wall(int x, int y, int z) {
  return x == 0 || x == size[0] - 1 || y == 0 || y == size[1] - 1 || z == 0;
}
bool is_rib(int x, int z) { return (x == 8 || x == 17) && z < 5; }
bool is_cut(int x, int y, int z) { return x == 17 && 4 < y && y < 13 && z > 1; }
bool is_socket(int x, int y, int z) {
  return 18 < x && x < 23 && 5 < y && y < 12 && z < 4 && (x == 19 || x == 22 || y == 6 || y == 11);
}

bool lies_on(const ClosestFacetTree& surface, const Point& p) {
  return surface.closest(p).squared_distance < 1e-12;
}

class UpdateThinWalls : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  const TriangleMesh before = testing::surface_of(
      BoxyPart{size, [](int x, int y, int z) { return is_wall(x, y, z) || is_rib(x, z); }});
  const TriangleMesh after = testing::surface_of(BoxyPart{
      size, [](int x, int y, int z) {
        return !is_cut(x, y, z) && (is_wall(x, y, z) || is_rib(x, z) || is_socket(x, y, z));
      }});

  // The samples of `after` within eight times `least` of where the two differ.
  std::vector<Point> scan_of_change(const std::vector<Point>& initial, Random& random) const {
    const std::vector<Point> all =
        testing::scan_of_mesh(after, least, random, [](TriangleId) { return true; });
    const ClosestFacetTree old_surface(before);
    const ClosestFacetTree new_surface(after);
    std::vector<Point> changed;
    for (const Point& p : all) {
      if (!lies_on(old_surface, p)) changed.push_back(p);
    }
    for (const Point& p : initial) {
      if (!lies_on(new_surface, p)) changed.push_back(p);
    }
    const NearestPointTree near(changed);
    std::vector<Point> scan;
    for (const Point& p : all) {
      if (near.nearest(p).squared_distance < 64 * least * least) scan.push_back(p);
    }
    return scan;
  }

  struct Tally {
    std::size_t wrong = 0;  // old vertices that are not on the new part
    std::size_t wrong_left = 0;
    std::size_t lost_far_away = 0;  // right ones, farther than 1.5 spacings from the new scan
  };
  Tally tally(const TriangleMesh& model, const std::vector<Point>& scan,
              const TriangleMesh& updated) const {
    const ClosestFacetTree new_surface(after);
    const NearestPointTree samples(scan);
    std::map<Point, bool> stays;
    for (const Point& p : updated.points) stays[p] = true;
    Tally tally;
    for (const Point& p : model.points) {
      const bool gone = stays.count(p) == 0;
      const bool wrong = !lies_on(new_surface, p);
      const bool far = samples.nearest(p).squared_distance > 2.25 * least * least;
      tally.wrong += wrong ? 1U : 0U;
      tally.wrong_left += wrong && !gone ? 1U : 0U;
      tally.lost_far_away += !wrong && gone && far ? 1U : 0U;
    }
    return tally;
  }
};

void write_cloud(const std::string& path, const std::vector<Point>& points) {
  TriangleMesh cloud;
  for (const Point& p : points) cloud.points.push_back(p);
  write_mesh(path, cloud);
}

TEST_P(UpdateThinWalls, WithTornRims) {
  const TemporaryFolder folder;
  Random random(GetParam());
  const std::vector<Point> initial =
      testing::scan_of_mesh(before, least, random, [](TriangleId) { return true; });
  const std::vector<Point> scan = scan_of_change(initial, random);
  write_cloud(folder.file("initial.ply"), initial);
  write_cloud(folder.file("scan.ply"), scan);
  ASSERT_EQ(run_program({"reconstruct", folder.file("initial.ply"), "-o", folder.file("old.ply")})
                .exit_code,
            0);
  const test::ProgramRun run =
      run_program({"update", folder.file("old.ply"), folder.file("scan.ply"), "-o",
                   folder.file("new.ply"), "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  const nlohmann::json cloud = nlohmann::json::parse(run.out)["update"]["clouds"][0];
  EXPECT_GT(cloud["seam_edges"].get<int>(), 30);  // torn

  const TriangleMesh updated = read_mesh(folder.file("new.ply"));
  const MeshReport check = mesh_check(updated);
  EXPECT_TRUE(check.is_closed_manifold());
  EXPECT_EQ(check.euler, 2);
  const Tally found = tally(read_mesh(folder.file("old.ply")), scan, updated);
  EXPECT_GT(found.wrong, 250U);
  EXPECT_LE(found.wrong_left, 8U);
  EXPECT_LE(found.lost_far_away, 2U);
  EXPECT_LT(surface_distance(updated, after, {.samples = 20000}).rms, 0.1 * least);
}

INSTANTIATE_TEST_SUITE_P(Scans, UpdateThinWalls, ::testing::Values(1, 3, 4));

}  // namespace
}  // namespace cocoon
