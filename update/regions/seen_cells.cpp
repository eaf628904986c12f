#include "update/regions/seen_cells.h"

#include <algorithm>
#include <cstdint>

#include "cocone/marking/cell_label.h"
#include "delaunay/point_queries.h"
#include "geom/id_vector.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

constexpr double most_places = 1000;  // on a line, however short the steps

enum Told : std::uint8_t { air = 1, body = 2 };

// What the lines tell each cell.
IdVector<CellId, std::uint8_t> told_along(const Triangulation& triangulation,
                                          std::span<const Sight> sights,
                                          const SightOptions& options) {
  IdVector<CellId, std::uint8_t> told(triangulation.num_cells(), 0);
  CellId hint;
  for (const Sight& sight : sights) {
    const Vec3 way = sight.to - sight.from;
    const double length = norm(way);
    const double first = options.clearance * sight.spacing;
    const double places = std::min((length - first) / (options.step * sight.spacing), most_places);
    for (double i = 0; i < places; ++i) {
      const double at = first + i / places * (length - first);
      const Location place = locate(triangulation, sight.from + (at / length) * way, hint);
      hint = place.cell;
      if (place.kind != LocationKind::cell) continue;
      std::uint8_t& of_cell = told[place.cell];
      of_cell = static_cast<std::uint8_t>(of_cell | (sight.is_air ? air : body));
    }
  }
  return told;
}

}  // namespace

void add_seen_cells(const Triangulation& triangulation, std::span<const Sight> sights,
                    const SightOptions& options, KnownLabels& known) {
  require_options("add_seen_cells", options);
  if (sights.empty() || options.step == 0) return;
  const IdVector<CellId, std::uint8_t> told = told_along(triangulation, sights, options);
  known.likely = IdVector<CellId, CellLabel>(triangulation.num_cells(), CellLabel::unmarked);
  for (const CellId c : triangulation.finite_cells()) {
    if (told[c] != air && told[c] != body) continue;
    if (!known.labels.empty() && known.labels[c] != CellLabel::unmarked) continue;
    known.likely[c] = told[c] == air ? CellLabel::out : CellLabel::in;
  }
}

}  // namespace cocoon
