#include "geom/search/winding_number.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

using gallery::flipped;
using gallery::join;
using gallery::scaled;
using gallery::translated;

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

// Rays through the tip of an octahedron and along its edges, which seen along the rays are upright
// or level: the shift in y decides of the one, that in z of the other.
TEST(WindingNumber, RaysThroughEdgesAndCornersOfAnOctahedronAreExact) {
  const WindingNumbers numbers(gallery::make_mesh(
      {{3, 0, 0}, {-3, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, 3}, {0, 0, -3}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}));
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      for (int k = -8; k <= 8; ++k) {
        const double size = 0.5 * (std::abs(i) + std::abs(j) + std::abs(k));
        if (size == 3) continue;  // on the surface
        EXPECT_EQ(numbers.at({0.5 * i, 0.5 * j, 0.5 * k}), size < 3 ? 1 : 0)
            << i << " " << j << " " << k;
      }
    }
  }
}

TEST(WindingNumber, AgreesWithTheSumOfSolidAngles) {
  Random random(11);
  // A cube with a cavity that holds a tetrahedron, and another body that overlaps it.
  const TriangleMesh cavity = flipped(translated(gallery::cube(0.5), {0.25, 0.25, 0.25}));
  TriangleMesh mesh = join(gallery::cube(), cavity);
  mesh = join(mesh, translated(scaled(gallery::tetrahedron(), 0.2), {0.4, 0.4, 0.4}));
  mesh = join(mesh, translated(gallery::cube(0.4), {0.8, 0.1, 0.1}));
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
  const TriangleMesh cube = flipped(gallery::cube());
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
