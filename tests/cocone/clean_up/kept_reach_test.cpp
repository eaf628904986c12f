#include "cocone/clean_up/kept_reach.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "delaunay/delaunay.h"
#include "geom/arrays/sort_ids.h"
#include "geom/random/random.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

using Labels = IdVector<CellId, std::uint8_t>;

// The OUT cells that infinity reaches through OUT cells.
Labels reached(const Triangulation& t, const Labels& out) {
  Labels seen(t.num_cells(), 0);
  std::vector<CellId> open;
  for (const CellId c : t.infinite_cells()) {
    seen[c] = 1;
    open.push_back(c);
  }
  while (!open.empty()) {
    const CellId c = open.back();
    open.pop_back();
    for (int i = 0; i < 4; ++i) {
      const CellId behind = t.neighbor(c, i);
      if (seen[behind] != 0 || out[behind] == 0) continue;
      seen[behind] = 1;
      open.push_back(behind);
    }
  }
  return seen;
}

// A random part of the cells, as far as infinity reaches them.
Labels random_labels(const Triangulation& t, double share, Random& random) {
  Labels out(t.num_cells(), 1);
  for (const CellId c : t.finite_cells()) out[c] = random.uniform() < share ? 1 : 0;
  return reached(t, out);
}

void flip(const std::vector<CellId>& cells, Labels& out) {
  for (const CellId c : cells) out[c] = out[c] != 0 ? 0 : 1;
}

// Up to so many cells that hang together.
std::vector<CellId> random_set(const Triangulation& t, std::size_t size, Random& random) {
  std::vector<CellId> cells{CellId(random.below(t.num_finite_cells()))};
  for (std::size_t next = 0; next < cells.size() && cells.size() < size; ++next) {
    for (int i = 0; i < 4 && cells.size() < size; ++i) {
      const CellId behind = t.neighbor(cells[next], i);
      const bool is_new = std::find(cells.begin(), cells.end(), behind) == cells.end();
      if (is_new && !t.is_infinite(behind)) cells.push_back(behind);
    }
  }
  return cells;
}

// Of a connected set of changes it tells exactly whether something was shut off.
TEST(KeptReach, OneSetOfChanges) {
  const Triangulation t = delaunay(gallery::uniform_cube(400)).triangulation;
  Random random(1);
  std::size_t kept = 0;
  std::size_t shut_off = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Labels out = random_labels(t, 0.3 + 0.4 * random.uniform(), random);
    const std::vector<CellId> changed = random_set(t, 1 + random.below(12), random);
    flip(changed, out);
    const bool expected = reached(t, out) == out;
    EXPECT_EQ(is_reach_kept(t, out, changed, std::numeric_limits<std::size_t>::max()), expected);
    (expected ? kept : shut_off) += 1;
  }
  EXPECT_GT(kept, 200U);
  EXPECT_GT(shut_off, 200U);
}

// Of several sets, and if it looks at few cells, it may miss that all is well, but not that
// something was shut off.
TEST(KeptReach, SeveralSetsOfChanges) {
  const Triangulation t = delaunay(gallery::uniform_cube(1000)).triangulation;
  Random random(2);
  std::size_t kept = 0;
  std::size_t shut_off = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Labels out = random_labels(t, 0.4 + 0.5 * random.uniform(), random);
    std::vector<CellId> changed;
    for (std::size_t sets = 1 + random.below(6); sets > 0; --sets) {
      const std::vector<CellId> more = random_set(t, 1 + random.below(8), random);
      changed.insert(changed.end(), more.begin(), more.end());
    }
    make_set(changed);
    flip(changed, out);
    if (!is_reach_kept(t, out, changed, std::size_t{10} << random.below(10))) {
      ++shut_off;
      continue;
    }
    ++kept;
    EXPECT_TRUE(reached(t, out) == out) << trial;
  }
  EXPECT_GT(kept, 100U);
  EXPECT_GT(shut_off, 100U);
}

}  // namespace
}  // namespace cocoon
