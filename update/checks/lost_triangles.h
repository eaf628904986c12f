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
  double lost_area = 0;          // of these
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
  // The middle of a triangle is off the updated mesh if farther from it than the smaller one of
  // this share of the triangle's longest side and this many spacings of the scans, the largest of
  // several: a plate under large triangles may be thinner than that share of them.
  double tolerance = 0.05;
  double most_spacings = 0.5;
  // A place has been scanned if a sample lies within this many spacings of its cloud.
  double reach = 3;
  // Triangles are too large for the scans if longer than this many of their spacings. The model is
  // too coarse if astray triangles are; else something else went wrong.
  double coarse_ratio = 3;
  // And only if longer than this share of the extent of the change, too (large_side): of others
  // little is lost beside the change, but of models that were scanned more coarsely all triangles
  // of what was changed would seem lost; on the paper's models they are 0.015 to 0.04 of the
  // extent.
  double min_extent_share = 0.1;
  // Sides of large triangles are divided into parts no longer, at most so many.
  std::size_t most_parts = 8;
};

// Triangles with a longer side are too large for the scans and for what was changed:
// min_extent_share of the extent of the smallest scan, and at least coarse_ratio times the largest
// spacing. The extent is the diameter of a flat disk whose samples have the same median distance
// from its center as those of the scan have from the medians of their coordinates: strays do not
// count. Complexity: O(n).
// Errors: InputError for options out of range.
double large_side(std::span<const Scan> scans, const AstrayOptions& options = {});

struct AstrayTriangles {
  std::size_t count = 0;
  double area = 0;                 // in squares of the coordinates' unit
  double median_longest_edge = 0;  // of each triangle its longest one; the median by area
  TriangleId largest = {};         // by area; of several the first
};

// Those of `triangles` whose middles are off the updated mesh although nothing was scanned there.
// From the few vertices of a mesh with large triangles, as CAD programs give, another shape is
// made. Complexity: O(t log t + t log n) for n samples. Precondition: `updated` has triangles.
// Errors: InputError for options out of range. Source: ours.
AstrayTriangles astray_triangles(const TriangleMesh& model, std::span<const TriangleId> triangles,
                                 const TriangleMesh& updated, std::span<const Scan> scans,
                                 const AstrayOptions& options = {});

}  // namespace cocoon
