#include "update/update_messages.h"

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

TEST(UpdateMessages, CutsAndScanEndsAreSaid) {
  RegionCut cut;
  EXPECT_TRUE(warnings_of_cut(cut).empty());
  cut.cut_edges = 3;
  EXPECT_TRUE(says(warnings_of_cut(cut), "3 edges"));
  cut.scan_ends = 1;
  EXPECT_TRUE(says(warnings_of_cut(cut), "1 facet)"));
}

}  // namespace
}  // namespace cocoon
