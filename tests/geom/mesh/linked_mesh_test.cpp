#include "geom/mesh/linked_mesh.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/random/random.h"
#include "geom/spatial_order.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

void expect_copy(const TriangleMesh& mesh, const LinkedMesh& linked) {
  ASSERT_EQ(linked.points.size(), mesh.points.size());
  ASSERT_EQ(linked.triangles.size() + linked.improper.size(), mesh.triangles.size());
  const auto original = [&](const Triangle& t) {
    return Triangle{linked.vertex_of[t[0]], linked.vertex_of[t[1]], linked.vertex_of[t[2]]};
  };
  std::vector<std::uint8_t> found(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < linked.triangles.size(); ++t) {
    EXPECT_EQ(original(linked.triangles[t]), mesh.triangles[linked.triangle_of[t]]);
    found[linked.triangle_of[t].index()] = 1;
  }
  for (std::size_t t = 0; t < linked.improper.size(); ++t) {
    EXPECT_EQ(original(linked.improper[t]), mesh.triangles[linked.improper_of[t]]);
    found[linked.improper_of[t].index()] = 1;
  }
  EXPECT_EQ(std::count(found.begin(), found.end(), 0), 0);
  EXPECT_EQ(linked.links, halfedge_links(linked.triangles, linked.points.size()));
}

void expect_corners(const LinkedMesh& linked) {
  std::vector<std::vector<Halfedge>> expected(linked.points.size());
  for (Halfedge halfedge = 0; halfedge < 3 * linked.triangles.size(); ++halfedge) {
    expected[linked.apex(halfedge).index()].push_back(halfedge);
  }
  for (const VertexId v : linked.points.ids()) {
    const auto corners = linked.corners_at(v);
    EXPECT_EQ(std::vector<Halfedge>(corners.begin(), corners.end()), expected[v.index()]);
  }
}

// Edges by their ends, with the triangles at each and how often they run up the edge.
void expect_irregular(const LinkedMesh& linked) {
  std::map<std::pair<VertexId, VertexId>, std::vector<Halfedge>> edges;
  for (Halfedge halfedge = 0; halfedge < 3 * linked.triangles.size(); ++halfedge) {
    edges[std::minmax(linked.from(halfedge), linked.to(halfedge))].push_back(halfedge);
  }
  std::vector<Halfedge> expected;
  for (const auto& [ends, halfedges] : edges) {
    const bool regular = halfedges.size() == 2 &&
                         linked.from(halfedges[0]) == linked.to(halfedges[1]) &&
                         linked.apex(halfedges[0]) != linked.apex(halfedges[1]);
    if (!regular) expected.push_back(halfedges[0]);
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(linked.irregular, expected);
}

TEST(LinkedMesh, IsTheMeshInAnotherOrder) {
  Random random(3);
  TriangleMesh rubbish = gallery::torus(9, 7);
  const auto count = static_cast<int>(rubbish.points.size());
  for (int k = 0; k < 500; ++k) {
    const auto any = [&] { return VertexId(static_cast<int>(random.uniform(0, count))); };
    rubbish.triangles.push_back({any(), any(), any()});  // some repeat a vertex
  }
  rubbish.points[VertexId(5)].y = std::numeric_limits<double>::quiet_NaN();
  for (const TriangleMesh& mesh : {gallery::torus(20, 11), rubbish, TriangleMesh()}) {
    const LinkedMesh linked = link_mesh(mesh);
    expect_copy(mesh, linked);
    expect_corners(linked);
    expect_irregular(linked);
    const LinkedMesh by_threads = link_mesh(mesh, {.threads = 3});
    EXPECT_EQ(by_threads.triangles, linked.triangles);
    EXPECT_EQ(by_threads.links, linked.links);
  }
}

TEST(LinkedMesh, EveryEdgeHasOneLastSide) {
  const LinkedMesh linked = link_mesh(gallery::torus(9, 7));
  std::size_t edges = 0;
  for (Halfedge halfedge = 0; halfedge < linked.links.size(); ++halfedge)
    edges += linked.is_last(halfedge);
  EXPECT_EQ(2 * edges, linked.links.size());
}

TEST(LinkedMesh, RefusesVerticesThatAreNotThere) {
  TriangleMesh mesh = gallery::tetrahedron();
  mesh.triangles.push_back({VertexId(0), VertexId(1), VertexId(4)});
  EXPECT_THROW(link_mesh(mesh), InputError);
}

TEST(RoughOrder, BringsNeighborsTogether) {
  Random random(4);
  std::vector<Point> points;
  for (int k = 0; k < 20000; ++k) {
    points.push_back({random.uniform(-1, 1), random.uniform(3, 5), random.uniform(0, 2)});
  }
  points[7].z = std::numeric_limits<double>::infinity();
  const std::vector<PointId> order = rough_order(points);
  EXPECT_EQ(order.back(), PointId(7));
  EXPECT_EQ(rough_order(points, {.threads = 3}), order);
  std::vector<PointId> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  double along = 0;
  double given = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    EXPECT_EQ(sorted[k], PointId(k));
    if (k > 8) given += distance(points[k], points[k - 1]);
    if (k > 8) along += distance(points[order[k].index()], points[order[k - 1].index()]);
  }
  EXPECT_LT(10 * along, given);
  EXPECT_TRUE(rough_order({}).empty());
}

}  // namespace
}  // namespace cocoon
