#include "update/checks/patch_handles.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "geom/box.h"
#include "geom/errors.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

constexpr double any_length = 1e9;

std::size_t handles(const TriangleMesh& mesh, VertexId first_new, double max_length = any_length) {
  const std::vector<double> lengths =
      patch_handles(mesh.points.span(), mesh.triangles.span(), first_new);
  return static_cast<std::size_t>(
      std::count_if(lengths.begin(), lengths.end(), [&](double x) { return x <= max_length; }));
}

TEST(PatchHandles, AreCountedByTheirWayAround) {
  const TriangleMesh torus = gallery::torus(24, 12);
  EXPECT_EQ(handles(gallery::cube(), VertexId(0U)), 0U);
  EXPECT_EQ(handles(torus, VertexId(0U)), 1U);
  EXPECT_EQ(handles(gallery::join(torus, torus), VertexId(0U)), 2U);
  // The shorter of both ways.
  double shortest = any_length;
  for (double length = 1e-3; length < 100; length *= 1.05) {
    if (handles(torus, VertexId(0U), length) == 0) continue;
    shortest = length;
    break;
  }
  const Vec3 size = box_of(torus.points.span()).size();
  const double height = std::min({size.x, size.y, size.z});
  EXPECT_GT(shortest, 2 * height);
  EXPECT_LT(shortest, 4 * height);
}

// A piece of it is a tube, open at two places.
TEST(PatchHandles, ThroughOldVerticesAreNone) {
  const TriangleMesh torus = gallery::torus(24, 12);
  EXPECT_EQ(handles(torus, VertexId(torus.points.size() / 2)), 0U);
  EXPECT_EQ(handles(torus, VertexId(torus.points.size())), 0U);
  // Old vertices that leave a disk out do not matter.
  EXPECT_EQ(handles(torus, VertexId(1U)), 1U);
}

TEST(PatchHandles, OfPartsThatTouchAreThoseOfEach) {
  const TriangleMesh two = gallery::two_tetrahedra_sharing_a_vertex();
  EXPECT_EQ(handles(two, VertexId(0U)), 0U);
  TriangleMesh pair = gallery::join(gallery::torus(24, 12), gallery::torus(24, 12));
  const VertexId first_of_second(pair.points.size() / 2);
  for (Triangle& t : pair.triangles) {
    for (VertexId& v : t) {
      if (v == first_of_second) v = VertexId(0U);
    }
  }
  EXPECT_EQ(handles(pair, VertexId(0U)), 2U);
}

TEST(PatchHandles, RefusesVerticesThatAreNotThere) {
  const TriangleMesh cube = gallery::cube();
  EXPECT_THROW(patch_handles(cube.points.span().first(4), cube.triangles.span(), VertexId(0U)),
               InputError);
}

}  // namespace
}  // namespace cocoon
