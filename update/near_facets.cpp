#include "update/near_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geom/triangle_projection.h"

namespace cocoon {

namespace {

// A closest point computed on a triangle may lie outside its box by rounding: boxes grow by this
// share of the largest coordinate.
constexpr double box_slack = 0x1p-44;

std::array<Point, 3> corners_of(const TriangleMesh& mesh, TriangleId t) {
  const Triangle& corners = mesh.triangles[t];
  return {mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]};
}

std::array<Point, 3> sorted_corners(const TriangleMesh& mesh, TriangleId t) {
  std::array<Point, 3> corners = corners_of(mesh, t);
  std::sort(corners.begin(), corners.end());
  return corners;
}

double largest_coordinate(const Box& box) {
  double largest = 0;
  for (const Point& p : {box.low, box.high}) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

Box grown(const Point& p, double by) {
  Box box;
  box.include(p);
  box.enlarge(by);
  return box;
}

// Space in cells at least as wide as the reach; those within reach of a center are marked.
class ReachedCells {
 public:
  ReachedCells(Points centers, double reach) : extent_(box_of(centers)) {
    extent_.enlarge(reach);
    const Vec3 size = extent_.size();
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double cells =
          size[axis] > reach ? std::clamp(std::floor(size[axis] / reach), 1.0, max_cells) : 1;
      counts_[i] = static_cast<std::size_t>(cells);
      per_length_[i] = size[axis] > 0 ? cells / size[axis] : 0;
    }
    reached_.assign(counts_[0] * counts_[1] * counts_[2], 0);
    for (const Point& p : centers) {
      visit(grown(p, reach), [&](std::uint8_t& cell) {
        cell = 1;
        return true;
      });
    }
  }

  // The box of all marked cells.
  const Box& extent() const { return extent_; }

  bool overlap(const Box& box) {
    return cocoon::overlap(box, extent_) &&
           !visit(box, [](std::uint8_t cell) { return cell == 0; });
  }

 private:
  static constexpr double max_cells = 64;  // along each axis

  // Calls visit(cell) for the cells that overlap the box until it returns false.
  template <class Visit>
  bool visit(const Box& box, const Visit& visit) {
    std::array<std::size_t, 3> low;
    std::array<std::size_t, 3> high;
    for (int axis = 0; axis < 3; ++axis) {
      low[static_cast<std::size_t>(axis)] = cell_of(box.low, axis);
      high[static_cast<std::size_t>(axis)] = cell_of(box.high, axis);
    }
    for (std::size_t z = low[2]; z <= high[2]; ++z) {
      for (std::size_t y = low[1]; y <= high[1]; ++y) {
        for (std::size_t x = low[0]; x <= high[0]; ++x) {
          if (!visit(reached_[(z * counts_[1] + y) * counts_[0] + x])) return false;
        }
      }
    }
    return true;
  }

  // Monotone in the coordinate, so that no rounding separates what overlaps.
  std::size_t cell_of(const Point& p, int axis) const {
    const auto i = static_cast<std::size_t>(axis);
    const double last = static_cast<double>(counts_[i] - 1);
    return static_cast<std::size_t>(
        std::clamp((p[axis] - extent_.low[axis]) * per_length_[i], 0.0, last));
  }

  Box extent_;
  std::array<std::size_t, 3> counts_{};
  std::array<double, 3> per_length_{};
  std::vector<std::uint8_t> reached_;
};

// On which sides of the box a point lies, one bit for each: a triangle whose corners share a bit
// does not meet the box (Cohen and Sutherland's clipping).
std::uint8_t sides_of(const Box& box, const Point& p) {
  const int sides = (p.x < box.low.x ? 1 : 0) | (p.x > box.high.x ? 2 : 0) |
                    (p.y < box.low.y ? 4 : 0) | (p.y > box.high.y ? 8 : 0) |
                    (p.z < box.low.z ? 16 : 0) | (p.z > box.high.z ? 32 : 0);
  return static_cast<std::uint8_t>(sides);
}

std::vector<TriangleId> all_facets(const TriangleMesh& mesh) {
  std::vector<TriangleId> facets;
  facets.reserve(mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) facets.push_back(t);
  return facets;
}

std::vector<TriangleId> facets_near(const TriangleMesh& mesh, Points centers, double reach) {
  if (centers.empty()) return {};
  const double room = reach + box_slack * (largest_coordinate(box_of(centers)) + 4 * reach);
  if (!std::isfinite(room)) return all_facets(mesh);
  ReachedCells cells(centers, room);
  std::vector<std::uint8_t> sides;
  sides.reserve(mesh.points.size());
  for (const Point& p : mesh.points) sides.push_back(sides_of(cells.extent(), p));
  std::vector<TriangleId> facets;
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto& [a, b, c] = mesh.triangles[t];
    if ((sides[a.index()] & sides[b.index()] & sides[c.index()]) != 0) continue;
    if (cells.overlap(box_of(corners_of(mesh, t)))) facets.push_back(t);
  }
  return facets;
}

BoxTree tree_of(const TriangleMesh& mesh, const std::vector<TriangleId>& facets) {
  std::vector<Box> boxes;
  boxes.reserve(facets.size());
  Box all;
  for (const TriangleId t : facets) {
    boxes.push_back(box_of(corners_of(mesh, t)));
    all.include(boxes.back());
  }
  const double slack = facets.empty() ? 0 : box_slack * largest_coordinate(all);
  for (Box& box : boxes) box.enlarge(slack);
  return BoxTree(boxes);
}

}  // namespace

NearFacets::NearFacets(const TriangleMesh& mesh, Points centers, double reach)
    : mesh_(&mesh),
      reach_(reach),
      facets_(facets_near(mesh, centers, reach)),
      tree_(tree_of(mesh, facets_)) {}

void NearFacets::improve(const Point& p, TriangleId t, ClosestFacet& best) const {
  const ClosestPoint foot = closest_point_on_triangle(p, corners_of(*mesh_, t));
  const double squared = foot.squared_distance;
  if (squared > best.squared_distance) return;
  if (squared == best.squared_distance && !best.triangle.is_none()) {
    const auto own = sorted_corners(*mesh_, t);
    const auto others = sorted_corners(*mesh_, best.triangle);
    if (own > others || (own == others && t > best.triangle)) return;
  }
  best = {t, foot.point, squared};
}

}  // namespace cocoon
