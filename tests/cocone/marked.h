// The surface of some points, and the marks that it gives.
#pragma once

#include <vector>

#include "cocone/mark_cells.h"
#include "tests/cocone/stages.h"

namespace cocoon {

struct Marked {
  explicit Marked(const std::vector<Point>& points) : s(points), labels(s.labels()) {
    const LinkedFacets triangles = s.surface(labels);
    marks = mark_cells(s.triangulation, triangles, labels.boundary);
    surface = triangles.set;
  }

  // `labels_in_doubt` count as known and as likely.
  CellMarks undoubted(const IdVector<CellId, CellLabel>& labels_in_doubt) const {
    const LinkedFacets triangles = s.surface(labels);
    return mark_undoubted_cells(s.triangulation, triangles,
                                good_vertices(triangles, labels.boundary), labels_in_doubt,
                                labels_in_doubt);
  }

  Stages s;
  BoundarySamples labels;
  FacetSet surface;
  CellMarks marks;
};

}  // namespace cocoon
