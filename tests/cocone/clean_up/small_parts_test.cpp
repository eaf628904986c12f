#include "cocone/clean_up/small_parts.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/facets/cell_order.h"
#include "tests/cocone/random_labeling.h"

namespace cocoon {
namespace {

// All parts of the body, by labels that spread until nothing changes; ascending, each sorted.
std::vector<std::vector<CellId>> all_parts(const Labeling& labeling) {
  const Triangulation& t = labeling.stages.triangulation;
  IdVector<CellId, CellId> root(t.num_cells(), CellId(0));
  for (const CellId c : t.cells()) root[c] = c;
  for (bool changed = true; changed;) {
    changed = false;
    for (const CellId c : t.cells()) {
      for (int i = 0; i < 4; ++i) {
        const CellId d = t.neighbor(c, i);
        if (labeling.out[c] != 0 || labeling.out[d] != 0 || root[d] >= root[c]) continue;
        root[c] = root[d];
        changed = true;
      }
    }
  }
  std::vector<std::vector<CellId>> parts;
  for (const CellId r : t.cells()) {
    std::vector<CellId> part;
    for (const CellId c : t.cells()) {
      if (labeling.out[c] == 0 && root[c] == r) part.push_back(c);
    }
    if (!part.empty()) parts.push_back(std::move(part));
  }
  std::sort(parts.begin(), parts.end(),
            [&](const auto& a, const auto& b) { return precedes(t, a, b); });
  return parts;
}

std::vector<std::vector<CellId>> sorted(std::vector<std::vector<CellId>> parts) {
  for (std::vector<CellId>& part : parts) std::sort(part.begin(), part.end());
  return parts;
}

TEST(SmallParts, AreAllButTheLargest) {
  for (const double bias : {0.6, 0.75, 0.9}) {
    const Labeling labeling(shapes::random_cube(80, 3), 5, bias);
    const Triangulation& t = labeling.stages.triangulation;
    std::vector<CellId> everywhere;
    for (const CellId c : t.cells()) everywhere.push_back(c);
    std::vector<std::vector<CellId>> expected = all_parts(labeling);
    ASSERT_GT(expected.size(), 3U);
    const std::vector<CellId> largest = expected.back();
    expected.pop_back();
    EXPECT_EQ(sorted(small_parts(t, labeling.out, everywhere, t.num_cells())), expected);
    EXPECT_EQ(sorted(small_parts(t, labeling.out, everywhere, largest.size())), expected);
    const std::size_t most = expected.back().size();
    if (most < largest.size()) {
      EXPECT_EQ(sorted(small_parts(t, labeling.out, everywhere, most)), expected);
    }
    std::erase_if(expected, [&](const auto& part) { return part.size() > 2; });
    EXPECT_EQ(sorted(small_parts(t, labeling.out, everywhere, 2)), expected);
  }
}

TEST(SmallParts, OnlyWhereAsked) {
  const Labeling labeling(shapes::random_cube(80, 3), 5, 0.9);
  const Triangulation& t = labeling.stages.triangulation;
  const std::vector<std::vector<CellId>> parts = all_parts(labeling);
  const std::vector<CellId>& first = parts.front();
  EXPECT_EQ(sorted(small_parts(t, labeling.out, std::vector{first.back()}, 100)),
            (std::vector<std::vector<CellId>>{first}));
  EXPECT_TRUE(small_parts(t, labeling.out, {}, 100).empty());
}

}  // namespace
}  // namespace cocoon
