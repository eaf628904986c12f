// A changing set of samples with what is known of its candidates, for tests of what follows.
#pragma once

#include <vector>

#include "cocone/live/live_candidates.h"
#include "cocone/reconstruct.h"
#include "cocone/steps/reconstruct_and_keep.h"
#include "delaunay/delaunay.h"
#include "delaunay/dynamic_delaunay.h"
#include "geom/random/random.h"
#include "tests/cocone/kept/lend.h"

namespace cocoon {

class LiveSamples {
 public:
  explicit LiveSamples(const std::vector<Point>& points) {
    ReconstructStages stages;
    reconstruct_and_keep(cocoon::delaunay(points).triangulation, points, {}, {}, {}, stages);
    delaunay_ = DynamicDelaunay(std::move(stages.triangulation));
    candidates_.start(delaunay_, stages);
    candidates_.renumber(delaunay_.close_gaps(), delaunay_);
  }

  // Of the points within `reach` of one of them two thirds go, and as large a part of the others
  // comes. follow(change) and follow(renumbering) are called when that has been done.
  template <class Follow>
  void change(double reach, const std::vector<Point>& others, Random& random, Follow follow) {
    const Point center = delaunay_.point(VertexId(random.below(delaunay_.num_vertices())));
    std::vector<VertexId> removed;
    std::vector<Point> inserted;
    for (const VertexId v : id_range<VertexId>(delaunay_.num_vertex_slots())) {
      if (distance(delaunay_.point(v), center) > reach) continue;
      if (random.below(3) != 0) removed.push_back(v);
    }
    for (const Point& p : others) {
      if (distance(p, center) < reach && random.below(3) != 0) inserted.push_back(p);
    }
    replace(removed, inserted, follow);
  }

  // The same for a change of one's own.
  template <class Follow>
  void replace(const std::vector<VertexId>& removed, const std::vector<Point>& inserted,
               Follow follow) {
    const DelaunayChange change = delaunay_.replace(removed, inserted);
    candidates_.update(delaunay_, change);
    follow(change);
    const Renumbering renumbering = delaunay_.close_gaps();
    candidates_.renumber(renumbering, delaunay_);
    follow(renumbering);
  }

  // Calls visit(triangulation): the points are its vertices, in their order.
  template <class Visit>
  void lend(Visit visit) {
    cocoon::lend(delaunay_, visit);
  }

  const DynamicDelaunay& delaunay() const { return delaunay_; }
  const LiveCandidates& candidates() const { return candidates_; }

 private:
  DynamicDelaunay delaunay_;
  LiveCandidates candidates_;
};

}  // namespace cocoon
