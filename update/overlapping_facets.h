// Where the rim of a cloud lies on the model: the overlapping facets.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "geom/execution.h"
#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"

namespace cocoon {

enum class LocationRule {
  // The closest facet that does not face away from the cloud; one that faces as the cloud does if
  // there is one hardly farther away (facing_preference). Default.
  closest_facet,
  // The paper's: of the facets at the nearest model vertex, the one that contains the projection;
  // where there is none, closest_facet. Goes wrong where facets are long (see docs/departures.md).
  nearest_vertex_star,
};

struct OverlapOptions {
  LocationRule rule = LocationRule::closest_facet;
  // A rim point farther from its facet than this many spacings is unmatched. The spacing is that of
  // the rim or, if that is larger, the median edge of the model's facet closest to the point.
  double max_distance = 3;
  // Facets whose normal makes a smaller cosine than this with the surface normal of the cloud are
  // taken only if none with a larger one is hardly farther away (a cloud that leaves the model
  // steeply); those with less than minus this never: they are the far side of a thin wall.
  double min_normal_cosine = 0.5;
  // How many spacings farther away than the closest facet: that is too far for a facet that merely
  // happens to face the same way, such as the next wall.
  double facing_preference = 1;
  // Which side of its surface is that of the model, a loop on a one-sided part (RimLoop::one_sided)
  // tells by the points no more than this many away from each.
  std::size_t one_sided_window = 2;
  // A loop with a larger share of unmatched points does not lie on the model.
  double max_unmatched_share = 0.1;
  // Nor does a loop other than the longest of its part of the surface if a larger share of its
  // points is unmatched or farther from the model than that one, or the longest of all (the smaller
  // of their medians), by so many spacings, as in max_distance: one side of it is the shadow of the
  // other, as in a dent that is seen at a slant. Nor does the longest loop of another part if a
  // larger share of its points than max_raised_outline is farther off, by that distance, than the
  // longest loop of all: it is the top of a boss, or the floor of a pocket. A rim with a point so
  // much farther off than its median is worth a warning.
  double max_raised_share = 0.3;
  double max_raised_outline = 0.7;
  double raised_distance = 1;
  // A rim whose matched points lie farther off the model than this many of its spacings (the median
  // of them) leaves a step there: that is worth a warning. Up to half a spacing does no harm.
  double step_distance = 0.75;
};

enum class LoopMatch {
  on_model,   // at most max_unmatched_share of its points are unmatched and not covered, and few
              // enough are raised
  covered,    // as good as all of its points lie on other clouds: no border of its own
  off_model,  // neither; allowed for a hole inside the cloud, and for a part of it off the model
};

struct LoopOverlap {
  LoopMatch match = LoopMatch::on_model;
  std::vector<TriangleId> facets;  // per rim point: the overlapping facet, or `none`
  std::vector<Point> feet;         // per rim point: its closest point on that facet
  std::size_t inner_points = 0;    // not looked for: between edges with cloud beyond them
  std::size_t unmatched = 0;       // points without a facet, inner points left aside
  std::size_t raised = 0;   // points farther off than raised_distance says; unmatched ones, too
  std::size_t covered = 0;  // unmatched points on another cloud, see excuse_covered_points()
  bool is_outline = false;  // the longest loop of its part of the surface
};

enum class OverlapStatus {
  ok,
  no_overlap,  // the longest loop of the cloud is off the model, or all clouds that cover it are
};

struct OverlapFigures {
  std::size_t star_misses = 0;  // nearest_vertex_star only: no facet there, closest one taken
  // Rim points whose closest facet of all has a cosine below min_normal_cosine, and those for which
  // such a facet was taken.
  std::size_t facing_away = 0;
  std::size_t steep = 0;
  // Rim points off the part of the model that the others are on: located there, or unmatched.
  std::size_t relocated = 0;
  // Of matched rim points from their facets.
  double largest_distance = 0;
  double median_distance = 0;
  // By how many spacings, as in max_distance, a matched point at most is farther from its facet
  // than the median.
  double largest_excess = 0;
  // If it lies on the model by take_shadowed_rim(): points of its longest loop that are far off,
  // and all of them.
  std::size_t in_shadow = 0;
  std::size_t in_shadow_of = 0;
};

struct Overlap {
  OverlapStatus status = OverlapStatus::ok;
  std::vector<LoopOverlap> loops;  // as in the rim
  std::vector<TriangleId> facets;  // all overlapping facets, sorted, each once
  std::size_t unmatched = 0;       // rim points without a facet
  OverlapFigures figures;
  // Its largest_excess is more than raised_distance, or some of it is in_shadow: the scan ends on
  // what has changed.
  bool leaves_model = false;

  // Whether a loop lies on the model, or on other clouds.
  bool is_border() const {
    return std::any_of(loops.begin(), loops.end(),
                       [](const LoopOverlap& loop) { return loop.match != LoopMatch::off_model; });
  }
};

// The overlapping facet of each rim point, and which loops lie on the model at all.
// Whether the surface at a loop is oriented like the model is decided by vote: the sign of the sum
// over its points of the cosine with the closest facet. Where the surface of the cloud is
// one-sided, as at walls thinner than its spacing, the points next to each decide. A loop lies on
// one connected part of the model: if all but max_unmatched_share of its points do, the others look
// for their facets on that part, too (a speck of dust beside the surface would break the band).
// Errors: InputError for options out of range: distances from 0, shares from 0 to 1, a cosine.
// Complexity: a few operations for each vertex and facet of the model, and O(rim log(model)) where
// the rim lies on it (update/model/near_facets.h); O(model log(model)) for rims far away and for
// nearest_vertex_star. Deterministic: ties by lexicographic corners.
// Source: Woo & Dey 2005, section 3.3, Eq. 1-3.
Overlap overlapping_facets(const ModelIndex& model, const CloudRim& rim,
                           const OverlapOptions& options = {}, const Execution& execution = {});

// Overload for a mesh without an index: builds the ModelIndex first, O(t + v).
Overlap overlapping_facets(const TriangleMesh& model, const CloudRim& rim,
                           const OverlapOptions& options = {}, const Execution& execution = {});

// Where clouds overlap each other on changed geometry, the rim of one lies on the other and not on
// the old model. Counts the unmatched points of each loop that are within `max_distance` rim
// spacings of a point of another cloud as covered, and judges the loops anew without them. If of
// clouds that cover each other, also by way of others, none has a loop on the model, they all lie
// off it (no_overlap).
// clouds[i] belongs to rims[i] and overlaps[i]. Errors: InputError unless there are as many of
// each, and of loops; for options as above. What take_shadowed_rim() took stays on the model.
// Complexity: O(clouds) if no point is unmatched; else O(n log n) for the n points of all clouds,
// and O(log n) for each unmatched point and cloud. Source: ours; clouds that overlap each other do
// not occur in Woo & Dey 2005.
void excuse_covered_points(std::span<const CloudRim> rims,
                           std::span<const std::vector<Point>> clouds, std::span<Overlap> overlaps,
                           const OverlapOptions& options = {});

// Empties the loops of a rim that are not on the model: those have no part in the border. `found`:
// what is known of each loop (LoopOverlap, LoopReport).
template <class Found>
void keep_border_loops(const std::vector<Found>& found, CloudRim& rim) {
  for (std::size_t l = 0; l < rim.loops.size(); ++l) {
    if (found[l].match != LoopMatch::on_model) rim.loops[l] = {};
  }
}

}  // namespace cocoon
