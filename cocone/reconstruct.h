// From points to a surface in one call: the stages of this folder one after the other. Anything
// done here can be done by hand with the stages themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/checks/verify_surface.h"
#include "cocone/clean_up_cells.h"
#include "cocone/cocones.h"
#include "cocone/known_labels.h"
#include "cocone/peel_cells.h"
#include "cocone/prune_sharp_edges.h"
#include "cocone/second_look.h"
#include "cocone/umbrella.h"
#include "delaunay/delaunay.h"
#include "delaunay/triangulation.h"
#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// Outcomes that depend on the data; none is an exception.
enum class SurfaceStatus {
  ok,
  no_surface,  // no sample is interior: too sparse, too thin or too noisy for these options
  empty,       // a surface was begun, but nothing is left (tight: everything was peeled)
  refuted,     // asked for, its verification failed: a fault of this library or of the machine
};

enum class Mode {
  paper,   // as published: radius_mode = cocone, no deferred seeding, no second look, no cavities,
           // no clean-up, whatever the options say
  robust,  // the options as they are, but for what depends on others: effective_options()
};

// The defaults are for closed models; see open_cloud_defaults().
struct ReconstructOptions {
  Mode mode = Mode::robust;
  DelaunayOptions delaunay = {};
  CoconeOptions cocone = {};
  BoundaryOptions boundary = {};
  PruneOptions prune = {};
  GoodVertexOptions good_vertices = {};
  PeelOptions peel = {};
  CleanUpOptions clean_up = {};  // reconstruct_tight, robust mode only
  // reconstruct_tight, robust mode only, and only if radius_mode is tangent_plane.
  SecondLookOptions second_look = {};
  // reconstruct_tight, robust mode only: whether closed surfaces inside the body bound hollows of
  // it (open_cavities, after the clean-up). False, as in the paper: they are left out.
  bool keep_cavities = false;
  // reconstruct_tight_with_labels, where a foreign mesh tells (KnownLabels::is_foreign): at most so
  // often the clean-up is done again where what it tells makes the surface touch itself. 0: it
  // never yields.
  unsigned yield_rounds = 4;
  // reconstruct_tight_with_labels, where something is likely (KnownLabels::likely): if more than
  // this share of those cells lies on the other side of the surface, it is made again with them
  // known. A few may, at slivers.
  double max_contradicted_likely = 0.03;
  // It is taken if it has no more parts and handles, and no more unused vertices; for each part
  // that it has less, so many more of these are allowed.
  std::size_t max_unused_per_part = 10;
  // Verify triangulation and surface (verify_surface.h) before they are believed. What is refuted
  // is not delivered: the mesh is left empty.
  bool verify = false;
};

// Throws InputError for options of the stages that are out of range (inputs/stage_inputs.h); the
// message begins with the stage. O(1).
void require_options(const char* stage, const ReconstructOptions& options);

// What the stages get: in mode paper some options are as published, whatever they say. Throws
// InputError as require_options(), so all that take these options do.
ReconstructOptions effective_options(ReconstructOptions options);

// For clouds whose surface has a rim (a scan from one side, the added cloud of an update):
// rho = 0.3, alpha = 30 degrees, radius_mode = cocone. Smaller rho (0.2, 0.13) finds smaller holes.
ReconstructOptions open_cloud_defaults();

// What the stages counted.
struct ReconstructCounters {
  DelaunayCounters delaunay;
  std::size_t hull_vertices = 0;
  std::size_t degenerate_poles = 0;      // hull normals that cancel
  std::size_t exact_centers = 0;         // circumcenters recomputed
  std::size_t dual_facet_fallbacks = 0;  // circumcenters of a facet instead
  std::size_t boundary_samples = 0;
  std::size_t ratio_failed = 0;
  std::size_t recovered_samples = 0;  // interior by the second phase
  std::size_t candidates = 0;
  std::size_t pruned = 0;
  std::size_t umbrellas = 0;                  // vertices with an umbrella of candidates
  std::size_t surface_triangles = 0;          // of the Cocone surface
  std::size_t surface_walks = 0;              // connected pieces of the manifold extraction
  std::size_t back_contacts = 0;              // tears of the surface, see extract_manifold.h
  std::size_t non_orientable_components = 0;  // reconstruct_cocone only
  // reconstruct_tight only:
  std::size_t good_vertices = 0;
  std::size_t demoted_vertices = 0;
  std::size_t unvisited_vertices = 0;  // good ones that no mark reached
  std::size_t marking_rounds = 0;
  std::size_t marking_conflicts = 0;
  std::size_t known_cells = 0;          // labeled beforehand, see mark_cells.h
  std::size_t likely_cells = 0;         // of which something is likely (known_labels.h),
  std::size_t contradicted_likely = 0;  // those on the other side of the surface without it,
  std::size_t heeded_likely = 0;        // and those taken for known therefore, all or none
  // Told by a foreign mesh, but left to good vertices, since the surface would touch
  // itself.
  std::size_t yielded_cells = 0;
  // No good ones, since known or likely cells contradict them, or hide them from all marks.
  std::size_t refuted_vertices = 0;
  std::size_t poor_cells = 0;
  std::size_t deferred_seeds = 0;
  // If there was a second look (second_look.h): the conflicts of the first, and 1 if all else here
  // is of the second, which was taken.
  std::size_t first_conflicts = 0;
  std::size_t second_look = 0;
  CleanUpCounters clean_up;
  CavityCounters cavities;
};

struct ReconstructResult {
  SurfaceStatus status = SurfaceStatus::ok;
  // Only vertices that a triangle uses, in the user's input order with the user's coordinates;
  // triangles in canonical order, counterclockwise seen from outside. Of the open surface, where
  // there is no outside, each component is oriented consistently.
  TriangleMesh mesh;
  IdVector<VertexId, PointId> point_of_vertex;       // first input point at each mesh vertex
  IdVector<VertexId, Vec3> normals;                  // n_p: unit, sign free
  IdVector<VertexId, std::uint8_t> boundary_sample;  // 1 = boundary sample, 0 = interior
  // Points where what is inside is contradicted (CellMarks::contradicted), on the surface or not;
  // of equal ones the first, ascending. Of the open surface none.
  std::vector<PointId> contradicted;
  std::size_t points = 0;         // given
  std::size_t duplicates = 0;     // points equal to an earlier one
  std::size_t unused_points = 0;  // different points not on the surface
  std::size_t vertices = 0;       // of the triangulation
  std::size_t tetrahedra = 0;     // finite cells
  ReconstructCounters counters;
  SurfaceVerification verification;  // if asked for
};

// The watertight surface (Tight Cocone): the boundary of a union of tetrahedra. Every edge has an
// even number of triangles, as many in one direction as in the other; `mesh` is closed, or empty
// with the status that says why. Presumes samples of closed surfaces: an open cloud is closed
// somehow. Progress: "delaunay", "poles", "cocone/cones", "boundary",
// "cocone/surface", "tight/marks", "tight/known" where labels are told and marks are in doubt,
// "tight/body" unless the surface is certain, "second_look" (with the others below it) where marks
// contradict each other, mostly instead of "tight/body", and "verify" if asked for.
// Coordinates of any finite size: beyond 2^100 or below 2^-100 the work is done on a copy scaled by
// a power of two, which changes nothing else.
// Errors: InputError as delaunay(), and if that scaling would lose bits: coordinates beyond 2^100
// beside others so small that no double holds both. Complexity: O(n log n) expected.
// Deterministic: a function of the set of points, but for the order of vertices, which is the
// user's. Source: Dey & Goswami 2003; Woo & Dey 2005, section 2.2.
ReconstructResult reconstruct_tight(Points points, const ReconstructOptions& options = {},
                                    const Execution& execution = {});

// The same from a triangulation that is there already; `points` are its input points, and it is
// that of working_scale(points) times them, else InputError if their numbers differ. Counters of
// `delaunay` stay zero. The faster, the nearer cells lie that are neighbors (canonical_order.h).
// Complexity: O(n).
ReconstructResult reconstruct_tight(const Triangulation& triangulation, Points points,
                                    const ReconstructOptions& options = {},
                                    const Execution& execution = {});

// Both where labels are known beforehand: after a change from triangles of the old mesh where
// nothing has changed (known_labels.h), of samples of a solid from its mesh (labels_of_solid.h).
// Where cells have no good vertex, or marks contradict each other as at walls thinner than the
// spacing, neither the marking nor the clean-up decides labels that are known otherwise. Those of a
// foreign mesh (KnownLabels::is_foreign) need not fit: the marking heeds them only if
// fewer samples are unused then, or fewer vertices contradicted, and where the surface would touch
// itself they yield to good vertices (yielded_cells). What is likely (KnownLabels::likely) is taken
// for known, too, if the surface contradicts it otherwise, and is no rougher then
// (checks/surface_roughness.h): in that case all after the extraction is done two or three times.
// Where nothing is in doubt, and marks reach every good vertex, `known` is not asked; nor is it in
// paper mode. It is asked once at most. If nothing else is in doubt than vertices that no mark
// reaches, only what is likely counts.
ReconstructResult reconstruct_tight_with_labels(Points points, const KnownLabelsSource& known,
                                                const ReconstructOptions& options = {},
                                                const Execution& execution = {});
ReconstructResult reconstruct_tight_with_labels(const Triangulation& triangulation, Points points,
                                                const KnownLabelsSource& known,
                                                const ReconstructOptions& options = {},
                                                const Execution& execution = {});

// The Cocone surface with its boundary: open where the cloud is. As above, but the step after
// "cocone/surface" is "cocone/mesh". Of a scan that is open the options should be
// open_cloud_defaults(), as the program and the update have them; by default they are those of
// closed surfaces, from which Tight Cocone goes on. Source: Amenta, Choi, Dey & Leekha 2002; Dey &
// Giesen 2001; Woo & Dey 2005, sections 2.1, 3.2.
ReconstructResult reconstruct_cocone(Points points, const ReconstructOptions& options = {},
                                     const Execution& execution = {});

}  // namespace cocoon
