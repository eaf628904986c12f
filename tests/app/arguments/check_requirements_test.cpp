#include "app/arguments/check_requirements.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/triangle_mesh.h"

namespace cocoon::app {
namespace {

// The triangles at the edge from (0, 0, 0) to (0, 0, 1), each with a corner of its own, and whether
// they run along it upward.
Certificate fan(const std::vector<bool>& upward) {
  TriangleMesh mesh;
  mesh.points = IdVector<VertexId, Point>(std::vector<Point>{{0, 0, 0}, {0, 0, 1}});
  double x = 1;
  for (const bool up : upward) {
    const VertexId tip(mesh.points.size());
    mesh.points.push_back({x, 1, 0.5});
    x += 1;
    const VertexId low(0);
    const VertexId high(1);
    mesh.triangles.push_back(up ? Triangle{low, high, tip} : Triangle{high, low, tip});
  }
  Certificate certificate;
  certificate.report = mesh_check(mesh);
  return certificate;
}

std::string failure(const char* word, const Certificate& certificate) {
  const std::vector<std::string> failures = failed_requirements({word}, certificate);
  return failures.empty() ? "" : failures[0];
}

TEST(CheckRequirements, ClosedCountsWhatLeavesAMeshOpen) {
  EXPECT_EQ(failure("closed", fan({true, false})),
            "not closed (4 open edges, 0 others with an odd number of triangles)");
  EXPECT_EQ(failure("closed", fan({true, false, true})),
            "not closed (6 open edges, 1 others with an odd number of triangles)");
  EXPECT_EQ(failure("watertight", fan({true, false, true, false})),
            "not watertight (8 open edges, 0 others with an odd number of triangles)");
}

TEST(CheckRequirements, OrientedDoesNotCountOpenEdges) {
  EXPECT_EQ(failure("oriented", fan({true, false})), "");
  EXPECT_EQ(failure("oriented", fan({true, true})),
            "not oriented (1 edges with two triangles in the same direction)");
  EXPECT_EQ(failure("oriented", fan({true, true, false})),
            "not oriented (edges with more than two triangles are not run through equally often "
            "both ways)");
}

}  // namespace
}  // namespace cocoon::app
