#include "update/steps/update_run.h"

#include "update/report/update_messages.h"

namespace cocoon {

UpdateRun::UpdateRun(const TriangleMesh& mesh, std::span<const std::vector<Point>> of_user,
                     const UpdateOptions& update_options)
    : model(mesh),
      given(of_user),
      joined(each_by_itself(of_user.size())),
      clouds(of_user),
      options(update_options) {
  begin_clouds();
}

UpdateRun::UpdateRun(const TriangleMesh& mesh, std::span<const std::vector<Point>> of_user,
                     std::vector<JoinedCloud> overlapping, const UpdateOptions& update_options)
    : model(mesh), given(of_user), joined(std::move(overlapping)), options(update_options) {
  for (const JoinedCloud& cloud : joined) joined_samples.push_back(samples_of(cloud, given));
  clouds = joined_samples;
  begin_clouds();
}

void UpdateRun::begin_clouds() {
  result.clouds.resize(clouds.size());
  layers.assign(clouds.size(), options.cloud.layers);
}

UpdateResult UpdateRun::take_result() {
  tell_members();
  return std::move(result);
}

void UpdateRun::tell_members() {
  result.clouds = reports_of_members(std::move(result.clouds), joined, given.size());
  const std::vector<CloudChoice> of_joined = std::move(result.choice.clouds);
  result.choice.clouds.resize(of_joined.empty() ? 0 : given.size());
  for (std::size_t j = 0; j < of_joined.size(); ++j) {
    for (const std::size_t c : joined[j].members) result.choice.clouds[c] = of_joined[j];
  }
}

std::string UpdateRun::name_of_cloud(std::size_t c) const {
  return name_of_clouds(joined[c].members, given.size());
}

std::string UpdateRun::name_of_loop(std::size_t c, std::size_t l) const {
  return name_of_cloud(c) + ", " + cocoon::name_of_loop(result.clouds[c].surface.rim.loops[l]);
}

bool UpdateRun::fail(UpdateStatus status, std::string message) {
  if (result.status == UpdateStatus::ok || status < result.status) {
    result.status = status;
    result.message = std::move(message);
  }
  return false;
}

void UpdateRun::warn_of_cloud(std::size_t c, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) warn(name_of_cloud(c) + ": " + warning);
}

std::vector<RegionAngles> UpdateRun::measure_angles(const Regions& regions) const {
  std::vector<RegionAngles> angles;
  for_each_border_loop([&](std::size_t c, std::size_t l) {
    angles.push_back(mean_rim_angles(*index, regions, result.clouds[c].surface.rim.loops[l],
                                     borders[c].loops[l], options.angles));
    angles.back().cloud = static_cast<std::uint32_t>(c);
  });
  return angles;
}

OutwardNormals UpdateRun::outward() const {
  return [this](std::size_t c) {
    return outward_normals(*index, clouds[c], result.clouds[c].surface, rims.overlaps[c],
                           options.outward);
  };
}

}  // namespace cocoon
