#include "geom/arrays/list_edit.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/random/random.h"

namespace cocoon {
namespace {

using List = IdVector<VertexId, std::uint32_t>;

// A list and one made of it by taking away and putting in at random places.
struct Case {
  List before;
  List after;
  ListEdit<VertexId> edit;
  std::vector<std::uint32_t> removed;
  std::vector<std::uint32_t> added;
};

Case random_case(std::size_t size, std::uint64_t in_ten_out, std::uint64_t in_ten_in,
                 Random& random) {
  Case c;
  std::uint32_t fresh = 1000;
  const auto put_in = [&] {
    while (random.below(10) < in_ten_in) {
      c.added.push_back(fresh);
      c.edit.added.push_back(c.after.push_back(fresh++));
    }
  };
  for (std::uint32_t i = 0; i < size; ++i) {
    put_in();
    const VertexId place = c.before.push_back(i);
    if (random.below(10) < in_ten_out) {
      c.edit.removed.push_back(place);
      c.removed.push_back(i);
    } else {
      c.after.push_back(i);
    }
  }
  put_in();
  return c;
}

TEST(ListEdit, ThereAndBack) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const Case c = random_case(random.below(60), random.below(11), random.below(8), random);
    ASSERT_EQ(c.edit.size_after(c.before.size()), c.after.size());
    List list = c.before;
    edit_list(list, c.edit, c.added);
    ASSERT_EQ(list, c.after) << "round " << round;
    edit_list(list, c.edit.reversed(), c.removed);
    ASSERT_EQ(list, c.before) << "round " << round;
  }
}

TEST(ListEdit, RenewsWhatStaysOnce) {
  Random random(2);
  for (int round = 0; round < 50; ++round) {
    Case c = random_case(40, 3, 3, random);
    edit_list_by_blocks(c.before, c.edit, c.added, [](std::span<std::uint32_t> elements) {
      for (std::uint32_t& element : elements) element += 100;
    });
    for (const VertexId v : c.after.ids()) {
      const std::uint32_t expected = c.after[v] < 1000 ? c.after[v] + 100 : c.after[v];
      ASSERT_EQ(c.before[v], expected);
    }
  }
}

TEST(ListEdit, TellsWhereEachElementWent) {
  Random random(3);
  const Case c = random_case(100, 3, 4, random);
  const IdVector<VertexId, VertexId> places = places_after(c.edit, c.before.size());
  std::size_t gone = 0;
  for (const VertexId v : places.ids()) {
    if (places[v].is_none()) {
      ++gone;
    } else {
      EXPECT_EQ(c.after[places[v]], c.before[v]);
    }
  }
  EXPECT_EQ(gone, c.removed.size());
  EXPECT_GT(gone, 10U);
}

}  // namespace
}  // namespace cocoon
