// Real shapes, changed at random places and scanned anew there: ideal, with noise, out of register.
#include <algorithm>
#include <gtest/gtest.h>
#include <ostream>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/mesh_measure.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "tests/end_to_end/random_change.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

using testing::RandomChange;

enum class Scan { ideal, noisy, displaced };

struct RandomChangeCase {
  std::string file;  // of tests/data
  Scan scan;
};
void PrintTo(const RandomChangeCase& change, std::ostream* out) {
  constexpr const char* names[] = {"ideal", "noisy", "displaced"};
  *out << change.file << ", " << names[static_cast<std::size_t>(change.scan)];
}

class UpdateRandomChanges : public ::testing::TestWithParam<RandomChangeCase> {
 protected:
  static constexpr int changes = 8;

  static TriangleMesh model() {
    const std::string path = std::string(COCOON_TEST_DATA) + "/" + GetParam().file;
    const ReconstructResult result = reconstruct_tight(read_points(path).points);
    EXPECT_EQ(result.status, SurfaceStatus::ok);
    return result.mesh;
  }

  // A tenth of the spacing of noise, or half a spacing out of register.
  static void disturb(std::vector<Point>& scan, double spacing, Random& random) {
    const Vec3 step = 0.5 * spacing * random.on_unit_sphere();
    for (Point& p : scan) {
      if (GetParam().scan == Scan::noisy) p = p + 0.1 * spacing * random.on_unit_sphere();
      if (GetParam().scan == Scan::displaced) p = p + step;
    }
  }

  // Old vertices half a spacing and more from the new surface should go, those that were not
  // scanned should stay.
  struct Tally {
    std::size_t replaced = 0;
    std::size_t wrong = 0;
    std::size_t wrong_left = 0;
    std::size_t right_lost = 0;
  };
  static void count_vertices(const TriangleMesh& model, const RandomChange& change, double spacing,
                             const UpdateResult& result, Tally& tally) {
    IdVector<VertexId, std::uint8_t> in_place(model.points.size(), 0);
    for (const TriangleId t : change.place) {
      for (const VertexId v : model.triangles[t]) in_place[v] = 1;
    }
    for (const VertexId v : model.points.ids()) {
      const bool gone = result.vertex_map[v].is_none();
      const Point& p = model.points[v];
      const bool wrong = in_place[v] != 0 && std::abs(change.offset(p)) >= 0.5 * spacing;
      const bool scanned = in_place[v] != 0 && distance(p, change.center) < 1.45 * change.radius;
      tally.replaced += gone ? 1U : 0U;
      tally.wrong += wrong ? 1U : 0U;
      tally.wrong_left += wrong && !gone ? 1U : 0U;
      tally.right_lost += !scanned && gone ? 1U : 0U;
    }
  }
};

TEST_P(UpdateRandomChanges, KeepTheTopologyAndReplaceWhatIsWrong) {
  const TriangleMesh initial = model();
  const TriangleNeighbors neighbors = triangle_neighbors(initial);
  const double spacing = mesh_measure(initial).edge_lengths.median;
  const std::int64_t euler = mesh_check(initial).euler;
  Random random(1);
  Tally tally;
  for (int done = 0; done < changes;) {
    const auto change = testing::random_change(initial, neighbors, spacing, random);
    if (!change.has_value()) continue;
    SCOPED_TRACE("change " + std::to_string(++done));
    std::vector<Point> scan = testing::scan_of(initial, *change, spacing, random);
    disturb(scan, spacing, random);
    const UpdateResult result = update_model(initial, testing::Clouds{scan});
    ASSERT_EQ(result.status, UpdateStatus::ok) << result.message;
    const MeshReport check = mesh_check(result.mesh);
    EXPECT_TRUE(check.is_closed_manifold());
    EXPECT_EQ(check.euler, euler);
    count_vertices(initial, *change, spacing, result, tally);
  }
  EXPECT_GT(tally.wrong, 40U * changes);
  EXPECT_LE(static_cast<double>(tally.wrong_left), 0.01 * static_cast<double>(tally.wrong));
  EXPECT_LE(static_cast<double>(tally.right_lost), 0.01 * static_cast<double>(tally.replaced));
}

INSTANTIATE_TEST_SUITE_P(Shapes, UpdateRandomChanges,
                         ::testing::Values(RandomChangeCase{"points/kitten.xyz", Scan::ideal},
                                           RandomChangeCase{"points/kitten.xyz", Scan::noisy},
                                           RandomChangeCase{"points/kitten.xyz", Scan::displaced},
                                           RandomChangeCase{"models/anchor_dense.off",
                                                            Scan::ideal}));

}  // namespace
}  // namespace cocoon
