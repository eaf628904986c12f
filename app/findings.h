// What a user should know about a reconstruction before relying on it, in words.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/job.h"
#include "cocone/surface_doubts.h"

namespace cocoon::app {

struct Finding {
  std::string kind;     // stable: "sparse", "noise", "fragments", "unused", "contacts"
  std::string message;  // one line: what, how much, where, what to do
  std::size_t count = 0;
  std::vector<DoubtfulSpot> spots;  // worst first
};

// Nothing for a surface that is what it should be. `points`: how many there were, duplicates apart;
// `noise_filtered`: whether --noise robust was used.
std::vector<Finding> findings_of(const SurfaceDoubts& doubts, std::size_t points,
                                 bool noise_filtered);

// As warnings in the summary, and as the array "findings" of the report, which is empty if there
// are none: kind, message, count, spots (at, count, size).
void report_findings(Job& job, const std::vector<Finding>& findings);

}  // namespace cocoon::app
