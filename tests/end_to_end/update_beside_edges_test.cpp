// A block of which a part was scanned again, unchanged: the scan ends beside sharp edges and
// corners, where its rim is a chain of long chords.
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/mesh_measure.h"
#include "tests/end_to_end/boxy_part.h"
#include "update/update_session.h"

namespace cocoon {
namespace {

struct RescannedBlock {
  Random random;
  TriangleMesh model;
  std::vector<Point> scan;

  explicit RescannedBlock(std::uint64_t seed) : random(seed) {
    const TriangleMesh block =
        testing::surface_of({{28, 24, 16}, [](int, int, int) { return true; }});
    const auto all = [](TriangleId) { return true; };
    model = reconstruct_tight(testing::scan_of_mesh(block, 1, random, all)).mesh;
    const Point center{random.uniform(16, 26), random.uniform(14, 22), random.uniform(10, 15)};
    for (const Point& p : testing::scan_of_mesh(block, 1, random, all)) {
      if (distance(p, center) < 12) scan.push_back(p);
    }
  }
  double lost_volume(const UpdateOptions& options) const {
    const UpdateResult result = update_model(model, {{scan}}, options);
    EXPECT_EQ(result.status, UpdateStatus::ok) << result.message;
    return mesh_measure(model).signed_volume - mesh_measure(result.mesh).signed_volume;
  }
};

TEST(UpdateBesideEdges, EdgesThatWereNotScannedStay) {
  UpdateOptions off;
  off.unchanged.reach = 0;
  double lost = 0, lost_without = 0;
  std::size_t with_rest = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const RescannedBlock block(seed);
    const double volume = block.lost_volume({});
    EXPECT_LT(volume, 12);
    lost += volume;
    lost_without += block.lost_volume(off);
    UpdateSession session(block.model);
    const SessionUpdate update = session.apply({{block.scan}});
    with_rest += update.result.replacement.vertices.unchanged > 0 ? 1U : 0U;
  }
  EXPECT_GT(with_rest, 2U);
  RecordProperty("lost", std::to_string(lost));
  EXPECT_LT(lost, lost_without - 20);
}

}  // namespace
}  // namespace cocoon
