#include "ref/triangulation_of_cells.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "geom/errors.h"
#include "geom/messages/counted.h"

namespace cocoon::ref {
namespace {

using CellVertices = std::array<VertexId, 4>;

// The corners that have to be ascending: all four, or the three finite ones.
std::size_t finite_corners(const CellVertices& vertices) {
  return vertices[3] == infinite_vertex ? 3 : 4;
}

// Sorts the finite corners, then repairs the orientation if the sort was an odd permutation.
void make_canonical(CellVertices& vertices) {
  const std::size_t n = finite_corners(vertices);
  bool odd = false;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) odd ^= vertices[j] < vertices[i];
  }
  std::sort(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(n));
  if (odd) std::swap(vertices[n - 2], vertices[n - 1]);
}

// One of the two views of a facet.
struct FacetView {
  Triangle sorted_vertices;
  FacetId facet;

  friend auto operator<=>(const FacetView&, const FacetView&) = default;
};

// All facets of all cells; the two views of a facet stand side by side.
std::vector<FacetView> sorted_facets(const std::vector<CellVertices>& cells) {
  std::vector<FacetView> facets;
  facets.reserve(4 * cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (int i = 0; i < 4; ++i) {
      const int* corner = facet_corners[i];
      FacetView view;
      for (std::size_t k = 0; k < 3; ++k) {
        view.sorted_vertices[k] = cells[c][static_cast<std::size_t>(corner[k])];
      }
      std::sort(view.sorted_vertices.begin(), view.sorted_vertices.end());
      view.facet = facet_id(CellId(c), i);
      facets.push_back(view);
    }
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

// Behind every facet that occurs once: a cell with the same triangle and the vertex at infinity.
std::vector<CellVertices> infinite_cells(const std::vector<CellVertices>& cells) {
  const std::vector<FacetView> facets = sorted_facets(cells);
  std::vector<CellVertices> result;
  for (std::size_t i = 0; i < facets.size();) {
    const bool paired =
        i + 1 < facets.size() && facets[i].sorted_vertices == facets[i + 1].sorted_vertices;
    if (!paired) {
      // The corners with their normal out of the finite cell: a point beyond sees them so that
      // orient3d(v0, v1, v2, beyond) > 0, which is the rule for infinite cells.
      const CellVertices& cell = cells[cell_of(facets[i].facet).index()];
      const int* corner = facet_corners[index_of(facets[i].facet)];
      result.push_back({cell[static_cast<std::size_t>(corner[0])],
                        cell[static_cast<std::size_t>(corner[1])],
                        cell[static_cast<std::size_t>(corner[2])], infinite_vertex});
    }
    i += paired ? 2 : 1;
  }
  return result;
}

void canonicalize(std::vector<CellVertices>& cells) {
  for (CellVertices& cell : cells) make_canonical(cell);
  std::sort(cells.begin(), cells.end());
}

}  // namespace

DistinctPoints distinct_points(Points points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_finite(points[i])) continue;
    throw InputError("point " + std::to_string(i) +
                     " (counted from 0) has a coordinate that is not finite: remove or repair it");
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    if (points[i] != points[j]) return points[i] < points[j];
    return i < j;
  });
  DistinctPoints result;
  result.vertex_of_point.resize(points.size());
  for (const std::size_t i : order) {
    const bool is_new = result.points.empty() || *(result.points.end() - 1) != points[i];
    if (is_new) result.points.push_back(points[i]);
    result.vertex_of_point[PointId(i)] = VertexId(result.points.size() - 1);
  }
  if (result.points.size() < 4) {
    throw InputError("only " + counted(result.points.size(), "different point") +
                     ": a triangulation of space needs at least 4");
  }
  return result;
}

Triangulation triangulation_of_cells(DistinctPoints distinct, std::vector<CellVertices> cells) {
  // Finite cells first, then the infinite ones, each part in canonical order.
  canonicalize(cells);
  const std::size_t num_finite = cells.size();
  std::vector<CellVertices> infinite = infinite_cells(cells);
  canonicalize(infinite);
  cells.insert(cells.end(), infinite.begin(), infinite.end());

  // Every facet now occurs exactly twice: those two views are each other's neighbor.
  IdVector<CellId, Cell> records;
  records.reserve(cells.size());
  for (const CellVertices& vertices : cells) records.push_back({vertices, {}});
  const std::vector<FacetView> facets = sorted_facets(cells);
  const auto link = [&](FacetId from, FacetId to) {
    records[cell_of(from)].neighbors[static_cast<std::size_t>(index_of(from))] = to;
  };
  const auto are_same = [&](std::size_t i, std::size_t k) {
    return k < facets.size() && facets[i].sorted_vertices == facets[k].sorted_vertices;
  };
  for (std::size_t i = 0; i < facets.size(); i += 2) {
    if (!are_same(i, i + 1) || are_same(i, i + 2)) {
      throw InputError("cell " + std::to_string(cell_of(facets[i].facet).value) +
                       " has a facet that does not belong to exactly two cells");
    }
    link(facets[i].facet, facets[i + 1].facet);
    link(facets[i + 1].facet, facets[i].facet);
  }
  return Triangulation(
      {std::move(distinct.points), std::move(records), std::move(distinct.vertex_of_point)},
      num_finite);
}

}  // namespace cocoon::ref
