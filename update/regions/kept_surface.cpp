#include "update/regions/kept_surface.h"

#include <algorithm>
#include <cstdint>

#include "cocone/solid/labels_of_solid.h"
#include "geom/arrays/sort_ids.h"
#include "geom/working_scale.h"

namespace cocoon {

OldSurface KeptSurface::told() const {
  OldSurface told;
  told.labels = [this](const Triangulation& triangulation, const FacetSet& surface,
                       const Execution& execution) {
    KnownLabels known = known_labels(triangulation, triangles(), surface, execution);
    if (known.is_foreign()) tell_by_model(triangulation, known, execution);
    if (seen_) seen_(triangulation, known, execution);
    return known;
  };
  told.add_likely = seen_;
  if (replacement_.kept_are_distinct) {
    told.triangles.torn = [this] { return torn(); };
    told.triangles.at = [this](std::span<const PointId> points) { return at(points); };
  }
  return told;
}

void KeptSurface::tell_by_model(const Triangulation& triangulation, KnownLabels& known,
                                const Execution& execution) const {
  const double scale = working_scale(replacement_.points);
  if (scale == 1) {
    add_labels_of_solid(triangulation, model_.mesh(), known.undisturbed, known,
                        labels_of_crossing_cells, execution);
    return;
  }
  const TriangleMesh solid = scaled(model_.mesh(), scale);
  add_labels_of_solid(triangulation, solid, known.undisturbed, known, labels_of_crossing_cells,
                      execution);
}

std::vector<KnownTriangle> KeptSurface::triangles() const {
  std::vector<KnownTriangle> known;
  for (const TriangleId t : model_.mesh().triangles.ids()) append(t, known);
  return known;
}

std::vector<PointId> KeptSurface::torn() const {
  std::vector<PointId> points;
  const auto take = [&](TriangleId t) {
    for (const PointId p : corners(t)) {
      if (!p.is_none()) points.push_back(p);
    }
  };
  regions_.region_of_facet.visit_where([&](RegionId r) { return is_replaced(r); }, take);
  for (const VertexId v : replacement_.vertices.removed) model_.for_each_triangle_at(v, take);
  return points;
}

std::vector<KnownTriangle> KeptSurface::at(std::span<const PointId> points) const {
  const std::vector<VertexId>& removed = replacement_.vertices.removed;
  std::vector<TriangleId> triangles;
  std::uint32_t gone = 0;  // so many vertices before this one
  for (const PointId p : points) {
    if (p.index() >= replacement_.vertices.kept) break;  // of a cloud
    // Kept vertices are the first points, in their order.
    while (gone < removed.size() && removed[gone].value <= p.value + gone) ++gone;
    model_.for_each_triangle_at(VertexId(p.value + gone),
                                [&](TriangleId t) { triangles.push_back(t); });
  }
  make_set(triangles);
  std::vector<KnownTriangle> known;
  for (const TriangleId t : triangles) append(t, known);
  return known;
}

// None: it goes.
KnownTriangle KeptSurface::corners(TriangleId t) const {
  const Triangle& vertices = model_.mesh().triangles[t];
  KnownTriangle points;
  std::transform(vertices.begin(), vertices.end(), points.begin(),
                 [&](VertexId v) { return replacement_.point_of_vertex[v]; });
  return points;
}

void KeptSurface::append(TriangleId t, std::vector<KnownTriangle>& known) const {
  if (is_replaced(regions_.region_of_facet[t])) return;
  const KnownTriangle points = corners(t);
  if (std::none_of(points.begin(), points.end(), [](PointId p) { return p.is_none(); })) {
    known.push_back(points);
  }
}

}  // namespace cocoon
