#include "geom/arrays/sort_ids.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "geom/ids.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

TEST(SortIds, AsTheStandardSortsThem) {
  Random random(1);
  for (const std::size_t count : {0U, 1U, 299U, 300U, 5000U}) {
    for (const std::size_t below : {1U, 100U, 2048U, 3000000U, 0xFFFFFFFFU}) {
      std::vector<VertexId> ids;
      for (std::size_t i = 0; i < count; ++i) ids.push_back(VertexId(random.below(below)));
      if (count > 1) ids[count / 2] = VertexId();
      std::vector<VertexId> expected = ids;
      std::sort(expected.begin(), expected.end());
      sort_ids(ids);
      EXPECT_EQ(ids, expected) << count << " below " << below;
      expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
      make_set(ids);
      EXPECT_EQ(ids, expected) << count << " below " << below;
    }
  }
}

}  // namespace
}  // namespace cocoon
