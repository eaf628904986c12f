// Samples of a surface, spread as evenly as those of a careful scan.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/random/random.h"
#include "geom/triangle_mesh.h"
#include "io/models/implicit_solid.h"

namespace cocoon {

// The part of a surface that is sampled.
using SurfaceRegion = std::function<bool(const Point&)>;

// Exactly `count` points on the surface of `solid` within `region`, evenly spread (blue noise): of
// five times as many random points those are kept that are farthest from each other. `mesh` is a
// fine mesh of the surface, or of a part of it with all of the region: the random points start
// there. Throws InputError if so little of the mesh lies in the region, less than a hundredth, that
// five times as many points do not fall into it. Complexity: O(count log count), but for the choice
// of those that are kept parallel. Deterministic from the state of `random`: any number of threads.
// Precondition: solid.value may be asked by several threads. Source: Yuksel 2015 (sample
// elimination), with its weights (alpha = 8, no beta and gamma).
std::vector<Point> sample_surface(const ImplicitSolid& solid, const TriangleMesh& mesh,
                                  const SurfaceRegion& region, std::size_t count, Random& random,
                                  const Execution& execution = {});

// Removes points until `count` remain, each time the one most crowded by its neighbors within
// 2 * radius; the rest keeps its order. Ties: the smaller position. Complexity: O(n log n) for
// points on a surface of which a disk of that radius holds a bounded number.
std::vector<Point> eliminate_samples(const std::vector<Point>& points, std::size_t count,
                                     double radius, const Execution& execution = {});

}  // namespace cocoon
