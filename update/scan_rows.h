// Scans in rows, as a laser line makes them: samples lie far closer along a row than from row to
// row. Their surface is thinned out before its rim is looked for.
#pragma once

#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

struct RowOptions {
  // A cloud lies in rows if in this share of its triangles or more the second longest edge, from
  // row to row, is so many times longer than the shortest, along a row. Even samples have a ratio
  // of 1.4, random ones and several scans over each other 2.3. A ratio of 0: no cloud does. (Not
  // most triangles: where rows are not straight, up to half of them lie within one.)
  double min_ratio = 3;
  double min_share = 0.25;
  // Thinned samples are not closer to each other than this share of the distance of rows, which at
  // a point is this quantile of the second longest edges of its triangles.
  double spread = 0.5;
  double quantile = 0.75;
};

// Whether enough triangles of a cloud's surface lead from row to row; `false` if min_ratio is 0 or
// there are no triangles with three different corners. Complexity: O(triangles). Source: ours.
bool lies_in_rows(const TriangleMesh& surface, const RowOptions& options = {});

// Some of the points, increasing (thin_points): each point left out is closer to one of these than
// `spread` times the distance of rows at that one. The triangles at a point are those of `surface`,
// whose vertex v is the point point_of_vertex[v]; the distance of rows there is no less than that
// of all triangles. Precondition: the surface has a triangle with three different corners. Errors:
// InputError unless each vertex has its point. Complexity: that of thin_points, with neighbors as
// many as rows have samples within reach. Source: ours.
std::vector<PointId> thin_out_rows(Points cloud, const TriangleMesh& surface,
                                   const IdVector<VertexId, PointId>& point_of_vertex,
                                   const RowOptions& options = {});

}  // namespace cocoon
