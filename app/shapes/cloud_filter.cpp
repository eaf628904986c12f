#include "app/shapes/cloud_filter.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "app/files/files.h"
#include "app/shapes/thin_cloud.h"
#include "geom/messages/counted.h"
#include "geom/search/equal_points.h"

namespace cocoon::app {

namespace {

StageOptions stages_of(const StrayOptions& options) {
  StageOptions stages;
  stages.noise.neighbors = options.neighbors;
  stages.noise.outlier_ratio = options.outlier_ratio;
  return stages;
}

std::optional<StrayOptions> stray_options(const CloudFilterArguments& arguments) {
  if (arguments.noise == NoiseHandling::none) return std::nullopt;
  StrayOptions options;
  StageOptions stages = stages_of(options);
  set_thresholds(stages, arguments.thresholds);
  options.neighbors = stages.noise.neighbors;
  options.outlier_ratio = stages.noise.outlier_ratio;
  return options;
}

}  // namespace

CloudFilter cloud_filter(const CloudFilterArguments& arguments) {
  return {arguments.thin, stray_options(arguments)};
}

StageOptions cloud_filter_defaults() { return stages_of({}); }

void report_cloud_filter(JsonReport& report, const CloudFilter& filter,
                         std::size_t thinned_points) {
  add_thinning(report, filter.thin, thinned_points);
  if (filter.strays) add_thresholds(report, ThresholdUse::outliers, stages_of(*filter.strays));
}

void append_strays(JsonReport& report, const StraySamples& strays, std::size_t kept_points) {
  JsonReport entry;
  entry.set("outliers", strays.outliers);
  entry.set("small_parts", strays.small_parts);
  entry.set("small_part_samples", strays.in_small_parts);
  entry.set("kept_points", kept_points);
  report.append("noise/clouds", entry);
}

std::string told_strays(const StraySamples& strays) {
  std::string told;
  if (strays.outliers > 0) told = counted(strays.outliers, "outlier");
  if (strays.small_parts > 0) {
    if (!told.empty()) told += ", and ";
    told += fmt::format("{} in {}", counted(strays.in_small_parts, "point"),
                        counted(strays.small_parts, "small part"));
  }
  return told.empty() ? "nothing" : told;
}

StraySamples leave_out_strays(const std::string& name, std::vector<Point>& cloud,
                              const StrayOptions& options, const Execution& execution) {
  StraySamples strays =
      naming_input(name, [&] { return stray_samples(cloud, options, {}, execution); });
  std::vector<Point> kept;
  kept.reserve(cloud.size());
  for (const PointId p : strays.kept.ids()) {
    if (strays.kept[p] != 0) kept.push_back(cloud[p.index()]);
  }
  cloud = std::move(kept);
  return strays;
}

std::vector<StraySamples> filter_clouds(Job& job, const CloudFilter& filter,
                                        const std::vector<std::string>& names,
                                        std::vector<std::vector<Point>>& clouds,
                                        std::span<VertexProperties> properties) {
  std::size_t thinned = 0;
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    thinned += thin_input(job, names[c], filter.thin, clouds[c],
                          properties.empty() ? nullptr : &properties[c]);
  }
  report_cloud_filter(job.report(), filter, thinned);
  std::vector<StraySamples> all;
  if (!filter.strays) return all;
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    const StraySamples& strays =
        all.emplace_back(leave_out_strays(names[c], clouds[c], *filter.strays, job.execution()));
    append_strays(job.report(), strays, clouds[c].size());
    job.say("noise: {}: {} left out", names[c], told_strays(strays));
    if (!properties.empty()) properties[c] = select_properties(properties[c], strays.kept.raw());
  }
  return all;
}

bool is_model_itself(const std::vector<Point>& cloud, const TriangleMesh& model) {
  if (cloud.size() < model.points.size()) return false;
  const std::vector<Point> samples = distinct_points(cloud);
  const std::vector<Point> vertices = distinct_points(model.points.span());
  return std::includes(samples.begin(), samples.end(), vertices.begin(), vertices.end());
}

}  // namespace cocoon::app
