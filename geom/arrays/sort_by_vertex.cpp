#include "geom/arrays/sort_by_vertex.h"

#include <numeric>
#include <utility>

namespace cocoon::sort_by_vertex_detail {

std::vector<std::uint32_t> places_of_groups(std::vector<Counts>& parts, std::size_t num_vertices,
                                            const Execution& execution) {
  constexpr std::size_t vertices_per_chunk = std::size_t{1} << 15;
  std::vector<std::uint32_t> chunks((num_vertices + vertices_per_chunk - 1) / vertices_per_chunk);
  std::vector<std::uint32_t> begins(num_vertices + 1);
  parallel_chunks(execution, num_vertices, vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    std::uint32_t sum = 0;
                    for (VertexId v(begin); v.index() < end; ++v) {
                      begins[v.index()] = sum;  // in its chunk
                      for (const Counts& counts : parts) sum += counts[v];
                    }
                    chunks[begin / vertices_per_chunk] = sum;
                  });
  begins[num_vertices] = std::accumulate(chunks.begin(), chunks.end(), std::uint32_t{0});
  std::exclusive_scan(chunks.begin(), chunks.end(), chunks.begin(), std::uint32_t{0});
  parallel_chunks(execution, num_vertices, vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (VertexId v(begin); v.index() < end; ++v) {
                      begins[v.index()] += chunks[begin / vertices_per_chunk];
                      std::uint32_t place = begins[v.index()];
                      for (Counts& counts : parts) {
                        // Memory for vertices that a part does not have stays untouched.
                        if (counts[v] != 0) place += std::exchange(counts[v], place);
                      }
                    }
                  });
  return begins;
}

}  // namespace cocoon::sort_by_vertex_detail
