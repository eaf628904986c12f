#include "geom/search/triangle_tree.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <limits>

#include "geom/box.h"
#include "geom/errors.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

TEST(TriangleTree, HasTheCornersOfEachTriangleAtItsSlot) {
  const TriangleMesh mesh = gallery::box(10, 10, 10);
  const TriangleTree tree = triangle_tree(mesh, {.threads = 2});
  ASSERT_EQ(tree.corners.size(), mesh.triangles.size());
  for (std::size_t slot = 0; slot < tree.corners.size(); ++slot) {
    EXPECT_EQ(tree.corners[slot], corners_of(mesh, TriangleId(tree.boxes.items()[slot])));
  }
  EXPECT_EQ(tree.boxes.box(), box_of(mesh.points.span()));
}

TEST(TriangleTree, RefusesWhatHasNoPlace) {
  TriangleMesh mesh = gallery::box(1, 1, 1);
  mesh.points[VertexId(3U)].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW(triangle_tree(mesh), InputError);
  EXPECT_TRUE(triangle_tree({}).corners.empty());
}

}  // namespace
}  // namespace cocoon
