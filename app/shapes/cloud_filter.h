// --thin and --noise robust of `update` and `watch`: clouds without samples that are too close to
// others, and without stray ones.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/arguments/thresholds.h"
#include "app/command_line.h"
#include "app/job.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "io/vertex_properties.h"
#include "update/stray_samples.h"

namespace cocoon::app {

struct CloudFilter {
  std::optional<double> thin;          // done first, if there is a distance
  std::optional<StrayOptions> strays;  // none: they stay
};

CloudFilter cloud_filter(const CloudFilterArguments& arguments);

// Default thresholds of the filter of strays, which are not those of reconstructions.
StageOptions cloud_filter_defaults();

// The options of the filter, in the section "parameters", and "input/thinned_points".
void report_cloud_filter(JsonReport& report, const CloudFilter& filter, std::size_t thinned_points);

// What was left out of one cloud, as an entry of "noise/clouds" of the report.
void append_strays(JsonReport& report, const StraySamples& strays, std::size_t kept_points);

// "2 outliers, and 14 points in 3 small parts"; only what there is, "nothing" if there is nothing.
std::string told_strays(const StraySamples& strays);

// Takes them out of the cloud read from `name`. Throws InputError, which names the file, as
// stray_samples().
StraySamples leave_out_strays(const std::string& name, std::vector<Point>& cloud,
                              const StrayOptions& options, const Execution& execution);

// Takes samples too close to others, and stray ones, out of the clouds (with their properties, a
// table for each cloud; none: there are none), as the filter says. Counts go to the report, of
// strays to section "noise", and to the summary. Returns what was left out of each as stray; empty
// without that filter.
std::vector<StraySamples> filter_clouds(Job& job, const CloudFilter& filter,
                                        const std::vector<std::string>& names,
                                        std::vector<std::vector<Point>>& clouds,
                                        std::span<VertexProperties> properties);

// Whether a cloud is no scan but the model itself, with all of its vertices, as where somebody
// gives it beside the session that has it. Noise may give it a rim, and then it would replace
// itself. Complexity: O(1) for clouds with fewer points, else O(n log n).
bool is_model_itself(const std::vector<Point>& cloud, const TriangleMesh& model);

}  // namespace cocoon::app
