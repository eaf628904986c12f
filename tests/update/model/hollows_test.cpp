#include "update/model/hollows.h"

#include <gtest/gtest.h>

#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

bool is_hollow(const TriangleMesh& mesh) { return has_hollow(ModelIndex(mesh)); }

TEST(Hollows, ArePartsThatFaceInward) {
  const TriangleMesh outer = gallery::cube(3);
  const TriangleMesh inner = gallery::translated(gallery::cube(), {1, 1, 1});
  EXPECT_TRUE(is_hollow(gallery::join(outer, gallery::flipped(inner))));
  EXPECT_TRUE(is_hollow(gallery::join(gallery::flipped(inner), outer)));
  EXPECT_FALSE(is_hollow(gallery::join(outer, inner)));
  EXPECT_FALSE(is_hollow(outer));
}

// A part without volume is no hollow.
TEST(Hollows, AreNotSheets) {
  EXPECT_FALSE(is_hollow(gallery::join(gallery::cube(3), gallery::open_patch(2, 2))));
}

}  // namespace
}  // namespace cocoon
