#include "geom/arrays/sort_by_vertex.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

// By vertex, then by source and by its order in there.
using Thing = std::pair<VertexId, std::uint32_t>;

struct Sorted {
  std::vector<std::uint32_t> begins;
  std::vector<Thing> things;
};

// Source k has the things k, k + 1000000 ... at the vertices of sources[k].
Sorted sorted_by_vertex(const std::vector<std::vector<VertexId>>& sources, std::size_t num_vertices,
                        int threads) {
  Sorted sorted;
  sorted.begins = sort_by_vertex(
      sources.size(), num_vertices, Execution{.threads = threads},
      [&](std::size_t count) { sorted.things.resize(count); },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (std::size_t k = begin; k < end; ++k) {
          auto thing = static_cast<std::uint32_t>(k);
          for (const VertexId v : sources[k]) {
            put(v, [&](std::uint32_t place) { sorted.things[place] = {v, thing}; });
            thing += 1000000;
          }
        }
      });
  return sorted;
}

// The same by things that are copied later than their places are asked for.
Sorted copied_by_vertex(const std::vector<std::vector<VertexId>>& sources, std::size_t num_vertices,
                        int threads) {
  Sorted sorted;
  std::vector<std::uint8_t> is_asked;
  sorted.begins = sort_by_vertex<Thing>(
      sources.size(), num_vertices, Execution{.threads = threads},
      [&](std::size_t count) {
        sorted.things.resize(count);
        is_asked.resize(count, 0);
      },
      [&](std::size_t begin, std::size_t end, auto put) {
        for (std::size_t k = begin; k < end; ++k) {
          auto thing = static_cast<std::uint32_t>(k);
          for (const VertexId v : sources[k]) {
            put(v, Thing{v, thing});
            thing += 1000000;
          }
        }
      },
      [&](std::uint32_t place) { ++is_asked[place]; },
      [&](std::uint32_t place, const Thing& thing) {
        sorted.things[place] = thing;
        ++is_asked[place];
      });
  EXPECT_EQ(is_asked, std::vector<std::uint8_t>(is_asked.size(), 2));
  return sorted;
}

void expect_sorted(const std::vector<std::vector<VertexId>>& sources, std::size_t num_vertices) {
  std::vector<Thing> expected;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    auto thing = static_cast<std::uint32_t>(k);
    for (const VertexId v : sources[k]) {
      expected.emplace_back(v, thing);
      thing += 1000000;
    }
  }
  std::stable_sort(expected.begin(), expected.end(),
                   [](const Thing& a, const Thing& b) { return a.first < b.first; });
  for (const int threads : {1, 2, 3, 11}) {
    SCOPED_TRACE(threads);
    const Sorted sorted = sorted_by_vertex(sources, num_vertices, threads);
    const Sorted copied = copied_by_vertex(sources, num_vertices, threads);
    ASSERT_EQ(sorted.things, expected);
    ASSERT_EQ(copied.things, expected);
    ASSERT_EQ(copied.begins, sorted.begins);
    ASSERT_EQ(sorted.begins.size(), num_vertices + 1);
    for (std::size_t v = 0; v <= num_vertices; ++v) {
      const auto begin = std::find_if(expected.begin(), expected.end(),
                                      [&](const Thing& thing) { return thing.first.index() >= v; });
      if (v % 97 == 0 || v == num_vertices) {
        EXPECT_EQ(sorted.begins[v], static_cast<std::size_t>(begin - expected.begin()));
      }
    }
  }
}

TEST(SortByVertex, GroupsKeepTheOrderOfTheirSources) {
  Random random(5);
  std::vector<std::vector<VertexId>> sources(50000);
  for (std::vector<VertexId>& source : sources) {
    source.resize(random.below(4));
    for (VertexId& v : source) v = VertexId(random.below(700));
  }
  expect_sorted(sources, 700);
}

TEST(SortByVertex, MoreVerticesThanOneChunk) {
  Random random(6);
  std::vector<std::vector<VertexId>> sources(30000);
  for (std::vector<VertexId>& source : sources) source.assign(1, VertexId(random.below(80000)));
  expect_sorted(sources, 80000);
}

TEST(SortByVertex, Nothing) {
  expect_sorted({}, 0);
  expect_sorted({}, 5);
  expect_sorted(std::vector<std::vector<VertexId>>(7), 3);
}

}  // namespace
}  // namespace cocoon
