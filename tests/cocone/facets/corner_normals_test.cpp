// Normals of many triangles at once are those of one by one, to the bit.
#include "cocone/facets/corner_normals.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "geom/random/random.h"

namespace cocoon {
namespace {

// The definition.
Vec3 corner_normal(const IdVector<VertexId, Point>& points, const Triangle& corners) {
  std::vector<Point> p = {points[corners[0]], points[corners[1]], points[corners[2]]};
  double sign = 1;
  for (const std::size_t i : {0U, 1U, 0U}) {
    if (!(p[i + 1] < p[i])) continue;
    std::swap(p[i], p[i + 1]);
    sign = -sign;
  }
  return sign * unit(cross(p[1] - p[0], p[2] - p[0]));
}

TEST(CornerNormals, AreThoseOfEachTriangle) {
  Random random(1);
  for (const double scale :
       {1.0, 0x1p-300, 0x1p+500, 0x1p+513, 0x1p+520}) {  // the last ones overflow
    IdVector<VertexId, Point> points;
    for (int i = 0; i < 40; ++i) points.push_back(scale * random.in_unit_cube());
    for (const std::size_t count : {1U, 2U, 7U, 8U, 100U}) {
      std::vector<Triangle> triangles(count);
      for (Triangle& t : triangles) {
        for (VertexId& v : t) v = VertexId(std::size_t{random.below(40)});  // equal ones, too
      }
      const std::size_t begin = count / 3;
      std::vector<Vec3> normals(count, Vec3{7, 7, 7});
      corner_normals(points, triangles, begin, count, normals);
      for (std::size_t t = 0; t < count; ++t) {
        EXPECT_EQ(normals[t], t < begin ? (Vec3{7, 7, 7}) : corner_normal(points, triangles[t]));
      }
    }
  }
}

}  // namespace
}  // namespace cocoon
