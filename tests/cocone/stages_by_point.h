// What the stages of Tight Cocone give, in the ids of the points: as ref/cgal_stages.h has it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cocone/facets/facet_size.h"
#include "cocone/mark_cells.h"
#include "cocone/peel_cells.h"
#include "cocone/reconstruct.h"
#include "ref/cgal_stages.h"
#include "tests/cocone/stages.h"

namespace cocoon {

class StagesByPoint {
 public:
  // Preconditions: all points are different, and need no working scale.
  StagesByPoint(const std::vector<Point>& points, const ReconstructOptions& wanted)
      : options_(effective_options(wanted)), s_(points) {}

  ref::TightStages run() {
    ref::TightStages stages;
    stages.normals = by_point(s_.poles.normals);
    stages.heights = by_point(s_.poles.heights);
    const BoundarySamples labels = s_.labels(options_.boundary);
    stages.boundary = by_point(labels.boundary);
    const FacetSet candidates = candidate_triangles(s_.triangulation, s_.cocones, labels.boundary);
    stages.candidates = triangles(candidates);
    PrunedCandidates pruned = prune_sharp_edges(s_.triangulation, candidates, options_.prune);
    stages.umbrella = by_point(pruned.umbrella);
    stages.left = triangles(pruned.left.set);
    const LinkedFacets surface =
        extract_manifold(s_.triangulation, std::move(pruned.left), pruned.umbrella).triangles;
    stages.surface = triangles(surface.set);
    CellMarks marks =
        mark_cells(s_.triangulation, surface, labels.boundary, options_.good_vertices);
    stages.good = by_point(marks.good);
    stages.visited = by_point(marks.visited);
    const IdVector<CellId, CellLabel> marked = marks.labels;
    marks = peel_cells(s_.triangulation, surface.set, std::move(marks), options_.peel);
    set_cells(marked, marks, stages);
    if (labels.interior() == 0) stages.triangles.clear();  // SurfaceStatus::no_surface
    return stages;
  }

 private:
  PointId point_of(VertexId v) const {
    return v == infinite_vertex ? PointId() : s_.triangulation.point_of_vertex(v);
  }

  template <class T>
  IdVector<PointId, T> by_point(const IdVector<VertexId, T>& values) const {
    IdVector<PointId, T> result(values.size());
    for (const VertexId v : s_.triangulation.vertices()) result[point_of(v)] = values[v];
    return result;
  }

  std::array<PointId, 3> corners(FacetId f) const {
    std::array<PointId, 3> ids;
    const auto vertices = s_.triangulation.facet_vertices(f);
    for (std::size_t k = 0; k < 3; ++k) ids[k] = point_of(vertices[k]);
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  ref::TightStages::Triangles triangles(const FacetSet& facets) const {
    ref::TightStages::Triangles result;
    facets.for_each(s_.triangulation, [&](FacetId f) { result.push_back(corners(f)); });
    std::sort(result.begin(), result.end());
    return result;
  }

  // The vertex opposite to the facet by which the peel may not enter the cell, if it is poor.
  PointId stop(CellId c) const {
    int smallest = 0;
    for (int i = 1; i < 4; ++i) {
      const FacetSize size = size_of_facet(s_.triangulation, facet_id(c, i));
      if (size < size_of_facet(s_.triangulation, facet_id(c, smallest))) smallest = i;
    }
    return point_of(s_.triangulation.vertex(c, smallest));
  }

  void set_cells(const IdVector<CellId, CellLabel>& marked, const CellMarks& marks,
                 ref::TightStages& stages) const {
    const Triangulation& t = s_.triangulation;
    for (const CellId c : t.cells()) {
      ref::StagesCell cell{{},
                           static_cast<ref::Side>(marked[c]),
                           static_cast<ref::Side>(marks.labels[c]),
                           marks.reached[c] != 0,
                           t.is_infinite(c) ? PointId() : stop(c)};
      for (std::size_t i = 0; i < 4; ++i) cell.corners[i] = point_of(t.cell(c).vertices[i]);
      std::sort(cell.corners.begin(), cell.corners.end());
      stages.cells.push_back(cell);
      for (int i = 0; i < 4; ++i) {
        const bool reached = marks.reached[t.neighbor(c, i)] != 0;
        if (!cell.reached && reached) stages.triangles.push_back(corners(facet_id(c, i)));
      }
    }
    std::sort(stages.cells.begin(), stages.cells.end(),
              [](const auto& a, const auto& b) { return a.corners < b.corners; });
    std::sort(stages.triangles.begin(), stages.triangles.end());
  }

  ReconstructOptions options_;
  Stages s_;
};

}  // namespace cocoon
