// --thin and --noise robust of `update` and `watch`: clouds without samples that are too close to
// others, and without stray ones.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments/thresholds.h"
#include "app/command_line.h"
#include "app/job.h"
#include "geom/point.h"
#include "update/stray_samples.h"

namespace cocoon::app {

struct CloudFilter {
  std::optional<double> thin;          // done first, if there is a distance
  std::optional<StrayOptions> strays;  // none: they stay
};

CloudFilter cloud_filter(const CloudFilterArguments& arguments);

// Default thresholds of the filter of strays, which are not those of reconstructions.
StageOptions cloud_filter_defaults();

// The options of the filter of strays, as "parameters/noise_*" of the report.
void add_cloud_filter(JsonReport& report, const StrayOptions& options);

// What was left out of one cloud, as an entry of "noise/clouds" of the report.
void append_strays(JsonReport& report, const StraySamples& strays, std::size_t kept_points);

// "2 outliers, and 14 points in 3 small parts"; only what there is, "nothing" if there is nothing.
std::string told_strays(const StraySamples& strays);

// Takes them out of the cloud read from `name`. Throws InputError, which names the file, as
// stray_samples().
StraySamples leave_out_strays(const std::string& name, std::vector<Point>& cloud,
                              const StrayOptions& options, const Execution& execution);

}  // namespace cocoon::app
