#include "geom/messages/without_control_bytes.h"

#include <gtest/gtest.h>

namespace cocoon {
namespace {

TEST(WithoutControlBytes, KeepsAllOthers) {
  EXPECT_EQ(without_control_bytes("a\033[31m\n\x7F b\xC3\xA4"), "a?[31m?? b\xC3\xA4");
  EXPECT_EQ(without_control_bytes(""), "");
}

}  // namespace
}  // namespace cocoon
