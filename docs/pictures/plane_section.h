// What the plane z = 0 cuts out of cells, facets and Voronoi cells.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "delaunay/triangulation.h"
#include "delaunay/vertex_stars.h"
#include "docs/pictures/svg_canvas.h"

namespace cocoon::pictures {

// The convex polygon in which the plane meets a finite cell, counterclockwise; empty if that has no
// area. O(1).
std::vector<Planar> section_of_cell(const Triangulation& triangulation, CellId c);

// The stretch in which the plane crosses a finite facet, or that edge of it which lies in the
// plane. Nothing where they share a point at most, or where the facet lies in the plane. O(1).
std::optional<std::pair<Planar, Planar>> section_of_facet(const Triangulation& triangulation,
                                                          FacetId f);

// What of a convex polygon has dot(normal, p) <= limit. O(corners).
std::vector<Planar> clipped(std::span<const Planar> polygon, Planar normal, double limit);

// The convex polygon in which the plane meets the Voronoi cell of v, within `reach` of its sample
// in x and y; empty if they do not meet. O(star).
std::vector<Planar> section_of_voronoi_cell(const Triangulation& triangulation,
                                            const VertexStars& stars, VertexId v, double reach);

}  // namespace cocoon::pictures
