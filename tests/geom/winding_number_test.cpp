#include "geom/winding_number.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/random.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// The sum of the solid angles, which knows nothing of rays.
double winding_by_angles(const TriangleMesh& mesh, const Point& p) {
  double sum = 0;
  for (const TriangleId t : mesh.triangles.ids()) {
    const auto [x, y, z] = corners_of(mesh, t);
    const Vec3 a = x - p;
    const Vec3 b = y - p;
    const Vec3 c = z - p;
    const double la = norm(a);
    const double lb = norm(b);
    const double lc = norm(c);
    sum += 2 * std::atan2(dot(a, cross(b, c)),
                          la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.points.size());
  for (const Point& p : b.points) a.points.push_back(p);
  for (const auto& [u, v, w] : b.triangles) {
    a.triangles.push_back(
        {VertexId(u.value + first), VertexId(v.value + first), VertexId(w.value + first)});
  }
  return a;
}

TriangleMesh scaled(TriangleMesh mesh, double factor, const Vec3& offset) {
  for (Point& p : mesh.points) p = factor * p + offset;
  return mesh;
}

void turn_over(TriangleMesh& mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
}

// Rays through corners, along edges and diagonals, in planes of facets.
TEST(WindingNumber, RaysThroughEdgesAndCornersOfACubeAreExact) {
  const WindingNumbers numbers(gallery::cube());  // [0, 1]^3
  for (int i = -4; i <= 8; ++i) {
    for (int j = -4; j <= 8; ++j) {
      for (int k = -4; k <= 8; ++k) {
        const bool inside = i > 0 && i < 4 && j > 0 && j < 4 && k > 0 && k < 4;
        const bool outside = i < 0 || i > 4 || j < 0 || j > 4 || k < 0 || k > 4;
        if (!inside && !outside) continue;  // on the surface
        EXPECT_EQ(numbers.at({0.25 * i, 0.25 * j, 0.25 * k}), inside ? 1 : 0)
            << i << " " << j << " " << k;
      }
    }
  }
}

TEST(WindingNumber, AgreesWithTheSumOfSolidAngles) {
  Random random(11);
  // A cube with a cavity that holds a tetrahedron, and another body that overlaps it.
  TriangleMesh cavity = scaled(gallery::cube(), 0.5, {0.25, 0.25, 0.25});
  turn_over(cavity);
  TriangleMesh mesh = joined(gallery::cube(), cavity);
  mesh = joined(std::move(mesh), scaled(gallery::tetrahedron(), 0.2, {0.4, 0.4, 0.4}));
  mesh = joined(std::move(mesh), scaled(gallery::cube(), 0.4, {0.8, 0.1, 0.1}));
  for (Point& p : mesh.points) {
    p = p +
        Vec3{random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
  }
  const WindingNumbers numbers(mesh);
  std::vector<std::size_t> seen(3);
  for (int i = 0; i < 5000; ++i) {
    const Point p{random.uniform(-0.2, 1.4), random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2)};
    const int number = numbers.at(p);
    EXPECT_NEAR(winding_by_angles(mesh, p), number, 1e-6);
    ASSERT_GE(number, 0);
    ASSERT_LE(number, 2);
    ++seen[static_cast<std::size_t>(number)];
  }
  for (const std::size_t count : seen) EXPECT_GT(count, 10U);
}

TEST(WindingNumber, InsideOfAMeshTurnedOverItIsNegative) {
  TriangleMesh cube = gallery::cube();
  turn_over(cube);
  EXPECT_EQ(WindingNumbers(cube).at({0.5, 0.5, 0.5}), -1);
  EXPECT_EQ(WindingNumbers(cube).at({0.5, 0.5, 1.5}), 0);
}

TEST(WindingNumber, OfNothingIsZero) { EXPECT_EQ(WindingNumbers(TriangleMesh()).at({0, 0, 0}), 0); }

TEST(WindingNumber, BadMeshesAreErrors) {
  TriangleMesh mesh = gallery::cube();
  mesh.points[VertexId(2)].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(WindingNumbers{mesh}, InputError);
  mesh = gallery::cube();
  mesh.triangles[TriangleId(0)][1] = VertexId(99);
  EXPECT_THROW(WindingNumbers{mesh}, InputError);
}

}  // namespace
}  // namespace cocoon
