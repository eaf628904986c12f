// The local update: parts of a closed mesh are replaced by added clouds of points.
//
//   clouds --cloud_surface--> rims --overlapping_facets, trace_border--> border on the model
//          --segment_model, mean_rim_angles, choose_regions--> regions under the clouds
//          --replace_points--> points, KeptSurface --reconstruct_tight_with_labels--> updated mesh
//
// Anything done here can be done by hand with the stages themselves.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cocone/known_labels.h"
#include "cocone/reconstruct.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"
#include "update/checks/bridged_gaps.h"
#include "update/checks/closed_openings.h"
#include "update/checks/contradicted_samples.h"
#include "update/checks/crowded_samples.h"
#include "update/checks/loose_parts.h"
#include "update/checks/overlooked_vertices.h"
#include "update/checks/rim_shift.h"
#include "update/checks/unexplained_handles.h"
#include "update/checks/unscanned_losses.h"
#include "update/checks/unused_changes.h"
#include "update/choose_regions.h"
#include "update/cloud/outward_normals.h"
#include "update/cloud/wall_edges.h"
#include "update/cloud_surface.h"
#include "update/contradicted_islands.h"
#include "update/cut_regions.h"
#include "update/joined_clouds.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"
#include "update/override_choice.h"
#include "update/pin_holes.h"
#include "update/regions/sampled_regions.h"
#include "update/regions/seen_cells.h"
#include "update/regions/unchanged_rest.h"
#include "update/replace_points.h"
#include "update/report/cloud_report.h"
#include "update/report/update_status.h"
#include "update/rim_angles.h"
#include "update/segment_model.h"
#include "update/shadowed_rim.h"
#include "update/shared_edges.h"
#include "update/trace_border.h"

namespace cocoon {

// By the steps that ask them; numbers are departures from the paper (docs/departures.md).
struct UpdateOptions {
  // Boundary detection.
  JoinOptions join;           // of clouds that overlap each other (10)
  CloudSurfaceOptions cloud;  // surface and rim of each (3, 4, 5, 19, 25, 30)
  // Overlapping facets.
  PinHoleOptions pin_holes;  // small holes through which the model goes on (15)
  WallEdgeOptions walls;     // new edges of thin walls are no rims (32)
  OverlapOptions overlap;    // which facet lies under a rim point (6, 12, 26)
  ShadowOptions shadow;      // rims that are off the model part of the way (34)
  TraceOptions trace;        // from one rim point to the next (7)
  // Segmentation.
  SegmentOptions segment;    // by the border
  SharedEdgeOptions shared;  // rim edges beyond which another cloud goes on (10)
  OutwardOptions outward;    // which way the surface of a cloud faces
  CutOptions cut;            // of partial rims, and across handles (13, 16, 17, 31, 35)
  // Selection.
  AngleOptions angles;           // between cloud and model at the rim
  ChoiceOptions choice;          // by angles (9, 33)
  SampledRegionOptions sampled;  // by samples, where angles do not tell (33)
  IslandOptions islands;         // regions inside a scan that its samples contradict (27)
  RegionOverrides overrides;     // of one update alone: a session's are given with its clouds
  // Reconstruction.
  ReplaceOptions replace;          // vertices without a region, and at the rim (11)
  OverlookedOptions overlooked;    // vertices that stay amid new samples (3, 36)
  UnchangedRestOptions unchanged;  // what goes although it was neither scanned nor changed (37)
  SightOptions sight;              // what samples saw through (24)
  CrowdedOptions crowded;          // samples in layers (25)
  ReconstructOptions reconstruct;  // of the updated model: the defaults for closed models
  // What is told of the result.
  UnscannedOptions unscanned;          // what went though nothing was scanned there (21)
  UnusedChangeOptions unused_changes;  // what was scanned and is not on the surface (28)
  ContradictedOptions contradicted;    // samples that contradict each other (29)
  ClosedOpeningOptions openings;       // openings of the model that are closed
  GapOptions gaps;                     // of the scan that the surface bridges (23)
  HandleOptions handles;               // that the replaced parts do not explain (22)
  ShiftOptions shift;                  // scans that are moved off the model (23)
};

// As near to the paper as options go: surfaces of clouds and model in Mode::paper, rim points
// located among the facets at the nearest vertex, no long edges trimmed, no samples set aside (in
// rows of a scanner, where they are dense, in layers), sides of rims told by angles alone. Every
// other departure stays (docs/departures.md, "With --mode paper").
UpdateOptions paper_update_options();

struct UpdateResult {
  UpdateStatus status = UpdateStatus::ok;
  std::string message;  // why it is not ok: one line that says what, where and what to do
  TriangleMesh mesh;    // the updated model, of input points, bit for bit; empty unless ok
  std::vector<std::string> warnings;  // one line each

  std::vector<CloudReport> clouds;  // in the order given
  Regions regions;                  // of the initial model
  RegionChoice choice;
  std::vector<RegionId> replaced_groups;  // under any cloud
  std::vector<RegionId> islands;          // of these, those that go by part_contradicted_islands()

  // Each vertex of the initial model in the updated one; none: replaced, or not on its surface.
  IdVector<VertexId, VertexId> vertex_map;
  Replacement replacement;  // counts, and the updated points
  OverlookedVertices overlooked;
  UnscannedLosses unscanned;
  UnusedChanges unused_changes;
  BridgedGaps gaps;
  // Euler numbers (update/model/euler_number.h).
  std::ptrdiff_t euler_before = 0;
  std::ptrdiff_t euler = 0;
  std::size_t unexplained_handles = 0;  // of a model with open edges always 0
  std::size_t sampled_handles = 0;      // of these, those that the samples show (HandleOptions)
  ClosedOpenings closed_openings;       // a vertex of the initial model is named
  LooseParts loose_parts;               // a vertex of the updated one
  CrowdedSamples crowded;               // looked for where there were such handles or parts
  // Of the updated points, without its mesh; counts of duplicates and unused points are here.
  ReconstructResult reconstruction;
};

// Updates `model`, a closed mesh oriented outward (others: update/model/orient_outward.h), by
// `clouds` registered to it, each of which covers a part of the model and overlaps the rest along
// its rim. Vertices of the result: kept vertices in the order of the model, then cloud points in
// the order given, without those not on the surface or left out (CrowdedOptions). Every edge of the
// result is balanced (reconstruct_tight), whatever the model was.
// Progress: its four steps are "boundary_detection", "overlapping_facets",
// "segmentation_and_selection" and "reconstruction"; stages report below them. The first three come
// again where joined clouds have to be taken one by one, and where a refused one lies in layers;
// stages of the last one come again, below "without_crowded" and then as before, where samples in
// layers are left out.
// Errors: InputError for no cloud, a cloud that cannot be triangulated (not finite; too few points
// or all on one line, unless it overlaps another cloud), a model without triangles, with bad
// indices or a coordinate that is not finite, a model or cloud whose largest coordinate is not in
// [2^-200, 2^200], options out of range (stage_options.h). Complexity: O(n log n) expected for n
// points in all. Deterministic for any thread count; the order of model and clouds matters for
// numbering only, and of several clouds that fail alike the first is named. Source: Woo & Dey 2005,
// section 3. What is decided otherwise and why: docs/departures.md.
UpdateResult update_model(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                          const UpdateOptions& options = {}, const Execution& execution = {});

// The updated surface, and how many triangles it has, whether or not its mesh is there: it may be
// left out if it is connected, has no open edges, and all points are its vertices.
struct UpdatedSurface {
  ReconstructResult result;
  std::size_t triangles = 0;
  // If the mesh is left out: those with a vertex of a cloud, and others, perhaps. Their owner keeps
  // them until it is asked for the next surface.
  std::span<const Triangle> changed = {};
};

// The two parts of an update that cost in proportion to the model and not to the change. Whoever
// keeps what they need from one update to the next (update_session.h) puts in something faster that
// gives the same.
struct UpdateParts {
  // The index of the model, always the same; called after the clouds' surfaces.
  std::function<const ModelIndex&(const Execution& execution)> index;
  // reconstruct_tight_with_labels of the updated points and what is known of the model. May leave
  // out the mesh, and what the result has of each vertex, if each point is a vertex. Each call
  // starts from the model; the last one is that of the result.
  std::function<UpdatedSurface(const Replacement& replacement, const OldSurface& old,
                               const Execution& execution)>
      reconstruct;
  // Whether the coordinates of the model are known to be of ordinary size.
  bool ordinary_size = false;
};

// update_model with these parts. The index is that of `model`.
UpdateResult update_model(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
                          const UpdateParts& parts, const UpdateOptions& options = {},
                          const Execution& execution = {});

}  // namespace cocoon
