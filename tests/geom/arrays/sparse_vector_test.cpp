#include "geom/arrays/sparse_vector.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "geom/ids.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

using Sparse = SparseVector<VertexId, int>;

TEST(SparseVector, ByHand) {
  Sparse list(1000, 7);
  list.set(VertexId(999), 1);
  list.set(VertexId(3), 2);
  list.set(VertexId(4), 2);
  list.set(VertexId(4), 7);
  EXPECT_EQ(list[VertexId(3)], 2);
  EXPECT_EQ(list[VertexId(500)], 7);
  EXPECT_EQ(list.usual(), 7);
  std::vector<VertexId> found;
  list.visit_where([](int x) { return x != 7; }, [&](VertexId v) { found.push_back(v); });
  EXPECT_EQ(found, (std::vector{VertexId(3), VertexId(999)}));
  std::size_t sevens = 0;
  list.visit_where([](int x) { return x == 7; }, [&](VertexId) { ++sevens; });
  EXPECT_EQ(sevens, 998U);
  list.renew([](int x) { return x == 7 ? 0 : x; });
  EXPECT_EQ(list[VertexId(5)], 0);
  EXPECT_EQ(list[VertexId(500)], 0);
  EXPECT_EQ(list[VertexId(999)], 1);

  Sparse none;
  EXPECT_EQ(none.size(), 0U);
  none.visit_where([](int) { return true; }, [&](VertexId) { FAIL(); });
  none.push_back(3);
  EXPECT_EQ(none[VertexId(0)], 3);
}

// Each set may move the elements, and with them the one whose value is to be set.
TEST(SparseVector, TakesItsOwnElements) {
  SparseVector<VertexId, std::vector<int>> list(6400, {1, 2, 3});
  list.set(VertexId(0), {4, 5});
  for (std::uint32_t i = 64; i < 6400; i += 64) list.set(VertexId(i), list[VertexId(0)]);
  for (std::uint32_t i = 0; i < 6400; i += 64) {
    EXPECT_EQ(list[VertexId(i)], (std::vector{4, 5})) << i;
  }
  const std::size_t size = list.size();
  for (int i = 0; i < 200; ++i) list.push_back(list[VertexId(0)]);
  EXPECT_EQ(list[VertexId(static_cast<std::uint32_t>(size + 199))], (std::vector{4, 5}));
}

// A list that is equal has equal elements, whichever of them are the usual ones.
TEST(SparseVector, AsAnOrdinaryList) {
  Random random(2);
  for (const std::size_t size : {1U, 255U, 256U, 257U, 5000U}) {
    IdVector<VertexId, int> expected(size, 4);
    Sparse list(size, 4);
    Sparse all_set(size, 9);
    for (std::size_t k = 0; k < size / 50 + 3; ++k) {
      const VertexId v(random.below(size));
      expected[v] = static_cast<int>(random.below(6));
      list.set(v, expected[v]);
    }
    const Sparse before = list;
    for (int k = 0; k < 300; ++k) {
      expected.push_back(k % 5);
      list.push_back(k % 5);
      all_set.push_back(0);
    }
    EXPECT_FALSE(list == before);
    for (const VertexId v : expected.ids()) {
      EXPECT_EQ(list[v], expected[v]);
      all_set.set(v, expected[v]);
    }
    EXPECT_TRUE(list == all_set);
    all_set.set(VertexId(size / 2), 11);
    EXPECT_FALSE(list == all_set);
    for (int value = 0; value < 6; ++value) {
      std::vector<VertexId> found;
      std::vector<VertexId> of_value;
      list.visit_where([&](int x) { return x == value; }, [&](VertexId v) { found.push_back(v); });
      for (const VertexId v : expected.ids()) {
        if (expected[v] == value) of_value.push_back(v);
      }
      EXPECT_EQ(found, of_value);
    }
  }
}

}  // namespace
}  // namespace cocoon
