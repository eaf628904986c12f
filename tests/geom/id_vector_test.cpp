#include "geom/id_vector.h"

#include <gtest/gtest.h>
#include <type_traits>
#include <vector>

namespace cocoon {
namespace {

using Numbers = IdVector<VertexId, int>;

// By ids of its own type alone.
template <class Index>
concept IndexesNumbers = requires(Numbers numbers, Index i) {
  numbers[i];
};
static_assert(IndexesNumbers<VertexId>);
static_assert(!IndexesNumbers<CellId> && !IndexesNumbers<int> && !IndexesNumbers<std::size_t>);
static_assert(!std::is_convertible_v<int, VertexId> && !std::is_convertible_v<VertexId, CellId>);

TEST(Ids, NoneIsNoPlace) {
  EXPECT_TRUE(VertexId().is_none());
  EXPECT_FALSE(VertexId(0).is_none());
  EXPECT_EQ(VertexId(7).index(), 7U);
  EXPECT_LT(VertexId(7), VertexId());
}

TEST(Ids, RangesCountUp) {
  std::vector<std::uint32_t> values;
  for (const CellId c : IdRange<CellId>(CellId(2), CellId(5))) values.push_back(c.value);
  EXPECT_EQ(values, (std::vector<std::uint32_t>{2, 3, 4}));
  for (const CellId c : id_range<CellId>(0)) ADD_FAILURE() << c.value;
}

TEST(IdVector, GrowsAndKeepsItsElements) {
  Numbers numbers(2, 5);
  EXPECT_EQ(numbers.push_back(6), VertexId(2));
  numbers.resize(5, 7);
  EXPECT_EQ(numbers.raw(), (std::vector<int>{5, 5, 6, 7, 7}));
  numbers.resize(3, 8);
  EXPECT_EQ(numbers, Numbers(std::vector<int>{5, 5, 6}));
  numbers.clear();
  EXPECT_TRUE(numbers.empty());
  numbers.resize(2, 9);
  EXPECT_EQ(numbers.span()[1], 9);
}

TEST(IdVector, ItsIdsNameItsElements) {
  Numbers numbers(std::vector<int>{4, 5, 6});
  for (const VertexId v : numbers.ids()) numbers[v] += static_cast<int>(v.value);
  EXPECT_EQ(numbers.raw(), (std::vector<int>{4, 6, 8}));
}

}  // namespace
}  // namespace cocoon
