// A slab in which a pocket with sharp edges was cut, and scans of the pocket.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/reconstruct.h"
#include "geom/random/random.h"
#include "geom/triangle_mesh.h"
#include "tests/end_to_end/boxy_part.h"
#include "update/update_model.h"

namespace cocoon::testing {

struct SlabWithPocket {
  static constexpr double least = 0.5;  // between samples

  Random random;
  BoxyPart part = {{25, 18, 9}, [](int x, int y, int z) { return !is_pocket(x, y, z); }};
  TriangleMesh after = surface_of(part);
  TriangleMesh model;  // without the pocket

  explicit SlabWithPocket(std::uint64_t seed) : random(seed) {
    const TriangleMesh before = surface_of({{25, 18, 9}, [](int, int, int) { return true; }});
    const auto all = [](TriangleId) { return true; };
    model = reconstruct_tight(scan_of_mesh(before, least, random, all)).mesh;
  }

  // The pocket and the slab around it, wherever the scanner stands.
  std::vector<Point> scan() {
    return scan_of_mesh(after, least, random, [&](TriangleId t) {
      const Point& p = after.points[after.triangles[t][0]];
      return p.z > 3.5 && p.x > 4 && p.x < 21 && p.y > 1 && p.y < 17;
    });
  }

  // What of it is seen from far away in the direction `towards`, at a slant of 80 degrees at most.
  std::vector<Point> view(const Vec3& towards) {
    constexpr double least_cosine = 0.17;
    const Vec3 ray = unit(towards);
    std::vector<Point> seen;
    const std::vector<Point> samples = scan_of_mesh(after, least, random, [&](TriangleId t) {
      const auto& [a, b, c] = after.triangles[t];
      const Point& p = after.points[a];
      const Vec3 normal = unit(cross(after.points[b] - p, after.points[c] - p));
      return p.z > 3.5 && p.x > 4 && p.x < 21 && p.y > 1 && p.y < 17 &&
             dot(normal, ray) > least_cosine;
    });
    for (const Point& p : samples) {
      if (!is_hidden(p, ray)) seen.push_back(p);
    }
    return seen;
  }

  static bool in_pocket(const Point& p) {
    return p.z > 8.9 && p.x > 8.5 && p.x < 16.5 && p.y > 5.5 && p.y < 12.5;
  }
  static bool is_far(const Point& p) {
    return p.z < 7 || p.x < 2.5 || p.x > 22.5 || p.y == 0 || p.y == 18;
  }
  std::size_t left_over(const UpdateResult& result) const {
    std::size_t count = 0;
    for (const VertexId v : model.points.ids()) {
      count += in_pocket(model.points[v]) && !result.vertex_map[v].is_none() ? 1U : 0U;
    }
    return count;
  }

 private:
  static bool is_pocket(int x, int y, int z) {
    return 8 <= x && x < 17 && 5 <= y && y < 13 && z >= 4;
  }
  bool is_hidden(const Point& p, const Vec3& ray) const {
    for (double t = 0.05; t < 20; t += 0.05) {
      const Point q = p + t * ray;
      if (part.has({static_cast<int>(std::floor(q.x)), static_cast<int>(std::floor(q.y)),
                    static_cast<int>(std::floor(q.z))})) {
        return true;
      }
    }
    return false;
  }
};

}  // namespace cocoon::testing
