#include "geom/self_intersection.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "geom/orient3d.h"
#include "geom/search/box_tree.h"

namespace cocoon {
namespace {

using Corners = std::array<Point, 3>;

Sign orient2d_without(int axis, const Point& a, const Point& b, const Point& c) {
  switch (axis) {
    case 0:
      return orient2d(a.y, a.z, b.y, b.z, c.y, c.z);
    case 1:
      return orient2d(a.z, a.x, b.z, b.x, c.z, c.x);
    default:
      return orient2d(a.x, a.y, b.x, b.y, c.x, c.y);
  }
}

// The axis to drop so that the triangle keeps an area: exact, so there is one.
int axis_to_drop(const Corners& t) {
  for (int axis = 0; axis < 2; ++axis) {
    if (orient2d_without(axis, t[0], t[1], t[2]) != Sign::zero) return axis;
  }
  return 2;
}

bool all_equal_or_zero(Sign a, Sign b, Sign c) {
  const bool has_positive = a == Sign::positive || b == Sign::positive || c == Sign::positive;
  const bool has_negative = a == Sign::negative || b == Sign::negative || c == Sign::negative;
  return !(has_positive && has_negative);
}

bool all_strictly_equal(Sign a, Sign b, Sign c) { return a != Sign::zero && a == b && b == c; }

// For p, a, b on one line of space: is p between a and b, ends included? The lexicographic order of
// coordinates is an order along the line.
bool between(const Point& p, const Point& a, const Point& b) {
  const Point& low = (b <=> a) < 0 ? b : a;
  const Point& high = (b <=> a) < 0 ? a : b;
  return (low <=> p) <= 0 && (p <=> high) <= 0;
}

// Closed segments in one plane, which stays a plane without `axis`.
bool coplanar_segments_meet(int axis, const Point& p, const Point& q, const Point& a,
                            const Point& b) {
  const Sign pa = orient2d_without(axis, p, q, a);
  const Sign pb = orient2d_without(axis, p, q, b);
  const Sign ap = orient2d_without(axis, a, b, p);
  const Sign aq = orient2d_without(axis, a, b, q);
  if (pa == -pb && ap == -aq && pa != Sign::zero && ap != Sign::zero) return true;
  return (pa == Sign::zero && between(a, p, q)) || (pb == Sign::zero && between(b, p, q)) ||
         (ap == Sign::zero && between(p, a, b)) || (aq == Sign::zero && between(q, a, b));
}

bool coplanar_point_in_triangle(int axis, const Point& p, const Corners& t) {
  return all_equal_or_zero(orient2d_without(axis, t[0], t[1], p),
                           orient2d_without(axis, t[1], t[2], p),
                           orient2d_without(axis, t[2], t[0], p));
}

bool coplanar_segment_meets_triangle(const Point& p, const Point& q, const Corners& t) {
  const int axis = axis_to_drop(t);
  return coplanar_point_in_triangle(axis, p, t) || coplanar_segments_meet(axis, p, q, t[0], t[1]) ||
         coplanar_segments_meet(axis, p, q, t[1], t[2]) ||
         coplanar_segments_meet(axis, p, q, t[2], t[0]);
}

// Closed segment pq and closed triangle t.
bool segment_meets_triangle(const Point& p, const Point& q, const Corners& t) {
  const Sign side_p = orient3d(t[0], t[1], t[2], p);
  const Sign side_q = orient3d(t[0], t[1], t[2], q);
  if (side_p == Sign::zero && side_q == Sign::zero) return coplanar_segment_meets_triangle(p, q, t);
  if (side_p == side_q) return false;
  // The line crosses the plane in one point of the segment: it passes the triangle's edges on the
  // same hand iff that point is in the triangle.
  return all_equal_or_zero(orient3d(p, q, t[0], t[1]), orient3d(p, q, t[1], t[2]),
                           orient3d(p, q, t[2], t[0]));
}

// Rotates the corners so that those equal to a corner of `other` come first; returns their number.
int shared_corners_first(Corners& t, const Corners& other) {
  const auto shared_end = std::stable_partition(t.begin(), t.end(), [&other](const Point& p) {
    return std::find(other.begin(), other.end(), p) != other.end();
  });
  return static_cast<int>(shared_end - t.begin());
}

// Is one triangle folded onto the other about their common edge s[0] s[1]?
bool folded_about_edge(const Corners& s, const Point& other_apex) {
  if (orient3d(s[0], s[1], s[2], other_apex) != Sign::zero) return false;
  const int axis = axis_to_drop(s);
  return orient2d_without(axis, s[0], s[1], s[2]) == orient2d_without(axis, s[0], s[1], other_apex);
}

// True if the plane of s has all of t strictly on one side.
bool plane_separates(const Corners& s, const Corners& t) {
  return all_strictly_equal(orient3d(s[0], s[1], s[2], t[0]), orient3d(s[0], s[1], s[2], t[1]),
                            orient3d(s[0], s[1], s[2], t[2]));
}

bool disjoint_corners_intersect(const Corners& a, const Corners& b) {
  if (plane_separates(a, b) || plane_separates(b, a)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets_triangle(a[i], a[(i + 1) % 3], b)) return true;
    if (segment_meets_triangle(b[i], b[(i + 1) % 3], a)) return true;
  }
  return false;
}

struct ChunkResult {
  std::size_t tested = 0;
  std::size_t intersecting = 0;
  std::vector<std::array<TriangleId, 2>> pairs;  // the first ones
};

}  // namespace

bool triangles_intersect(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
  Corners s = a;
  Corners t = b;
  const int shared = shared_corners_first(s, t);
  shared_corners_first(t, s);
  switch (shared) {
    case 0:
      return disjoint_corners_intersect(s, t);
    case 1:
      // Both are convex: if they meet in another point, then on the whole way from the shared
      // corner to it, and the farthest such point lies on one of the opposite edges.
      return segment_meets_triangle(s[1], s[2], t) || segment_meets_triangle(t[1], t[2], s);
    case 2:
      return folded_about_edge(s, t[2]);
    default:
      return true;
  }
}

SelfIntersections self_intersection(const TriangleMesh& mesh,
                                    const SelfIntersectionOptions& options,
                                    const Execution& execution) {
  report_progress(execution, "self_intersection", 0);
  SelfIntersections result;
  // 1. Boxes of the triangles that have an area.
  std::vector<TriangleId> ids;
  std::vector<Corners> corners;
  std::vector<Box> boxes;
  for (const TriangleId t : mesh.triangles.ids()) {
    const Corners c = finite_corners_of(mesh, t);
    if (are_collinear(c[0], c[1], c[2])) {
      ++result.zero_area_triangles;
      continue;
    }
    ids.push_back(t);
    corners.push_back(c);
    boxes.push_back(box_of(c));
  }
  const BoxTree tree(boxes);

  // 2. Test each triangle against those of larger id near it.
  constexpr std::size_t grain = 1024;
  std::vector<ChunkResult> chunks((ids.size() + grain - 1) / grain);
  std::vector<std::atomic<std::uint8_t>> in_a_pair(ids.size());
  const StagePart part{"self_intersection"};
  parallel_chunks(execution, part, ids.size(), grain, [&](std::size_t begin, std::size_t end) {
    ChunkResult& chunk = chunks[begin / grain];
    std::vector<TriangleId> met;
    for (std::size_t i = begin; i < end; ++i) {
      met.clear();
      tree.visit_overlapping(boxes[i], [&](std::uint32_t slot) {
        const std::size_t j = tree.items()[slot];
        if (j <= i || !overlap(boxes[i], boxes[j])) return;
        ++chunk.tested;
        if (!triangles_intersect(corners[i], corners[j])) return;
        met.push_back(ids[j]);
        in_a_pair[j].store(1, std::memory_order_relaxed);
      });
      if (!met.empty()) in_a_pair[i].store(1, std::memory_order_relaxed);
      chunk.intersecting += met.size();
      std::sort(met.begin(), met.end());
      met.resize(std::min(met.size(), options.max_pairs - chunk.pairs.size()));
      for (const TriangleId other : met) chunk.pairs.push_back({ids[i], other});
    }
  });

  // 3. Chunks run in the order of ids, so that their lists in a row are sorted.
  for (const ChunkResult& chunk : chunks) {
    result.tested_pairs += chunk.tested;
    result.count += chunk.intersecting;
    for (const auto& pair : chunk.pairs) {
      if (result.pairs.size() < options.max_pairs) result.pairs.push_back(pair);
    }
  }
  result.intersecting_triangles =
      static_cast<std::size_t>(std::count(in_a_pair.begin(), in_a_pair.end(), 1));
  report_progress(execution, "self_intersection", 1);
  return result;
}

}  // namespace cocoon
