#include "update/model/mesh_edit.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "geom/mesh/triangle_order.h"
#include "geom/random/random.h"
#include "tests/mesh_gallery.h"
#include "update/model/mesh_change.h"

namespace cocoon {
namespace {

// A closed surface, and the same with some vertices pulled out: their stars are triangulated by
// fans around new vertices, which come last.
struct Change {
  TriangleMesh before;
  TriangleMesh after;
  ListEdit<VertexId> vertices;
  std::vector<Point> added_points;
  std::vector<VertexId> touched;
  std::vector<Triangle> triangles;  // at touched and new vertices, afterwards
};

Change random_change(std::size_t wanted, Random& random) {
  Change change;
  change.before = gallery::sphere(3);
  canonicalize_triangles(change.before);
  const TriangleMesh& before = change.before;
  const ModelIndex index = ModelIndex::of_smooth(before);
  // Vertices no two of which share a triangle.
  std::set<VertexId> taboo;
  std::set<VertexId> out;
  for (std::size_t k = 0; k < wanted; ++k) {
    const VertexId v(random.below(before.points.size()));
    if (taboo.count(v) != 0) continue;
    out.insert(v);
    for (const TriangleId t : index.triangles_at(v)) {
      for (const VertexId w : before.triangles[t]) taboo.insert(w);
    }
  }
  change.touched.assign(taboo.begin(), taboo.end());
  change.vertices.removed.assign(out.begin(), out.end());
  IdVector<VertexId, VertexId> number(before.points.size());
  for (const VertexId v : before.points.ids()) {
    if (out.count(v) == 0) number[v] = change.after.points.push_back(before.points[v]);
  }
  for (const VertexId v : out) {
    const Point p = 1.01 * before.points[v];
    change.added_points.push_back(p);
    number[v] = change.after.points.push_back(p);  // the fan around it has the same rim
    change.vertices.added.push_back(number[v]);
  }
  for (const Triangle& t : before.triangles) {
    const Triangle now = smallest_first({number[t[0]], number[t[1]], number[t[2]]});
    change.after.triangles.push_back(now);
    const bool looked_at =
        std::any_of(t.begin(), t.end(), [&](VertexId v) { return taboo.count(v) != 0; });
    if (looked_at) change.triangles.push_back(now);
  }
  canonicalize_triangles(change.after);
  std::sort(change.triangles.begin(), change.triangles.end());
  return change;
}

TEST(MeshEdit, LeadsFromOneMeshToTheOtherAndBack) {
  Random random(1);
  for (const std::size_t wanted : {1U, 3U, 30U, 300U}) {
    const Change change = random_change(wanted, random);
    TriangleMesh mesh = change.before;
    ModelIndex index = ModelIndex::of_smooth(mesh);
    const MeshEdit edit =
        mesh_edit(index, change.vertices, places_after(change.vertices, mesh.points.size()),
                  change.added_points, change.touched, change.triangles);
    const auto carry_out = [&](const MeshEdit& way) {
      const auto vertex_map = places_after(way.vertices, mesh.points.size());
      const auto triangle_map = places_after(way.triangles, mesh.triangles.size());
      edit_list(mesh.points, way.vertices, way.added_points);
      edit_triangles(mesh.triangles, way, vertex_map);
      index.edit({way.vertices, way.triangles, triangle_map});
    };
    const auto expect_index = [&] {
      const ModelIndex expected(mesh);
      EXPECT_EQ(index.neighbors(), expected.neighbors());
      for (const VertexId v : mesh.points.ids()) {
        EXPECT_EQ(index.triangles_at(v), expected.triangles_at(v));
      }
      std::vector<VertexId> in_box, expected_in_box;
      const Box box{{-0.1, -0.3, 0}, {1, 0.2, 1}};
      index.for_each_vertex_in(box, [&](VertexId v) { in_box.push_back(v); });
      expected.for_each_vertex_in(box, [&](VertexId v) { expected_in_box.push_back(v); });
      EXPECT_FALSE(in_box.empty());
      EXPECT_EQ(in_box, expected_in_box);
      EXPECT_TRUE(index.has_distinct_points());
      EXPECT_TRUE(index.is_connected());
      EXPECT_GE(index.longest_extent(), ModelIndex::of_smooth(mesh).longest_extent());
    };
    carry_out(edit);
    EXPECT_TRUE(mesh == change.after);
    expect_index();
    carry_out(edit.reversed());
    EXPECT_TRUE(mesh == change.before);
    expect_index();

    const MeshChange told = mesh_change(change.before, change.after,
                                        places_after(edit.vertices, change.before.points.size()));
    EXPECT_EQ(edit.removed, told.removed);
    EXPECT_EQ(edit.added, told.added);
  }
}

// An edit that was carried out leads to what other looks at the mesh tell, or it does not.
TEST(MeshEdit, LeadsToWhatIsTold) {
  Random random(2);
  const Change change = random_change(5, random);
  const IdVector<VertexId, VertexId> vertex_map =
      places_after(change.vertices, change.before.points.size());
  const MeshEdit edit = mesh_edit(ModelIndex::of_smooth(change.before), change.vertices, vertex_map,
                                  change.added_points, change.touched, change.triangles);
  const ModelIndex after = ModelIndex::of_smooth(change.after);
  const auto leads = [&](const std::vector<VertexId>& touched,
                         const std::vector<Triangle>& triangles) {
    return leads_to(edit, after, vertex_map, touched, triangles);
  };
  EXPECT_TRUE(leads(change.touched, change.triangles));
  // Told of more than has changed: it leads there, too, if they are told as they are.
  std::vector<VertexId> everywhere;
  for (const VertexId v : change.before.points.ids()) everywhere.push_back(v);
  EXPECT_TRUE(leads(everywhere, change.after.triangles.raw()));
  // A triangle that is not there, one that is left out, one that is turned.
  std::vector<Triangle> other = change.triangles;
  other.pop_back();
  EXPECT_FALSE(leads(change.touched, other));
  other.push_back(change.triangles.back());
  std::swap(other.back()[1], other.back()[2]);
  EXPECT_FALSE(leads(change.touched, other));
  // Nothing is told where something went.
  EXPECT_FALSE(leads({}, {}));
  EXPECT_FALSE(leads(change.vertices.removed, {}));
}

}  // namespace
}  // namespace cocoon
