#include "io/models/polygonize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geom/errors.h"

namespace cocoon {
namespace {

using GridId = std::uint32_t;

// A vertex of the mesh lies on an edge of the grid from an inside to an outside corner.
struct Crossing {
  GridId inside;
  GridId outside;
  friend auto operator<=>(const Crossing&, const Crossing&) = default;
};
using CrossingTriangle = std::array<Crossing, 3>;

// Grid points are looked at in blocks of block^3. Where the function at the middle of one is larger
// than what it can change within the block at this steepness, it keeps its sign in all of it.
constexpr GridId block = 4;
constexpr double largest_steepness = 2;

class Grid {
 public:
  Grid(const ImplicitSolid& solid, double cell) : origin_(solid.box.low), cell_(cell) {
    if (!(cell > 0)) throw InputError("grid cell must be positive; give its side length");
    double total = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = std::ceil(solid.box.size()[axis] / cell);
      total *= cells + 1;
      if (!(total < 0x1p31)) throw InputError("grid cell is too small; give a larger one");
      count_[static_cast<std::size_t>(axis)] = static_cast<GridId>(cells) + 1;
    }
    values_.resize(static_cast<std::size_t>(total));
    for (GridId z = 0; z < count_[2]; z += block) {
      for (GridId y = 0; y < count_[1]; y += block) {
        for (GridId x = 0; x < count_[0]; x += block) fill_block(solid, x, y, z);
      }
    }
  }

  const std::array<GridId, 3>& count() const { return count_; }
  GridId id(GridId x, GridId y, GridId z) const { return x + count_[0] * (y + count_[1] * z); }
  bool is_inside(GridId id) const { return values_[id] < 0; }
  Point position(GridId id) const {
    const GridId x = id % count_[0];
    const GridId y = id / count_[0] % count_[1];
    const GridId z = id / count_[0] / count_[1];
    return origin_ +
           cell_ * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
  // Where the function changes sign on the edge, if it were linear. Kept off the ends, where many
  // edges meet: the vertices of a small triangle would coincide.
  Point crossing(const Crossing& edge) const {
    const double inside = values_[edge.inside];
    const double t = std::clamp(inside / (inside - values_[edge.outside]), 0.15, 0.85);
    return (1 - t) * position(edge.inside) + t * position(edge.outside);
  }

 private:
  void fill_block(const ImplicitSolid& solid, GridId x0, GridId y0, GridId z0) {
    const double half = 0.5 * (block - 1) * cell_;
    const double at_middle = solid.value(position(id(x0, y0, z0)) + Vec3{half, half, half});
    const bool far = std::abs(at_middle) > largest_steepness * std::sqrt(3.0) * half;
    for (GridId z = z0; z < std::min(z0 + block, count_[2]); ++z) {
      for (GridId y = y0; y < std::min(y0 + block, count_[1]); ++y) {
        for (GridId x = x0; x < std::min(x0 + block, count_[0]); ++x) {
          values_[id(x, y, z)] = far ? at_middle : solid.value(position(id(x, y, z)));
          if (is_inside(id(x, y, z)) && on_border(x, y, z)) {
            throw InputError("solid reaches the border of its box; give it a larger box");
          }
        }
      }
    }
  }
  bool on_border(GridId x, GridId y, GridId z) const {
    return x == 0 || y == 0 || z == 0 || x + 1 == count_[0] || y + 1 == count_[1] ||
           z + 1 == count_[2];
  }

  Point origin_;
  double cell_;
  std::array<GridId, 3> count_ = {};
  std::vector<double> values_;
};

// The six tetrahedra of a cube, corner k at offset (k & 1, k & 2, k & 4): all around the diagonal
// from 0 to 7, each with positive orientation.
constexpr std::array<std::array<std::size_t, 4>, 6> tetrahedra_of_cube = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

// Appends the triangles of one tetrahedron of positive orientation, seen from outside the solid.
void cut_tetrahedron(const Grid& grid, std::array<GridId, 4> t,
                     std::vector<CrossingTriangle>& triangles) {
  // Inside corners first; each exchange of two corners turns the tetrahedron over.
  bool turned = false;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 3; j > i; --j) {
      if (!grid.is_inside(t[j - 1]) && grid.is_inside(t[j])) {
        std::swap(t[j - 1], t[j]);
        turned = !turned;
      }
    }
  }
  const auto add = [&](const Crossing& a, const Crossing& b, const Crossing& c) {
    triangles.push_back(turned ? CrossingTriangle{a, c, b} : CrossingTriangle{a, b, c});
  };
  const auto inside =
      std::count_if(t.begin(), t.end(), [&](GridId g) { return grid.is_inside(g); });
  if (inside == 1) {
    add({t[0], t[1]}, {t[0], t[2]}, {t[0], t[3]});
  } else if (inside == 3) {
    add({t[0], t[3]}, {t[1], t[3]}, {t[2], t[3]});
  } else if (inside == 2) {
    add({t[0], t[2]}, {t[0], t[3]}, {t[1], t[3]});
    add({t[0], t[2]}, {t[1], t[3]}, {t[1], t[2]});
  }
}

std::vector<CrossingTriangle> cut_cubes(const Grid& grid) {
  std::vector<CrossingTriangle> triangles;
  const auto& count = grid.count();
  for (GridId z = 0; z + 1 < count[2]; ++z) {
    for (GridId y = 0; y + 1 < count[1]; ++y) {
      for (GridId x = 0; x + 1 < count[0]; ++x) {
        std::array<GridId, 8> corner;
        std::size_t inside = 0;
        for (GridId k = 0; k < 8; ++k) {
          corner[k] = grid.id(x + (k & 1U), y + (k >> 1 & 1U), z + (k >> 2));
          inside += grid.is_inside(corner[k]) ? 1 : 0;
        }
        if (inside == 0 || inside == 8) continue;
        for (const auto& [a, b, c, d] : tetrahedra_of_cube) {
          cut_tetrahedron(grid, {corner[a], corner[b], corner[c], corner[d]}, triangles);
        }
      }
    }
  }
  return triangles;
}

}  // namespace

TriangleMesh polygonize(const ImplicitSolid& solid, double cell) {
  const Grid grid(solid, cell);
  const std::vector<CrossingTriangle> triangles = cut_cubes(grid);
  std::vector<Crossing> crossings;
  for (const CrossingTriangle& t : triangles) crossings.insert(crossings.end(), t.begin(), t.end());
  std::sort(crossings.begin(), crossings.end());
  crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());

  TriangleMesh mesh;
  const double step = cell / 64;
  for (const Crossing& crossing : crossings) {
    mesh.points.push_back(project_to_surface(solid.value, grid.crossing(crossing), step));
  }
  const auto vertex = [&crossings](const Crossing& crossing) {
    const auto found = std::lower_bound(crossings.begin(), crossings.end(), crossing);
    return VertexId(static_cast<std::size_t>(found - crossings.begin()));
  };
  for (const CrossingTriangle& t : triangles) {
    mesh.triangles.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
  }
  return mesh;
}

}  // namespace cocoon
