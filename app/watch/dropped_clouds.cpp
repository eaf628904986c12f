#include "app/watch/dropped_clouds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>

#include "app/report/update_findings.h"
#include "app/report/update_report.h"
#include "geom/messages/counted.h"

namespace cocoon::app {

namespace {

StraySamples total_of(const std::vector<StraySamples>& strays) {
  StraySamples total;
  for (const StraySamples& some : strays) {
    total.outliers += some.outliers;
    total.in_small_parts += some.in_small_parts;
    total.small_parts += some.small_parts;
  }
  return total;
}

}  // namespace

std::string DroppedClouds::name() const { return fmt::format("{}", fmt::join(names, ", ")); }

DroppedClouds DroppedClouds::only(std::size_t k) const {
  const auto now = std::chrono::steady_clock::now();
  return {now, {files[k]}, {names[k]}, {clouds[k]}, {thinned[k]}, {strays[k]}, false};
}

std::string told_applied(const DroppedClouds& dropped, const SessionUpdate& update,
                         const CloudFilter& filter, const UpdateOptions& options) {
  const UpdateResult& result = update.result;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - dropped.start;
  std::string line =
      fmt::format("{}: {} points for {} of the model, {} triangles new, {} gone, {:.2f} s",
                  dropped.name(), result.reconstruction.points - result.replacement.vertices.kept,
                  result.replacement.vertices.replaced, update.change.added.size(),
                  update.change.removed.size(), time.count());
  const std::string topology = topology_change(result);
  if (!topology.empty()) line += "; " + topology;
  if (filter.thin) {
    const std::size_t thinned =
        std::accumulate(dropped.thinned.begin(), dropped.thinned.end(), std::size_t{0});
    line += fmt::format("; {} left out by --thin", counted(thinned, "point"));
  }
  if (filter.strays) {
    line += fmt::format("; {} left out as noise", told_strays(total_of(dropped.strays)));
  }
  for (const std::string& note : notes_of_clouds(result, dropped.names, options)) {
    line += "; note: " + note;
  }
  for (const std::string& warning : result.warnings) {
    line += "; warning: " + with_cloud_names(warning, dropped.names);
  }
  return line;
}

}  // namespace cocoon::app
