// What is left of the model's surface by an update.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "cocone/known_labels.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/ids.h"
#include "update/choose_regions.h"
#include "update/model/model_index.h"
#include "update/replace_points.h"
#include "update/segment_model.h"

namespace cocoon {

// The model's triangles in kept regions, off the border, whose corners all stay, by the updated
// points: their places in the surface are known. `seen`: what is likely besides (seen_cells.h).
// Refers to what it is made of.
class KeptSurface {
 public:
  KeptSurface(const ModelIndex& model, const Regions& regions, const RegionChoice& choice,
              const Replacement& replacement, AddLikely seen = {})
      : model_(model),
        regions_(regions),
        choice_(choice),
        replacement_(replacement),
        seen_(std::move(seen)) {}

  // The old surface as a source of labels for reconstruct_tight_with_labels(); refers to this
  // object. Undisturbed cells (known_labels.h) are on the side of the whole model on which they
  // lie, unless triangles at a corner tell otherwise.
  OldSurface told() const;

  // All of them. Complexity: O(t).
  std::vector<KnownTriangle> triangles() const;
  // The updated points at which others of the model's triangles were; each may come several times.
  // Complexity: O(border + triangles that went), as a rule.
  std::vector<PointId> torn() const;
  // Those with one of these updated points (ascending), each once. Precondition: kept vertices are
  // distinct. Complexity: O(k log k) for k triangles and vertices that went.
  std::vector<KnownTriangle> at(std::span<const PointId> points) const;

 private:
  bool is_replaced(RegionId region) const {
    return region.is_none() || choice_.replaced[region] != 0;
  }
  void tell_by_model(const Triangulation& triangulation, KnownLabels& known,
                     const Execution& execution) const;
  KnownTriangle corners(TriangleId t) const;
  void append(TriangleId t, std::vector<KnownTriangle>& known) const;

  const ModelIndex& model_;
  const Regions& regions_;
  const RegionChoice& choice_;
  const Replacement& replacement_;
  AddLikely seen_;
};

}  // namespace cocoon
