#include "cocone/noise/sample_parts.h"

#include <algorithm>
#include <vector>

#include "cocone/samples/sample_spacing.h"
#include "delaunay/circulate.h"
#include "geom/arrays/disjoint_sets.h"

namespace cocoon {

SampleParts sample_parts(const Triangulation& triangulation,
                         const IdVector<VertexId, double>& reach, const VertexSet& apart) {
  DisjointSets sets(triangulation.num_vertices());
  for (const CellId c : triangulation.finite_cells()) {
    const auto& corners = triangulation.cell(c).vertices;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = i + 1; k < 4; ++k) {
        const VertexId v = corners[i];
        const VertexId w = corners[k];
        if (!apart.empty() && (apart[v] != 0 || apart[w] != 0)) continue;
        // Most are together already, since an edge belongs to several cells.
        if (sets.root(v.value) == sets.root(w.value)) continue;
        if (is_linked(triangulation, reach, v, w)) sets.join(v.value, w.value);
      }
    }
  }
  SampleParts parts;
  parts.part = IdVector<VertexId, VertexId>(triangulation.num_vertices());
  parts.size = IdVector<VertexId, std::size_t>(triangulation.num_vertices(), 0);
  for (const VertexId v : triangulation.vertices()) {
    parts.part[v] = VertexId(sets.root(v.value));
    parts.largest = std::max(parts.largest, ++parts.size[parts.part[v]]);
  }
  return parts;
}

IdVector<VertexId, double> usual_spacing(const Triangulation& triangulation,
                                         const VertexStars& stars,
                                         const IdVector<VertexId, double>& spacing,
                                         std::span<const VertexId> vertices,
                                         const Execution& execution) {
  constexpr std::size_t grain = 4096;  // vertices a chunk
  IdVector<VertexId, double> usual(triangulation.num_vertices(), 0);
  const auto measure = [&](std::size_t begin, std::size_t end) {
    std::vector<VertexId> around;
    std::vector<double> spacings;
    const auto vertex_at = [&](std::size_t k) { return vertices[k]; };
    visit_stars(triangulation, stars, begin, end, vertex_at, [&](std::size_t k) {
      const VertexId v = vertices[k];
      collect_neighbors(triangulation, stars.star(v), v, around);
      spacings.clear();
      for (const VertexId w : around) spacings.push_back(spacing[w]);
      const auto median = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
      std::nth_element(spacings.begin(), median, spacings.end());
      usual[v] = std::max(spacing[v], *median);
    });
  };
  parallel_chunks(execution, vertices.size(), grain, measure);
  return usual;
}

}  // namespace cocoon
