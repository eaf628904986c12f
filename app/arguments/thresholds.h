// Thresholds of single stages as options of the command line. Rarely needed; each is a field of the
// library's options, whose header says what it does.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/json_report.h"
#include "cocone/boundary_loops.h"
#include "cocone/checks/surface_doubts.h"
#include "cocone/noise_filter.h"
#include "cocone/reconstruct.h"

namespace cocoon::app {

// The options of the library that have thresholds.
struct StageOptions {
  ReconstructOptions surface;
  NoiseOptions noise;
  BoundaryLoopOptions loops;
  SurfaceDoubtOptions doubts;
};

// What a threshold is of.
enum class ThresholdUse {
  cocone,       // every surface
  tight,        // watertight ones
  second_look,  // of these, where samples contradict each other
  clean_up,     // of these, unless it is left out
  outliers,     // left out before them, by --noise robust; of the clouds of updates, too
  noise,        // the rest of that filter
  loops,        // the command boundary
  findings,     // what is said of the result
};

enum class ThresholdKind {
  number,
  angle,  // in degrees; the library has its cosine
  whole,  // a number without fraction
};

struct Threshold {
  using Field = std::variant<double*, int*, std::size_t*>;
  // --name VALUE; the report has parameters/name, with _ for - (and _deg after angles).
  const char* name;
  const char* meaning;
  double low;  // the values allowed
  double high;
  ThresholdKind kind;
  ThresholdUse use;
  Field (*field)(StageOptions&);
};

// All of them, with unique names, in the order of the stages. O(1).
std::span<const Threshold> thresholds();

// The options by which some of one use were given: "--name", in the order of the table.
std::vector<std::string> given_thresholds(ThresholdUse use,
                                          const std::map<std::string, double>& given);

// The same, behind others.
void append_given(ThresholdUse use, const std::map<std::string, double>& given,
                  std::vector<std::string>& options);

// Sets those given, by name. Precondition: the names are among thresholds().
void set_thresholds(StageOptions& options, const std::map<std::string, double>& given);

// Throws UsageError if two that bound a range are in the wrong order.
void require_order(const StageOptions& options);

// Its value as people give it: angles in degrees.
double told_value(const Threshold& threshold, StageOptions options);

// Those of one use, given or not.
void add_thresholds(JsonReport& report, ThresholdUse use, StageOptions options);

}  // namespace cocoon::app
