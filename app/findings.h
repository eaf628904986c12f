// What a user should know about a reconstruction before relying on it, in words.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/job.h"
#include "cocone/checks/surface_doubts.h"

namespace cocoon::app {

struct Finding {
  std::string kind;     // stable: "sparse", "noise", "fragments", "unused", "contacts"
  std::string message;  // one line: what, how much, where, what to do
  std::size_t count = 0;
  std::vector<DoubtfulSpot> spots;  // worst first
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

struct FindingLimits {
  // Noise as a share of the spacing: here surfaces through all points begin to fail.
  double noise = 0.2;
  // The share of the points that are boundary samples: places here and there have less.
  double sparse_share = 0.05;
};

// Nothing for a surface that is what it should be. `points`: how many there were, duplicates apart.
std::vector<Finding> findings_of(const SurfaceDoubts& doubts, std::size_t points,
                                 NoiseFilter filter, const FindingLimits& limits = {});

// As the array "findings" of the report, which is empty if there are none: kind, message, count,
// spots (at, count, size).
void add_findings(JsonReport& report, const std::vector<Finding>& findings);

// The same, and as warnings in the summary.
void report_findings(Job& job, const std::vector<Finding>& findings);

}  // namespace cocoon::app
