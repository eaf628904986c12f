// A change of points as one of a triangulation.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "delaunay/dynamic_delaunay.h"
#include "delaunay/renumbering.h"
#include "geom/arrays/list_edit.h"
#include "geom/id_vector.h"
#include "geom/ids.h"
#include "geom/point.h"

namespace cocoon {

// What a change of the triangulation does to the points, and how to take it back.
struct PointStep {
  std::vector<VertexId> removed;
  std::vector<Point> removed_points;
  std::vector<PointId> inserted;  // positions among the new points
  std::vector<Point> inserted_points;
  IdVector<PointId, VertexId> vertex_of_point;  // none: to be inserted
  std::vector<Renumbering::Move> moved;         // vertices, after the change
  std::size_t slots = 0;                        // of vertices, before they moved
};

// From the points that have these vertices to others; old_position[i]: where points[i] was, none if
// it is new. Precondition: require_positions(). Errors: InputError unless an equal one was there.
// Complexity: O(n), a look at each point.
PointStep plan_step(const DynamicDelaunay& delaunay,
                    const IdVector<PointId, VertexId>& vertex_of_point, Points points,
                    std::span<const PointId> old_position);
// Throws InputError unless there is a position for each point, none or one of those before.
// Complexity: O(n).
void require_positions(std::size_t points, std::span<const PointId> old_position,
                       std::size_t before);

// Throws InputError unless the edit leads from so many points to so many: what goes is among those
// before, what comes among those after, both ascending. Complexity: O(change).
void require_edit(const ListEdit<PointId>& change, std::size_t before, std::size_t after);

// The same for points that stay in their order. Precondition: each vertex has one point;
// require_edit(). Complexity: O(change), and a copy of vertex_of_point.
PointStep plan_step(const DynamicDelaunay& delaunay,
                    const IdVector<PointId, VertexId>& vertex_of_point, Points points,
                    const ListEdit<PointId>& change);

}  // namespace cocoon
