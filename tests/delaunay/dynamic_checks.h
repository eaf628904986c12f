// What must hold for a DynamicDelaunay after every operation.
#pragma once

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "delaunay/canonical_order.h"
#include "delaunay/circulate.h"
#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "ref/cell_set.h"

namespace cocoon {

inline std::vector<VertexId> live_vertices(const DynamicDelaunay& dynamic) {
  std::vector<VertexId> live;
  for (const VertexId v : id_range<VertexId>(dynamic.num_vertex_slots())) {
    if (dynamic.contains(v)) live.push_back(v);
  }
  return live;
}

inline std::vector<Point> live_points(const DynamicDelaunay& dynamic) {
  std::vector<Point> points;
  for (const VertexId v : live_vertices(dynamic)) points.push_back(dynamic.point(v));
  return points;
}

// The cells are those of a fresh build, as sets and in canonical order as arrays.
inline void expect_fresh(const DynamicDelaunay& dynamic) {
  const FrozenDelaunay frozen = dynamic.freeze();
  const Triangulation fresh = delaunay(live_points(dynamic)).triangulation;
  ASSERT_EQ(dynamic.num_vertices(), fresh.num_vertices());
  ASSERT_TRUE(ref::cell_set(frozen.triangulation) == ref::cell_set(fresh));
  const Triangulation actual = canonical_order(frozen.triangulation);
  const Triangulation expected = canonical_order(fresh);
  ASSERT_TRUE(actual.points() == expected.points());
  ASSERT_TRUE(actual.cell_records() == expected.cell_records());
  ASSERT_EQ(actual.num_finite_cells(), expected.num_finite_cells());
}

// What the class promises about its own arrays.
inline void expect_consistent(const DynamicDelaunay& dynamic) {
  const TriangulationView view = dynamic.view();
  for (const VertexId v : live_vertices(dynamic)) {
    const CellId c = dynamic.cell_at(v);
    ASSERT_FALSE(view.is_free(c));
    ASSERT_TRUE(has_vertex(view.cell(c), v)) << "vertex " << v.value;
  }
  for (const CellId c : view.cell_slots()) {
    if (view.is_free(c)) continue;
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      ASSERT_FALSE(view.is_free(cell_of(view.mirror(f))));
      ASSERT_EQ(view.mirror(view.mirror(f)), f);
      const VertexId v = view.vertex(c, i);
      ASSERT_TRUE(v == infinite_vertex || dynamic.contains(v));
    }
  }
}

// A cell by its vertices; by slot, empty where free.
inline std::vector<std::vector<VertexId>> cells_by_slot(const DynamicDelaunay& dynamic) {
  std::vector<std::vector<VertexId>> cells;
  for (const Cell& cell : dynamic.view().cell_records()) {
    cells.emplace_back();
    if (cell.vertices[0].is_none()) continue;
    cells.back().assign(cell.vertices.begin(), cell.vertices.end());
    std::sort(cells.back().begin(), cells.back().end());
  }
  return cells;
}

// The journal tells the whole truth: what it does not name is as before.
inline void expect_journal(const std::vector<std::vector<VertexId>>& before,
                           const DynamicDelaunay& dynamic, const DelaunayChange& change) {
  const std::vector<std::vector<VertexId>> after = cells_by_slot(dynamic);
  const std::set<CellId> created(change.created.begin(), change.created.end());
  const std::set<CellId> deleted(change.deleted.begin(), change.deleted.end());
  ASSERT_EQ(created.size(), change.created.size());
  ASSERT_EQ(deleted.size(), change.deleted.size());
  for (const CellId c : deleted)
    ASSERT_TRUE(c.index() < before.size() && !before[c.index()].empty());
  for (std::size_t slot = 0; slot < after.size(); ++slot) {
    const CellId c(slot);
    const bool was_live = slot < before.size() && !before[slot].empty();
    const bool is_live = !after[slot].empty();
    if (created.count(c) != 0) {
      ASSERT_TRUE(is_live);
      ASSERT_EQ(was_live, deleted.count(c) != 0);
    } else if (deleted.count(c) != 0) {
      ASSERT_TRUE(was_live && !is_live);
    } else {
      ASSERT_EQ(was_live, is_live);
      ASSERT_TRUE(!was_live || before[slot] == after[slot]);
    }
  }
}

// A patch of `count` live vertices: those nearest to the point.
inline std::vector<VertexId> patch(const DynamicDelaunay& dynamic, const Point& center,
                                   std::size_t count) {
  std::vector<VertexId> live = live_vertices(dynamic);
  std::sort(live.begin(), live.end(), [&](VertexId a, VertexId b) {
    return squared_distance(dynamic.point(a), center) < squared_distance(dynamic.point(b), center);
  });
  live.resize(std::min(count, live.size()));
  return live;
}

}  // namespace cocoon
