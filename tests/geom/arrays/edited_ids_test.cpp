#include "geom/arrays/edited_ids.h"

#include <gtest/gtest.h>
#include <vector>

#include "geom/ids.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

// A few changes, some of them next to each other, in a list of `size`.
ListEdit<VertexId> random_edit(std::size_t size, std::size_t changes, Random& random) {
  std::vector<int> removed(size, 0);
  for (std::size_t k = 0; k < changes; ++k) {
    const std::size_t first = random.below(size);
    for (std::size_t i = first; i < size && i < first + 1 + random.below(5); ++i) removed[i] = 1;
  }
  ListEdit<VertexId> edit;
  std::size_t after = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (removed[i] != 0) edit.removed.push_back(VertexId(i));
    if (random.below(size) < changes) edit.added.push_back(VertexId(after++));
    if (removed[i] == 0) ++after;
  }
  return edit;
}

// Blocks that lie in one run, across two, and anywhere.
TEST(EditedIds, GoWhereTheirElementsWent) {
  Random random(4);
  std::size_t gone = 0;
  for (int round = 0; round < 100; ++round) {
    const std::size_t size = 50 + random.below(3000);
    const ListEdit<VertexId> edit = random_edit(size, 1 + random.below(9), random);
    const IdVector<VertexId, VertexId> places = places_after(edit, size);
    const EditedIds<VertexId> edited(edit, places);
    for (int k = 0; k < 100; ++k) {
      const std::size_t spread = 1 + random.below(k % 2 == 0 ? size : 20);
      const std::size_t first = random.below(size - spread + 1);
      std::vector<VertexId> ids;
      std::vector<Triangle> triples(random.below(40));
      for (auto& triple : triples) {
        for (VertexId& v : triple) ids.push_back(v = VertexId(first + random.below(spread)));
      }
      const std::vector<VertexId> before = ids;
      edited.renew(std::span<VertexId>(ids));
      edited.renew(std::span<Triangle>(triples));
      for (std::size_t i = 0; i < ids.size(); ++i) {
        ASSERT_EQ(ids[i], places[before[i]]);
        ASSERT_EQ(triples[i / 3][i % 3], places[before[i]]);
        gone += ids[i].is_none() ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(gone, 100U);
}

}  // namespace
}  // namespace cocoon
