// The few facets of a mesh that lie near given points, with a search tree over them alone.
#pragma once

#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/search/box_tree.h"
#include "geom/search/closest_facet.h"
#include "geom/triangle_mesh.h"
#include "update/model/model_index.h"

namespace cocoon {

// A search tree over all facets of a large model costs far more than the questions of an update,
// which are about the places under the rims of its clouds. So this one leaves out what is too far
// from all of these places to be an answer; the answers are those of a tree over all facets.
// Refers to a mesh, which must outlive it and not change. Safe to query from many threads.
class NearFacets {
 public:
  // Holds all facets of the model's mesh with a point within `reach` of one of the centers;
  // infinity: all facets. The mesh and the centers have finite coordinates. The index is not kept.
  // Complexity: O(v + t + c + f log f) for c centers and f facets held; the first two are a few
  // operations for each vertex and facet. Without t where the index knows how long the sides are.
  NearFacets(const ModelIndex& model, Points centers, double reach);

  double reach() const { return reach_; }

  // The facet closest to p, one of the centers, for which accept(t) holds, at a squared distance of
  // at most `bound`, which is at most the square of the reach; triangle `none` if there is none.
  // Ties by lexicographic corners, then by id. Complexity: O(log f) on ordinary meshes.
  template <class Accept>
  ClosestFacet closest(const Point& p, double bound, const Accept& accept) const {
    ClosestFacet best;
    best.squared_distance = bound;
    tree_.visit_near(p, bound, [&](std::uint32_t slot) {
      const TriangleId t = facets_[tree_.items()[slot]];
      if (accept(t)) improve(p, t, best);
      return best.squared_distance;
    });
    return best;
  }
  // Of all of them.
  ClosestFacet closest(const Point& p, double bound) const {
    return closest(p, bound, [](TriangleId) { return true; });
  }

 private:
  void improve(const Point& p, TriangleId t, ClosestFacet& best) const;

  const TriangleMesh* mesh_;
  double reach_;
  std::vector<TriangleId> facets_;  // in the order of ids
  BoxTree tree_;                    // of facets_
};

// The closest facet of all for each of the points. First facets within `reach`, which is finite,
// are looked at, then farther ones for those that find none there. Complexity: what NearFacets
// takes, and O(log f) for each point; O(model log(model)) if some lie far away. Deterministic.
std::vector<ClosestFacet> closest_facets(const ModelIndex& model, Points points, double reach,
                                         const Execution& execution = {});

}  // namespace cocoon
