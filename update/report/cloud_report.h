// What an update tells of each of its clouds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "update/checks/contradicted_samples.h"
#include "update/checks/rim_shift.h"
#include "update/checks/unexplained_handles.h"
#include "update/choose_regions.h"
#include "update/cloud/scan.h"
#include "update/cloud_surface.h"
#include "update/cut_regions.h"
#include "update/joined_clouds.h"
#include "update/overlapping_facets.h"
#include "update/regions/loop_sides.h"
#include "update/trace_border.h"

namespace cocoon {

// One boundary loop of a cloud.
struct LoopReport {
  std::size_t edges = 0;
  double perimeter = 0;
  bool pin_hole = false;  // looked at as a rim; opened, if it is on the model (open_pin_holes)
  LoopMatch match = LoopMatch::off_model;
  std::size_t unmatched = 0;  // rim points too far from the model
  std::size_t covered = 0;    // of these, points on another cloud
  // By the regions before it is told that the cloud is to be cut, too; meaningful if on_model.
  Separation separation = Separation::separates;
};

struct CloudReport {
  // The cloud that tells of the surface and the rim of this one, too, since they overlap each
  // other (join_clouds). Then only regions, spacing and believed shift are told here, and those
  // are of both.
  std::optional<std::size_t> joined_with;
  CloudSurface surface;                        // with rim and trials
  std::vector<LoopReport> loops;               // as in surface.rim
  std::size_t boundary_points = 0;             // rim points
  std::vector<TriangleId> overlapping_facets;  // facets of the model with a rim point on them
  OverlapFigures overlap;
  double shift = 0;     // length of cloud_shift(); 0 if samples contradict it
  Vec3 believed_shift;  // cloud_shift(); zero if ShiftOptions::is_too_long()
  BorderFigures border;
  std::vector<RegionVerdict> groups;      // those it saw, in the order of ids
  std::vector<RegionId> replaced_groups;  // those under this cloud
  double margin_deg = 180;                // of its least clear loop; of all if it was cut or told
  bool is_told_by_samples = false;        // regions_under_samples(); false if a person told
  bool is_told_by_sure_angles = false;    // ChoiceOptions::sure_margin; false if a person told
  ContradictedSamples contradicted;       // its samples, on the updated model
  std::size_t compared_rims = 0;  // of its trials, by the doubt that they leave; 0: not asked
  std::size_t taken_rim = 0;      // of these; 0: the first, that was preferred before
  // If it was cut, alone or as the first of joined ones; without the labels.
  RegionCut cut;
};

std::vector<CloudRim> rims_of(std::span<const CloudReport> clouds);
// Of each cloud whether its rim is partial.
std::vector<std::uint8_t> partial_rims(std::span<const CloudReport> clouds);
// Whether its rim is whole, but a loop of it has the same region of the model on both sides.
bool runs_around_handle(const CloudReport& cloud);
// clouds[c] belongs to reports[c].
std::vector<Scan> scans_of(std::span<const std::vector<Point>> clouds,
                           std::span<const CloudReport> reports);
// The rims that form the border: of loops that are none of it only the place is left.
std::vector<CloudRim> border_rims_of(std::span<const CloudReport> clouds);

// What each of them put into the model; pin-holes are no rims.
std::vector<SewnPatch> patches_of(std::span<const CloudReport> clouds);

// The reports of the clouds given, from those of joined ones: the first of each takes over all that
// is told, points of joined clouds being those of its members one after the other.
std::vector<CloudReport> reports_of_members(std::vector<CloudReport> reports,
                                            std::span<const JoinedCloud> joined,
                                            std::size_t clouds);

// The clouds of whose samples the surface is that cloud c tells of: itself, and those joined with
// it, ascending. Complexity: O(clouds).
std::vector<std::size_t> members_told(std::span<const CloudReport> reports, std::size_t c);

// A point of a cloud given.
struct CloudPoint {
  std::size_t cloud = 0;
  std::size_t index = 0;
};

// Which point is meant where cloud c tells of its point p: one of its own, or one of those joined
// with it. clouds[c] belongs to reports[c]. Complexity: O(clouds).
CloudPoint point_told(std::span<const CloudReport> reports,
                      std::span<const std::vector<Point>> clouds, std::size_t c, PointId p);

// Enters what the stages found of a cloud. Complexity: O(what is entered).
void enter_overlap(const Overlap& overlap, CloudReport& report);
void enter_shift(const Vec3& shift, const ShiftOptions& options, CloudReport& report);
void enter_choice(const CloudChoice& choice, CloudReport& report);

}  // namespace cocoon
