#include "cocone/solid/labels_of_solid.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cocone/solid/cell_heights.h"
#include "geom/mesh/halfedges.h"
#include "geom/messages/require_number.h"
#include "geom/messages/require_size.h"
#include "geom/parallel/parallel_list.h"
#include "geom/search/winding_number.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// All but those whose centroid lies on the side that is known of them: they would stay as they are,
// however deep. To tell a side takes a fourth of the time of a distance.
std::vector<CellId> without_confirmed(const Triangulation& triangulation, const TriangleMesh& solid,
                                      std::span<const CellId> cells, const KnownLabels& known,
                                      const Execution& execution) {
  const WindingNumbers winding(solid, execution);
  const auto is_confirmed = [&](CellId c) {
    if (known.labels[c] == CellLabel::unmarked) return false;
    const bool is_inside = winding.at(centroid_of(triangulation, c)) != 0;
    return known.labels[c] == (is_inside ? CellLabel::in : CellLabel::out);
  };
  const auto find = [&](std::size_t begin, std::size_t end, std::vector<CellId>& found) {
    for (std::size_t k = begin; k < end; ++k) {
      if (!is_confirmed(cells[k])) found.push_back(cells[k]);
    }
  };
  constexpr std::size_t grain = 1024;
  const StagePart part{"signed_distance"};
  return parallel_list<CellId>(execution, part, cells.size(), grain, find);
}

}  // namespace

KnownLabels labels_of_solid(const Triangulation& triangulation, const SolidDistances& solid,
                            const LabelsOfSolidOptions& options, const Execution& execution) {
  std::vector<CellId> cells;
  cells.reserve(triangulation.num_finite_cells());
  for (const CellId c : triangulation.finite_cells()) cells.push_back(c);
  KnownLabels known;
  add_labels_of_solid(triangulation, solid, cells, known, options, execution);
  return known;
}

void add_labels_of_solid(const Triangulation& triangulation, const SolidDistances& solid,
                         std::span<const CellId> cells, KnownLabels& known,
                         const LabelsOfSolidOptions& options, const Execution& execution) {
  if (!known.labels.empty()) {
    require_size("add_labels_of_solid", "known labels of cells", known.labels.size(),
                 triangulation.num_cells());
  }
  require_amounts("add_labels_of_solid", {{"min_depth", options.min_depth}});
  const TriangleMesh& mesh = solid.solid();
  if (!is_balanced(mesh, execution)) return;
  std::vector<CellId> open;
  if (known.cells > 0 && options.places == CellPlaces::centroid) {
    open = without_confirmed(triangulation, mesh, cells, known, execution);
    cells = open;
  }
  const auto is_settled = [&](const CentroidHeight& middle) {
    const double height = std::abs(middle.height);
    return height > options.min_depth * middle.longest_edge && height > middle.most_beyond();
  };
  const std::vector<CellHeights> heights =
      cell_heights(triangulation, cells, solid, options.places, is_settled, execution);
  known.labels.resize(triangulation.num_cells(), CellLabel::unmarked);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double height = heights[i].deepest();
    if (!(std::abs(height) > options.min_depth * heights[i].longest_edge)) continue;
    const CellLabel told = height > 0 ? CellLabel::out : CellLabel::in;
    CellLabel& label = known.labels[cells[i]];
    if (label == CellLabel::unmarked) {
      label = told;
      ++known.cells;
    } else if (label != told) {
      label = CellLabel::unmarked;
      --known.cells;
    }
  }
}

KnownLabelsSource labels_told_by(TriangleMesh solid, Points samples,
                                 const LabelsOfSolidOptions& options) {
  SolidDistances kept(std::make_shared<const TriangleMesh>(std::move(solid)));
  return labels_told_by(std::move(kept), samples, options);
}

KnownLabelsSource labels_told_by(SolidDistances solid, Points samples,
                                 const LabelsOfSolidOptions& options) {
  if (const double scale = working_scale(samples); scale != 1) {
    solid = SolidDistances(std::make_shared<const TriangleMesh>(scaled(solid.solid(), scale)));
  }
  return [solid = std::move(solid), options](const Triangulation& triangulation, const FacetSet&,
                                             const Execution& execution) {
    return labels_of_solid(triangulation, solid, options, execution);
  };
}

}  // namespace cocoon
