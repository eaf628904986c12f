// Puts things in groups, each by a vertex: a counting sort on all threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geom/arrays/zeroed_array.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/ids.h"

namespace cocoon {

namespace sort_by_vertex_detail {

using Counts = ZeroedArray<VertexId, std::uint32_t>;

// Turns what each part of the sources has for each vertex into the places of these things, and
// returns where the groups begin.
std::vector<std::uint32_t> places_of_groups(std::vector<Counts>& parts, std::size_t num_vertices,
                                            const Execution& execution);

// More are not worth the memory of their counts.
constexpr std::size_t most_parts = 8;

}  // namespace sort_by_vertex_detail

// for_each(begin, end, put) calls put(vertex, write) for each of the things that the sources
// begin .. end - 1 have, in order: the same ones whenever it is called, which it is twice, by
// several threads. allocate(n) is called once with their number, then write(place) for each of
// them, places being 0 .. n - 1. The groups follow each other in the order of the vertices; within
// a group things keep the order of their sources. Returns where the groups begin, and n:
// num_vertices + 1 numbers. Precondition: fewer than 2^32 things. Complexity: O(things +
// num_vertices), parallel; 4 bytes for each vertex and, up to 8, each thread.
template <class Allocate, class ForEach>
std::vector<std::uint32_t> sort_by_vertex(std::size_t num_sources, std::size_t num_vertices,
                                          const Execution& execution, Allocate allocate,
                                          ForEach for_each) {
  using namespace sort_by_vertex_detail;
  constexpr std::size_t fewest_sources_per_thread = 4096;
  const std::size_t most = std::min(most_parts, static_cast<std::size_t>(thread_count(execution)));
  const std::size_t grain = std::max((num_sources + most - 1) / most, fewest_sources_per_thread);
  std::vector<Counts> parts((num_sources + grain - 1) / grain);
  parallel_chunks(execution, num_sources, grain, [&](std::size_t begin, std::size_t end) {
    Counts& counts = parts[begin / grain];
    counts = Counts(num_vertices);
    for_each(begin, end, [&](VertexId v, const auto&) { ++counts[v]; });
  });
  std::vector<std::uint32_t> begins = places_of_groups(parts, num_vertices, execution);
  allocate(std::size_t{begins.back()});
  parallel_chunks(execution, num_sources, grain, [&](std::size_t begin, std::size_t end) {
    Counts& places = parts[begin / grain];
    for_each(begin, end, [&](VertexId v, const auto& write) { write(places[v]++); });
  });
  return begins;
}

// The same of things that are copied to their places, which lie far apart in memory: put(vertex,
// thing), and store(place, thing) is called some things later than ask(place), which asks for the
// memory there.
template <class Thing, class Allocate, class ForEach, class Ask, class Store>
std::vector<std::uint32_t> sort_by_vertex(std::size_t num_sources, std::size_t num_vertices,
                                          const Execution& execution, Allocate allocate,
                                          ForEach for_each, Ask ask, Store store) {
  constexpr std::size_t sources_per_block = 64;
  struct Placed {
    std::uint32_t place;
    Thing thing;
  };
  return sort_by_vertex(num_sources, num_vertices, execution, allocate,
                        [&](std::size_t begin, std::size_t end, auto put) {
                          OverwriteVector<Placed> placed;
                          for (std::size_t first = begin; first < end; first += sources_per_block) {
                            placed.clear();
                            for_each(first, std::min(first + sources_per_block, end),
                                     [&](VertexId v, const Thing& thing) {
                                       put(v, [&](std::uint32_t place) {
                                         ask(place);
                                         placed.push_back({place, thing});
                                       });
                                     });
                            for (const Placed& p : placed) store(p.place, p.thing);
                          }
                        });
}

}  // namespace cocoon
