#include "delaunay/point_queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <unordered_set>

#include "delaunay/circulate.h"
#include "delaunay/locate.h"
#include "geom/arrays/sort_ids.h"
#include "geom/compare_distance.h"
#include "geom/errors.h"
#include "geom/orient3d.h"

namespace cocoon {
namespace {

// The cell of an evenly spread sample whose first vertex is nearest to p. As many as the fourth
// root of their number balances the sample with the walk that follows.
CellId sampled_cell_near(const TriangulationView& triangulation, const Point& p) {
  const std::size_t count = triangulation.cell_records().size();
  const auto samples =
      static_cast<std::size_t>(std::sqrt(std::sqrt(static_cast<double>(count)))) + 1;
  CellId best;
  double nearest = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    CellId c(i * count / samples);
    while (c.index() < count && triangulation.is_free(c)) ++c;
    if (c.index() == count) break;
    const double squared = squared_distance(triangulation.point(triangulation.vertex(c, 0)), p);
    if (!best.is_none() && !(squared < nearest)) continue;
    best = c;
    nearest = squared;
  }
  return best;
}

void require_cell(const TriangulationView& triangulation, CellId c) {
  if (c.index() < triangulation.cell_records().size() && !triangulation.is_free(c)) return;
  throw InputError("cell " + std::to_string(c.value) +
                   " is not in the triangulation; give one of its cells");
}

CellId walk_to(const TriangulationView& triangulation, const Point& p, CellId hint) {
  if (triangulation.cell_records().empty()) {
    throw InputError("the triangulation has no cells to look for a point in; insert points first");
  }
  if (!hint.is_none()) require_cell(triangulation, hint);
  const CellId start = hint.is_none() ? sampled_cell_near(triangulation, p) : hint;
  return locate(triangulation.cell_records(), triangulation.points(), p, start);
}

void require_cell_at(const TriangulationView& triangulation, VertexId v, CellId cell) {
  require_cell(triangulation, cell);
  const std::array<VertexId, 4>& vertices = triangulation.cell(cell).vertices;
  if (std::find(vertices.begin(), vertices.end(), v) != vertices.end()) return;
  throw InputError("vertex " + std::to_string(v.value) + " is none of cell " +
                   std::to_string(cell.value) + "; give a cell at the vertex");
}

// True iff a is the better answer to "which vertex is nearest to p".
bool is_nearer(const Point& p, const Point& a, const Point& b) {
  const Sign sign = compare_distance(p, a, b);
  return sign == Sign::zero ? a < b : sign == Sign::negative;
}

// Calls visit(CellId) for the cells of a star, until it returns false.
template <class Visit>
void flood_star(const TriangulationView& triangulation, VertexId v, CellId cell, Visit visit) {
  std::vector<CellId> queue{cell};
  std::unordered_set<CellId> seen{cell};
  for (std::size_t k = 0; k < queue.size(); ++k) {
    if (!visit(queue[k])) return;
    const int opposite = index_of_vertex(triangulation.cell(queue[k]), v);
    for (int i = 0; i < 4; ++i) {
      if (i == opposite) continue;
      const CellId next = triangulation.neighbor(queue[k], i);
      if (seen.insert(next).second) queue.push_back(next);
    }
  }
}

}  // namespace

Location locate(const TriangulationView& triangulation, const Point& p, CellId hint) {
  Location location;
  location.cell = walk_to(triangulation, p, hint);
  const Cell& cell = triangulation.cell(location.cell);
  std::size_t count = 0;
  if (is_infinite(cell)) {
    for (; count < 3; ++count) location.vertices[count] = cell.vertices[count];
  } else {
    // The face is spanned by the vertices whose opposite facets do not contain p.
    for (std::size_t i = 0; i < 4; ++i) {
      const Triangle facet =
          triangulation.facet_vertices(facet_id(location.cell, static_cast<int>(i)));
      if (orient3d(triangulation.point(facet[0]), triangulation.point(facet[1]),
                   triangulation.point(facet[2]), p) != Sign::zero) {
        location.vertices[count++] = cell.vertices[i];
      }
    }
    location.kind = static_cast<LocationKind>(count - 1);
  }
  std::sort(location.vertices.begin(), location.vertices.end());  // none comes last
  return location;
}

VertexId nearest_vertex(const TriangulationView& triangulation, const Point& p, CellId hint) {
  CellId at = walk_to(triangulation, p, hint);
  VertexId nearest = triangulation.vertex(at, 0);
  // Moves on to the vertices of c that are nearer.
  const auto improve = [&](CellId c) {
    bool improved = false;
    for (const VertexId v : triangulation.cell(c).vertices) {
      if (v == infinite_vertex || v == nearest ||
          !is_nearer(p, triangulation.point(v), triangulation.point(nearest))) {
        continue;
      }
      nearest = v;
      at = c;
      improved = true;
    }
    return improved;
  };
  improve(at);
  for (bool improved = true; improved;) {
    improved = false;
    flood_star(triangulation, nearest, at, [&](CellId c) {
      improved = improve(c);
      return !improved;
    });
  }
  return nearest;
}

std::vector<CellId> star_of_vertex(const TriangulationView& triangulation, VertexId v,
                                   CellId cell) {
  require_cell_at(triangulation, v, cell);
  std::vector<CellId> star;
  flood_star(triangulation, v, cell, [&](CellId c) {
    star.push_back(c);
    return true;
  });
  return star;
}

std::vector<VertexId> neighbors_of_vertex(const TriangulationView& triangulation, VertexId v,
                                          CellId cell) {
  require_cell_at(triangulation, v, cell);
  std::vector<VertexId> neighbors;
  flood_star(triangulation, v, cell, [&](CellId c) {
    for (const VertexId w : triangulation.cell(c).vertices) {
      if (w != v && w != infinite_vertex) neighbors.push_back(w);
    }
    return true;
  });
  make_set(neighbors);
  return neighbors;
}

}  // namespace cocoon
