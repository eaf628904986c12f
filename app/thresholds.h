// Thresholds of the Cocone stages and of the clean-up as options of the command line. Rarely
// needed; each is a field of the library's options, whose header says what it does.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <variant>

#include "app/json_report.h"
#include "cocone/reconstruct.h"

namespace cocoon::app {

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
  Field (*field)(ReconstructOptions&);
};

// All of them, with unique names, in the order of the stages. O(1).
std::span<const Threshold> thresholds();

// Sets those given, by name. Precondition: the names are among thresholds().
void set_thresholds(ReconstructOptions& options, const std::map<std::string, double>& given);

// What was used, given or not.
void add_thresholds(JsonReport& report, ReconstructOptions options);

}  // namespace cocoon::app
