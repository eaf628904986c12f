#include "app/shapes/thin_cloud.h"

#include <cstdint>
#include <fmt/format.h>

#include "geom/box.h"
#include "geom/errors.h"
#include "geom/messages/counted.h"
#include "geom/search/thin_points.h"

namespace cocoon::app {

namespace {

constexpr std::size_t fewest_points = 4;  // of a surface

std::string refusal(const std::string& name, double distance, const std::vector<Point>& cloud,
                    std::size_t kept) {
  return fmt::format(
      "{}: --thin {} leaves {} of {}; the cloud is {:.3g} across: give the distance that its "
      "samples should have from each other",
      name, distance, kept, counted(cloud.size(), "point"), norm(box_of(cloud).size()));
}

}  // namespace

std::size_t thin_cloud(const std::string& name, double distance, std::vector<Point>& cloud,
                       VertexProperties* properties) {
  const std::vector<PointId> kept = thin_points(cloud, distance);
  if (kept.size() < fewest_points && cloud.size() >= fewest_points) {
    throw InputError(refusal(name, distance, cloud, kept.size()));
  }
  std::vector<std::uint8_t> stays(cloud.size(), 0);
  std::vector<Point> left;
  left.reserve(kept.size());
  for (const PointId p : kept) {
    stays[p.index()] = 1;
    left.push_back(cloud[p.index()]);
  }
  if (properties != nullptr) *properties = select_properties(*properties, stays);
  const std::size_t gone = cloud.size() - left.size();
  cloud = std::move(left);
  return gone;
}

std::size_t thin_input(Job& job, const std::string& name, const std::optional<double>& distance,
                       std::vector<Point>& cloud, VertexProperties* properties) {
  if (!distance) return 0;
  const std::size_t points = cloud.size();
  const std::size_t gone = timed(job.execution(), "thin",
                                 [&] { return thin_cloud(name, *distance, cloud, properties); });
  job.say("thin: {}: {} of {} left out", name, gone, counted(points, "point"));
  return gone;
}

void add_thinning(JsonReport& report, const std::optional<double>& distance,
                  std::size_t thinned_points) {
  if (!distance) return;
  report.set("parameters/thin", *distance);
  report.set("input/thinned_points", thinned_points);
}

}  // namespace cocoon::app
