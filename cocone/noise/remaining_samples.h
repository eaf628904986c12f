// Samples of a set of points that filters leave out step by step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/noise/outlier_rounds.h"
#include "cocone/noise_filter.h"
#include "delaunay/delaunay.h"
#include "delaunay/vertex_stars.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"

namespace cocoon {

class RemainingSamples {
 public:
  // Of `noise` counts what tells outliers: neighbors and outlier_ratio. Triangulates all points.
  // Errors: InputError as delaunay(), but flat ones are none if they are to be moved.
  RemainingSamples(Points points, const NoiseOptions& noise, FlatSamples flat,
                   const DelaunayOptions& options, const Execution& execution);

  // Of the samples that remained when they were last triangulated, times their working scale, with
  // the cells at each and its spacing (sample_spacing by noise.neighbors).
  const Triangulation& triangulation() const { return triangulation_; }
  const VertexStars& stars() const { return stars_; }
  const IdVector<VertexId, double>& spacing() const { return spacing_; }
  double scale() const { return scale_; }
  // Where the point at a vertex was given; of equal ones one. O(1).
  PointId input_of(VertexId v) const { return inputs_[triangulation_.point_of_vertex(v).index()]; }
  // 1 = the point remains; equal points share their fate.
  const IdVector<PointId, std::uint8_t>& kept() const { return kept_; }

  // Leaves out the points at these vertices; before anything else is left out, triangulate().
  // Complexity: O(points).
  void leave_out(const VertexSet& out);
  // Triangulates what remains. Errors: DegenerateInput if that does not span space, unless it is
  // flat and to be moved.
  void triangulate();

  // 1 = outlier (outlier_samples) of the samples when they were last triangulated.
  VertexSet outliers() const;
  struct Outliers {
    std::size_t count = 0;   // left out
    std::size_t spared = 0;  // not left out
    std::size_t rounds = 1;
  };
  // Leaves out the first outliers, as from outliers(), and others until there are none, but none of
  // those with spared[v] = 1 (outlier_rounds.h); and triangulates again if any went. Errors: as
  // triangulate(). Precondition: none is spared if flat samples are to be moved.
  Outliers leave_out_outliers(const VertexSet& first, const VertexSet& spared = {});

 private:
  void leave_out(const VertexSet& out, const IdVector<PointId, VertexId>& vertex_of_point);

  NoiseOptions noise_;
  FlatSamples flat_;
  DelaunayOptions options_;
  Execution execution_;
  std::vector<Point> points_;    // that remain, as given
  std::vector<PointId> inputs_;  // where each was given
  IdVector<PointId, std::uint8_t> kept_;
  double scale_ = 1;
  Triangulation triangulation_;
  VertexStars stars_;
  IdVector<VertexId, double> spacing_;
};

}  // namespace cocoon
