#include "cocone/clean_up/label_split.h"

#include <gtest/gtest.h>
#include <set>

#include "delaunay/delaunay.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// The cells next to `cells` on their side must be in one part of it without them.
bool falls_apart(const Triangulation& t, const IdVector<CellId, std::uint8_t>& out,
                 const std::set<CellId>& cells) {
  const std::uint8_t side = out[*cells.begin()];
  std::set<CellId> around;
  for (const CellId c : cells) {
    for (int i = 0; i < 4; ++i) {
      const CellId behind = t.neighbor(c, i);
      if (out[behind] == side && !cells.contains(behind)) around.insert(behind);
    }
  }
  if (around.empty()) return false;
  std::set<CellId> reached{*around.begin()};
  std::vector<CellId> stack{*around.begin()};
  while (!stack.empty()) {
    const CellId c = stack.back();
    stack.pop_back();
    for (int i = 0; i < 4; ++i) {
      const CellId behind = t.neighbor(c, i);
      if (out[behind] != side || cells.contains(behind)) continue;
      if (reached.insert(behind).second) stack.push_back(behind);
    }
  }
  for (const CellId c : around) {
    if (!reached.contains(c)) return true;
  }
  return false;
}

TEST(LabelSplit, SaysWhatAPlainSearchSays) {
  std::size_t apart = 0;
  std::size_t together = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Triangulation t = delaunay(gallery::uniform_cube(150, seed)).triangulation;
    Random random(seed);
    IdVector<CellId, std::uint8_t> out(t.num_cells(), 1);
    for (const CellId c : t.finite_cells()) out[c] = random.uniform() < 0.4 ? 1 : 0;
    LabelSplit label_split(t, out);
    for (int round = 0; round < 500; ++round) {
      CellId c(
          static_cast<std::size_t>(random.uniform() * static_cast<double>(t.num_finite_cells())));
      std::set<CellId> cells{c};
      for (int step = 0; step < round % 5; ++step) {
        const CellId next = t.neighbor(c, static_cast<int>(random.uniform() * 4));
        if (t.is_infinite(next) || out[next] != out[c]) continue;
        c = next;
        cells.insert(c);
      }
      const std::vector<CellId> list(cells.begin(), cells.end());
      const bool expected = falls_apart(t, out, cells);
      EXPECT_EQ(label_split.splits(list), expected);
      (expected ? apart : together) += 1;
    }
  }
  EXPECT_GT(apart, 50U);
  EXPECT_GT(together, 50U);
}

}  // namespace
}  // namespace cocoon
