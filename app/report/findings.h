// What a user should know about a reconstruction before relying on it, in words.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/job.h"
#include "cocone/checks/surface_doubts.h"
#include "cocone/robust_cocone.h"
#include "geom/point.h"

namespace cocoon::app {

struct Finding {
  // stable: "sparse", "noise", "clumps", "fragments", "handles", "conflicts", "unused", "contacts"
  std::string kind;
  std::string message;  // one line: what, how much, where, what to do
  std::size_t count = 0;
  std::vector<DoubtfulSpot> spots;  // worst first
  // Most surfaces about which that is said are wrong somewhere. Else it is a note: most are right.
  bool warns = true;
};

// What to do if the samples are the vertices of a mesh.
inline constexpr const char* remedy_of_mesh =
    "or sample the triangles of this mesh (--densify SPACING)";

// Whether the user may filter noise (--noise robust), and has.
enum class NoiseFilter {
  no_noise,   // samples of a mesh (--densify)
  no_option,  // or nothing is left for it to do
  not_used,
  not_used_on_mesh,  // the same; the samples are the vertices of a mesh, which may be made dense
  used,
  of_strays,  // not used; it would leave out stray samples only
};

// Whether the filter is left to be tried, whatever the samples are.
bool is_filter_left(NoiseFilter filter);

struct FindingLimits {
  // Noise as a share of the spacing: here surfaces through all points begin to fail.
  double noise = 0.2;
  // Noise by itself does no harm: it is a warning where another one is, which it may explain. True:
  // always, where few surfaces have it.
  bool noise_alone = false;
  // The share of the points that are boundary samples: places here and there have less.
  double sparse_share = 0.05;
  // Shares of the samples that no disk of Cocone triangles surrounds. From the first on handles are
  // a warning, below it a note unless there are no such samples; from the second on any surface is
  // a guess.
  double handle_share = 0.075;
  double guess_share = 0.2;
  // Conflicts of inside and outside, as a share of the samples.
  double conflict_share = 0.003;
  // The share of the points that are not on the surface, unless a filter left them out.
  double unused_share = 0.1;
  // Edges so many medians long span what was not scanned: the longest of scans that see all of a
  // body have up to 14, of open scans 20 and more, but for coarse ones.
  double gap_edge = 15;
};

// Other options that a finding may name.
struct OptionsLeft {
  bool cavities = true;  // --cavities: not in paper mode, nor if it was given
  bool manifold = true;  // --manifold
  bool trim = false;     // --trim: of closed surfaces of points
  // If it was given: points that are on the surface no more.
  std::size_t trimmed_points = 0;
};

// Nothing for a surface that is what it should be. Causes (sparse, noise) are notes unless much of
// the surface is a guess or something else warns, too. `points`: how many there were, duplicates
// apart. Source of the limits: docs/stages/surface_doubts.md.
std::vector<Finding> findings_of(const SurfaceDoubts& doubts, std::size_t points,
                                 NoiseFilter filter, const FindingLimits& limits = {},
                                 const OptionsLeft& left = {});

// That the noise filter left out clumps (noise.clumps > 0), and where the largest is: it may be a
// small body. `points`: those that the filter was given.
Finding clumps_finding(const NoiseCounters& noise, Points points);

// As the array "findings" of the report, which is empty if there are none: kind, message, count,
// spots (at, count, size), warning (whether it is one).
void add_findings(JsonReport& report, const std::vector<Finding>& findings);

// A line of the summary: "warning: ...", which the reports keep, or "note: ...".
void tell(Job& job, const Finding& finding);

// The same, and as warnings and notes in the summary.
void report_findings(Job& job, const std::vector<Finding>& findings);

}  // namespace cocoon::app
