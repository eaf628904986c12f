// Triangles of the model that an update loses though nothing was scanned there: a sign that the
// model is no dense sampling of its surface, or that more has gone than should.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/triangle_mesh.h"
#include "update/cloud/scan.h"

namespace cocoon {

struct LostTriangles {
  std::size_t staying = 0;       // triangles of the model all of whose vertices stay
  double staying_area = 0;       // theirs
  std::vector<TriangleId> lost;  // those of them that the updated mesh does not have, ascending
};

// The updated mesh is made from points alone. Where these sample the model's surface densely it has
// the model's triangles again, but for some at the rim of the change, and where four samples on one
// circle have another diagonal. A vertex stays if it is one of the updated points, whether or not
// these are all on the surface: `point_of_vertex` as in Replacement. `triangle_map`: each triangle
// in the updated mesh, as in MeshChange. Complexity: O(t). Source: ours.
LostTriangles lost_triangles(const TriangleMesh& model,
                             const IdVector<VertexId, PointId>& point_of_vertex,
                             const IdVector<TriangleId, TriangleId>& triangle_map);

struct AstrayOptions {
  // A place, the middle of a triangle or of a part of it, is off the updated mesh if farther from
  // it than this share of the triangle's longest side, and than this many spacings of the scans,
  // the largest of several: a plate under large triangles may be thinner than that share of them.
  double tolerance = 0.05;
  double most_spacings = 1;
  // A place has been scanned if a sample lies within this many spacings of its cloud.
  double reach = 3;
  // For whoever tells of them. Looked for only if this share of the triangles that stay is lost;
  // worth a warning from this share of their area on. Of dense models at most 0.003 are lost, and
  // a block of CAD programs has 12 in all.
  double min_lost_share = 0.1;
  double min_area_share = 0.02;
  // A trial to make it dense is worth its time from this share on: the sides of a plate are little
  // of it.
  double min_coarse_share = 0.005;
  // The model is too coarse for the scans if its astray triangles are longer than this many of
  // their spacings; else something else went wrong.
  double coarse_ratio = 3;
  // A triangle is astray if its middle is. Sides of others longer than that are divided into parts
  // no longer, at most so many, and parts are astray: what is lost is seldom all of a large
  // triangle. None of these counts in the box around a scan, for there the old surface may lie
  // under what has come.
  std::size_t most_parts = 8;
};

struct AstrayTriangles {
  std::size_t count = 0;           // with some part astray
  double area = 0;                 // of these parts, in squares of the coordinates' unit
  double median_longest_edge = 0;  // of each triangle its longest one; the median by area
  TriangleId largest = {};         // by area; of several the first
};

// Those of `triangles` of which parts are off the updated mesh although nothing was scanned there.
// From the few vertices of a mesh with large triangles, as CAD programs give, another shape is
// made. Complexity: O(t log t + t log n) for n samples, and most_parts^2 times as much for large
// triangles. Precondition: `updated` has triangles. Errors: InputError for options out of range.
// Source: ours.
AstrayTriangles astray_triangles(const TriangleMesh& model, std::span<const TriangleId> triangles,
                                 const TriangleMesh& updated, std::span<const Scan> scans,
                                 const AstrayOptions& options = {});

}  // namespace cocoon
