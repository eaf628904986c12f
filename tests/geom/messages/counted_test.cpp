#include "geom/messages/counted.h"

#include <gtest/gtest.h>

namespace cocoon {
namespace {

TEST(Counted, OneIsSingularAndNoneIsPlural) {
  EXPECT_EQ(counted(1, "edge"), "1 edge");
  EXPECT_EQ(counted(0, "edge"), "0 edges");
  EXPECT_EQ(counted(12, "vertex", "vertices"), "12 vertices");
  EXPECT_EQ(counted(1, "part is", "parts are"), "1 part is");
}

}  // namespace
}  // namespace cocoon
