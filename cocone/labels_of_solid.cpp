#include "cocone/labels_of_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/require_number.h"
#include "geom/require_size.h"
#include "geom/signed_distance.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

using Corners = std::array<Point, 4>;

Corners corners_of_cell(const Triangulation& triangulation, CellId c) {
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    corners[static_cast<std::size_t>(i)] = triangulation.point(triangulation.vertex(c, i));
  }
  return corners;
}

Point centroid(const Corners& p) { return 0.25 * ((p[0] + p[1]) + (p[2] + p[3])); }

double longest_edge(const Corners& p) {
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < i; ++k) longest = std::max(longest, norm(p[i] - p[k]));
  }
  return longest;
}

}  // namespace

KnownLabels labels_of_solid(const Triangulation& triangulation, const TriangleMesh& solid,
                            const LabelsOfSolidOptions& options, const Execution& execution) {
  std::vector<CellId> cells;
  cells.reserve(triangulation.num_finite_cells());
  for (const CellId c : triangulation.finite_cells()) cells.push_back(c);
  KnownLabels known;
  add_labels_of_solid(triangulation, solid, cells, known, options, execution);
  return known;
}

void add_labels_of_solid(const Triangulation& triangulation, const TriangleMesh& solid,
                         std::span<const CellId> cells, KnownLabels& known,
                         const LabelsOfSolidOptions& options, const Execution& execution) {
  if (!known.labels.empty()) {
    require_size("add_labels_of_solid", "known labels of cells", known.labels.size(),
                 triangulation.num_cells());
  }
  require_amounts("add_labels_of_solid", {{"min_depth", options.min_depth}});
  if (!mesh_check(solid).balanced) return;
  std::vector<Point> centroids;
  centroids.reserve(cells.size());
  for (const CellId c : cells) centroids.push_back(centroid(corners_of_cell(triangulation, c)));
  const std::vector<double> heights = signed_distances(solid, centroids, execution);
  known.labels.resize(triangulation.num_cells(), CellLabel::unmarked);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double length = longest_edge(corners_of_cell(triangulation, cells[i]));
    if (!(std::abs(heights[i]) > options.min_depth * length)) continue;
    known.labels[cells[i]] = heights[i] > 0 ? CellLabel::out : CellLabel::in;
    ++known.cells;
  }
}

KnownLabelsSource labels_told_by(TriangleMesh solid, Points samples,
                                 const LabelsOfSolidOptions& options) {
  if (const double scale = working_scale(samples); scale != 1) {
    solid = scaled(std::move(solid), scale);
  }
  const auto kept = std::make_shared<const TriangleMesh>(std::move(solid));
  return [kept, options](const Triangulation& triangulation, const FacetSet&,
                         const Execution& execution) {
    return labels_of_solid(triangulation, *kept, options, execution);
  };
}

}  // namespace cocoon
