// Robust Cocone: which samples of a noisy cloud a surface can pass through.
//
// Noise spreads the samples over a thin layer. The balls of the cells inside the layer are small,
// hardly larger than the distance between samples; those outside and inside the body are large.
// Large balls that are neighbors on one side of the surface intersect deeply, those on different
// sides hardly. So the outside is what infinity reaches through deep intersections of large balls,
// and the samples that its balls touch are the outer skin of the layer.
//
//   spacing   of a sample, and outlier: see sample_spacing.h
//   large     a ball whose radius exceeds large_ratio times the largest spacing at its cell
//   deep      the radii of two balls to a common sample make an angle of at most deep_angle
#pragma once

#include <cstddef>
#include <cstdint>

#include "cocone/facet_set.h"
#include "delaunay/triangulation.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"
#include "geom/execution.h"
#include "geom/id_vector.h"

namespace cocoon {

// Chosen on the noise table of the quality benchmark (bench/README.md).
struct NoiseOptions {
  std::size_t neighbors = 3;  // edges that make the spacing of a sample
  double outlier_ratio = 3;   // above 4 outliers near the surface stay
  // Samples that the Cocone surface of all samples surrounds by one disk are no outliers, in no
  // round. Without this a sparse region beside a dense one goes, row after row. False: outliers are
  // told by spacing alone.
  bool spare_good = true;
  // Clumps of stray samples (floating_clumps.h): what hangs together, within so many usual spacings
  // from each to the next, with no sample that a disk of the surface surrounds. Less, and a random
  // sampling falls apart; more, and clumps are one with the noise of the body beside them.
  double clump_link_ratio = 2;
  // With this share of all samples it is a layer of noise, no clump. 0: clumps stay.
  double clump_share = 0.02;
  // Samples of a clump within so many links of a good sample stay; by default all that so many
  // links join to one, so that floating clumps alone go. 2 takes clumps off the surface, too, but
  // with them places of line scans where no disk is (docs/stages/noise_filter.md).
  std::size_t clump_depth = 1000;
  double large_ratio = 1.7;     // larger: thinner skin, smoother, but narrow gaps close
  double deep_cosine = 0.7071;  // cosine of deep_angle, 45 degrees
  // Samples that the Cocone surface of the layer surrounds by one disk stay, on the skin or not: so
  // clean parts of a cloud are left as they are. False, and max_leak = 1: the published filter.
  bool keep_good = true;
  // Infinity gets into the body through holes of the data, and then the skin is on both sides of
  // the layer. So if it reaches more than this share of the large balls that the surface of all
  // samples has inside, it is held outside that surface. Without such holes the share is 0, but in
  // strong noise (0.2 to 0.4 at half the spacing); with them 0.9 or more. 1: never held.
  double max_leak = 0.5;
};

// The three below throw InputError for parts of another triangulation, by their sizes, for no
// neighbors, and for a ratio or options out of range (NoiseOptions: ratios and links from 0 on,
// shares from 0 to 1, a cosine).

// Per vertex, in units of the coordinates: the root mean square of its shortest Delaunay edges, as
// many as `neighbors`. Complexity: O(cells), parallel. Deterministic: sums run in increasing order.
IdVector<VertexId, double> sample_spacing(const Triangulation& triangulation,
                                          const VertexStars& stars, std::size_t neighbors,
                                          const Execution& execution = {});

// 1 = outlier: the spacing exceeds `ratio` times the median (the upper one of two) of the Delaunay
// neighbors' spacings. Complexity: O(cells), parallel.
VertexSet outlier_samples(const Triangulation& triangulation, const VertexStars& stars,
                          const IdVector<VertexId, double>& spacing, double ratio,
                          const Execution& execution = {});

enum class BallSize : std::uint8_t { small, large, outer };

struct OuterSkin {
  VertexSet touched;                 // 1 = a vertex of an outer cell
  IdVector<CellId, BallSize> balls;  // of finite cells; outer: large, and reached from infinity
  std::size_t large_cells = 0;       // finite ones
  std::size_t outer_cells = 0;       // finite ones, reached from infinity
};

// An infinite cell counts as a ball that is a half-space. Every hull vertex is touched.
// Complexity: O(cells). Deterministic: a closure. Source: Dey & Goswami 2006.
OuterSkin outer_skin(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, double>& spacing, const NoiseOptions& options = {});

// The same, with infinity held to cells with outside[c] = 1.
OuterSkin outer_skin(const Triangulation& triangulation, const Dual& dual,
                     const IdVector<VertexId, double>& spacing, const NoiseOptions& options,
                     const IdVector<CellId, std::uint8_t>& outside);

}  // namespace cocoon
