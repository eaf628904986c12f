// The verification accepts what the stages make, and each of its tests refutes what it is there
// for.
#include "cocone/checks/verify_surface.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cocone/reconstruct.h"
#include "delaunay/canonical_order.h"
#include "delaunay/delaunay.h"
#include "geom/errors.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// A tight surface with the triangulation that it came from.
struct Made {
  std::vector<Point> points;
  Triangulation triangulation;
  SurfaceMesh surface;

  SurfaceVerification verify(const VerifyOptions& options = {}) const {
    return verify_surface(triangulation, surface, points, options);
  }
};

Made made_of(std::vector<Point> points, const ReconstructOptions& options = {}) {
  Made made;
  made.points = std::move(points);
  made.triangulation = canonical_order(delaunay(made.points).triangulation);
  ReconstructResult result = reconstruct_tight(made.points, options);
  made.surface.mesh = std::move(result.mesh);
  made.surface.point_of_vertex = std::move(result.point_of_vertex);
  for (const PointId p : made.surface.point_of_vertex) {
    made.surface.triangulation_vertex.push_back(made.triangulation.vertex_of_point()[p]);
  }
  return made;
}

Made made_sphere() { return made_of(shapes::sphere(300, 1)); }

Triangulation with_cells(const Triangulation& triangulation, IdVector<CellId, Cell> cells) {
  return Triangulation({triangulation.points(), std::move(cells), triangulation.vertex_of_point()},
                       triangulation.num_finite_cells());
}

TEST(VerifySurface, AcceptsWhatTheStagesMake) {
  const Made made = made_sphere();
  const SurfaceVerification verification = made.verify();
  EXPECT_TRUE(verification.ok()) << verification.failure;
  EXPECT_EQ(verification.triangles, 2U * 300 - 4);
  EXPECT_EQ(verification.cells, made.triangulation.num_finite_cells());

  for (const double scale : {1.0, 0x1p400, 0x1p-400}) {
    std::vector<Point> points = gallery::displaced_torus(2000);
    points.push_back(points.front());
    for (Point& p : points) p = scale * p;
    const ReconstructResult tight = reconstruct_tight(points, {.verify = true});
    EXPECT_TRUE(tight.verification.ok()) << tight.verification.failure;
    const ReconstructResult open = reconstruct_cocone(points, {.verify = true});
    EXPECT_TRUE(open.verification.ok()) << open.verification.failure;
  }
  EXPECT_FALSE(reconstruct_tight(made.points).verification.done);
}

TEST(VerifySurface, RefutesATriangulationThatIsNotDelaunay) {
  // A point moved a little: the cells stay a triangulation, but not that of the points.
  Made made = made_sphere();
  TriangulationArrays arrays = Triangulation(made.triangulation).release();
  arrays.points[VertexId(17)] = 0.97 * arrays.points[VertexId(17)];
  made.triangulation = Triangulation(std::move(arrays), made.triangulation.num_finite_cells());
  EXPECT_NE(made.verify().failure.find("not Delaunay"), std::string::npos);
}

TEST(VerifySurface, RefutesDamagedCells) {
  const Made good = made_sphere();
  for (const VertexId bad : {VertexId(), VertexId(good.triangulation.num_vertices())}) {
    Made made = good;
    IdVector<CellId, Cell> cells = good.triangulation.cell_records();
    cells[CellId(5)].vertices[1] = bad;
    made.triangulation = with_cells(good.triangulation, cells);
    EXPECT_NE(made.verify().failure.find("not Delaunay"), std::string::npos);
  }
  Made made = good;
  IdVector<CellId, Cell> cells = good.triangulation.cell_records();
  std::swap(cells[CellId(5)].neighbors[0], cells[CellId(5)].neighbors[1]);
  made.triangulation = with_cells(good.triangulation, cells);
  EXPECT_NE(made.verify().failure.find("not Delaunay"), std::string::npos);
}

TEST(VerifySurface, RefutesASurfaceThatIsNoPartOfIt) {
  const Made good = made_sphere();
  {
    Made made = good;  // a triangle across the sphere
    made.surface.mesh.triangles[TriangleId(3)] = {VertexId(0), VertexId(150), VertexId(299)};
    const SurfaceVerification verification = made.verify();
    EXPECT_EQ(verification.strange_triangles, 1U);
    EXPECT_NE(verification.failure.find("no facets"), std::string::npos);
  }
  {
    Made made = good;  // the last bit of a coordinate
    Point& p = made.surface.mesh.points[VertexId(7)];
    p.x = std::nextafter(p.x, 2.0);
    EXPECT_EQ(made.verify().moved_vertices, 1U);
    EXPECT_FALSE(made.verify().ok());
  }
  {
    Made made = good;  // two vertices that name each other's points
    std::swap(made.surface.point_of_vertex[VertexId(7)], made.surface.point_of_vertex[VertexId(8)]);
    EXPECT_EQ(made.verify().moved_vertices, 2U);
  }
}

TEST(VerifySurface, RefutesASurfaceThatIsInsideOut) {
  Made made = made_sphere();
  for (Triangle& t : made.surface.mesh.triangles) std::swap(t[1], t[2]);
  const SurfaceVerification verification = made.verify();
  EXPECT_EQ(verification.unbalanced_edges, 0U);
  EXPECT_EQ(verification.turned_triangles, 2U * 300 - 4);
  EXPECT_NE(verification.failure.find("face its inside"), std::string::npos);
  EXPECT_TRUE(made.verify({.closed = false}).ok());
}

// Of two spheres, one in the other: the wall between them.
TEST(VerifySurface, EachPartIsToFaceAwayFromTheBody) {
  Made made = made_of(shapes::joined(shapes::sphere(1200, 3), shapes::sphere(500, 4, 0.4)),
                      {.keep_cavities = true});
  ASSERT_EQ(made.surface.mesh.triangles.size(), 2U * (1200 + 500 - 4));
  EXPECT_TRUE(made.verify().ok()) << made.verify().failure;
  for (Triangle& t : made.surface.mesh.triangles) {
    if (made.surface.point_of_vertex[t[0]].index() >= 1200) std::swap(t[1], t[2]);
  }
  EXPECT_EQ(made.verify().turned_triangles, 2U * 500 - 4);
}

// Stops at the first report of a stage after its begin.
class StopWithin : public Progress {
 public:
  explicit StopWithin(std::string stage) : stage_(std::move(stage)) {}
  bool report(std::string_view stage, double fraction) override {
    return stage != stage_ || fraction == 0;
  }

 private:
  std::string stage_;
};

TEST(VerifySurface, CanBeStoppedWhileItRuns) {
  const Made made = made_sphere();
  for (const char* stage : {"verify/check_delaunay", "verify/find_facets"}) {
    StopWithin progress(stage);
    EXPECT_THROW(verify_surface(made.triangulation, made.surface, made.points, {}, {2, &progress}),
                 Cancelled)
        << stage;
  }
}

TEST(VerifySurface, RefutesHolesTurnedAndRepeatedTriangles) {
  const Made good = made_sphere();
  {
    Made made = good;
    made.surface.mesh.triangles.raw().pop_back();
    EXPECT_EQ(made.verify().unbalanced_edges, 3U);
    EXPECT_FALSE(made.verify().ok());
    EXPECT_TRUE(made.verify({.closed = false}).ok());
  }
  {
    Made made = good;
    Triangle& t = made.surface.mesh.triangles[TriangleId(0)];
    std::swap(t[1], t[2]);
    EXPECT_EQ(made.verify().unbalanced_edges, 3U);
  }
  {
    Made made = good;
    made.surface.mesh.triangles.push_back(made.surface.mesh.triangles[TriangleId(0)]);
    EXPECT_EQ(made.verify({.closed = false}).repeated_triangles, 1U);
    EXPECT_FALSE(made.verify({.closed = false}).ok());
  }
  {
    Made made = good;
    made.surface.mesh.triangles[TriangleId(0)][1] = made.surface.mesh.triangles[TriangleId(0)][0];
    EXPECT_EQ(made.verify().repeated_corners, 1U);
    EXPECT_FALSE(made.verify().ok());
  }
}

}  // namespace
}  // namespace cocoon
