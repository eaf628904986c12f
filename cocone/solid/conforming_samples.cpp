#include "cocone/solid/conforming_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cocone/solid/cell_heights.h"
#include "delaunay/delaunay.h"
#include "delaunay/point_queries.h"
#include "geom/errors.h"
#include "geom/mesh/halfedges.h"
#include "geom/mesh/linked_mesh.h"
#include "geom/messages/require_number.h"
#include "geom/search/closest_facet.h"
#include "geom/search/thin_points.h"
#include "geom/working_scale.h"

namespace cocoon {
namespace {

// As triangles without area. None if there is no sharp edge.
std::optional<ClosestFacetTree> tree_of_sharp_edges(const TriangleMesh& solid, double smooth_cosine,
                                                    const Execution& execution) {
  const LinkedMesh linked = link_mesh(solid, execution);
  TriangleMesh edges;
  for (const Halfedge halfedge : sharp_edges(linked, smooth_cosine)) {
    edges.triangles.push_back({linked.from(halfedge), linked.to(halfedge), linked.to(halfedge)});
  }
  if (edges.triangles.empty()) return {};
  for (const VertexId v : linked.points.ids()) edges.points.push_back(linked.points[v]);
  return std::optional<ClosestFacetTree>(std::in_place, edges);
}

// Finite cells with one of these points as a vertex.
std::vector<CellId> cells_at(const Triangulation& triangulation, std::span<const PointId> points) {
  IdVector<VertexId, std::uint8_t> wanted(triangulation.num_vertices(), 0);
  for (const PointId p : points) wanted[triangulation.vertex_of_point()[p]] = 1;
  std::vector<CellId> cells;
  for (const CellId c : triangulation.finite_cells()) {
    const auto& vertices = triangulation.cell(c).vertices;
    const bool is_at_one =
        std::any_of(vertices.begin(), vertices.end(), [&](VertexId v) { return wanted[v] != 0; });
    if (is_at_one) cells.push_back(c);
  }
  return cells;
}

// A place for a sample, and how far it is from the closest one that there is.
struct Place {
  Point point;
  double gap = 0;
  CellId cell;  // that crosses the mesh there
};

class Refinement {
 public:
  Refinement(SolidDistances solid, Points samples, const ConformingOptions& options,
             const Execution& execution)
      : solid_(std::move(solid)),
        options_(options),
        execution_(execution),
        surface_(solid_.solid()),
        edges_(tree_of_sharp_edges(solid_.solid(), options.smooth_cosine, execution)),
        points_(samples.begin(), samples.end()),
        given_(samples.size()) {}

  ConformingSamples run() {
    ConformingSamples result;
    // Points at which cells are to be looked at. Cells between others were there before.
    std::vector<PointId> open;
    for (PointId p(0); p.index() < given_; ++p) open.push_back(p);
    for (;;) {
      const Triangulation triangulation = delaunay(points_, {}, execution_).triangulation;
      const std::vector<Place> places = places_in(triangulation, cells_at(triangulation, open));
      if (places.empty() || result.rounds == options_.max_rounds) break;
      ++result.rounds;
      open = add(triangulation, places);
    }
    result.added.assign(points_.begin() + static_cast<std::ptrdiff_t>(given_), points_.end());
    result.without_room = without_room_;
    return result;
  }

 private:
  // One for each cell that crosses the mesh where there is room.
  std::vector<Place> places_in(const Triangulation& triangulation,
                               const std::vector<CellId>& cells) {
    const auto cannot_cross = [&](const CentroidHeight& middle) {
      return middle.most_beyond() <= options_.min_depth * middle.longest_edge;
    };
    const std::vector<CellHeights> heights = cell_heights(
        triangulation, cells, solid_, CellPlaces::centroid_and_edges, cannot_cross, execution_);
    std::vector<Place> places;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (!heights[k].crosses(options_.min_depth)) continue;
      const Place place = place_in(triangulation, cells[k], heights[k]);
      if (has_room(place)) {
        places.push_back(place);
      } else {
        ++without_room_;
      }
    }
    return places;
  }

  // On the mesh about where it passes between the extremes of the cell, or on a sharp edge nearby.
  Place place_in(const Triangulation& triangulation, CellId cell,
                 const CellHeights& heights) const {
    const auto place_at = [&](const Point& p) {
      const VertexId nearest = nearest_vertex(triangulation, p, cell);
      return Place{p, distance(p, triangulation.point(nearest)), cell};
    };
    const double part = heights.highest / (heights.highest - heights.lowest);
    const Point between = heights.at_highest + part * (heights.at_lowest - heights.at_highest);
    const Place place = place_at(surface_.closest(between).point);
    if (!edges_) return place;
    const ClosestFacet edge = edges_->closest(place.point);
    if (!(std::sqrt(edge.squared_distance) <= options_.snap * place.gap)) return place;
    const Place moved = place_at(edge.point);
    return has_room(moved) ? moved : place;
  }

  bool has_room(const Place& place) const { return place.gap >= least_gap() && place.gap > 0; }
  double least_gap() const { return options_.closest * options_.spacing; }

  // Those that keep half of their gap from each other, in lexicographic order: cells come in any.
  // Returns the points at which there are new cells, or ones that still cross the mesh.
  std::vector<PointId> add(const Triangulation& triangulation, const std::vector<Place>& places) {
    std::vector<Point> points;
    points.reserve(places.size());
    for (const Place& place : places) points.push_back(place.point);
    const auto squared_distance_at = [&](PointId k) {
      const double distance = std::max(0.5 * places[k.index()].gap, least_gap());
      return distance * distance;
    };
    std::vector<Point> kept;
    std::vector<std::uint8_t> is_kept(places.size(), 0);
    for (const PointId k : thin_points(points, squared_distance_at)) {
      kept.push_back(points[k.index()]);
      is_kept[k.index()] = 1;
    }
    std::sort(kept.begin(), kept.end());
    std::vector<PointId> open;
    for (const Point& p : kept) {
      open.push_back(PointId(points_.size()));
      points_.push_back(p);
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (is_kept[k] != 0) continue;
      for (const VertexId v : triangulation.cell(places[k].cell).vertices) {
        open.push_back(triangulation.point_of_vertex(v));
      }
    }
    return open;
  }

  SolidDistances solid_;
  const ConformingOptions& options_;
  const Execution& execution_;
  ClosestFacetTree surface_;
  std::optional<ClosestFacetTree> edges_;
  std::vector<Point> points_;
  std::size_t given_;
  std::size_t without_room_ = 0;
};

}  // namespace

// Projections take fourth powers of lengths: beyond working sizes they would overflow or vanish.
ConformingSamples conforming_samples(const SolidDistances& solid, Points samples,
                                     const ConformingOptions& options, const Execution& execution) {
  constexpr const char* stage = "conforming_samples";
  require_amounts(
      stage,
      {{"min_depth", options.min_depth}, {"closest", options.closest}, {"snap", options.snap}});
  if (!(options.spacing > 0) || !std::isfinite(options.spacing)) {
    throw InputError("the spacing of samples must be a positive number");
  }
  if (!is_balanced(solid.solid(), execution)) return {};
  const double scale = working_scale(solid.solid().points.raw());
  if (scale == 1) return Refinement(solid, samples, options, execution).run();
  ConformingOptions scaled_options = options;
  scaled_options.spacing *= scale;
  const TriangleMesh scaled_solid = scaled(solid.solid(), scale);
  ConformingSamples result =
      Refinement(scaled_solid, scaled(samples, scale), scaled_options, execution).run();
  for (Point& p : result.added) p = p / scale;
  return result;
}

}  // namespace cocoon
