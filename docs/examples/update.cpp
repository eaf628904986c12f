// A ball grows a bump: the old model, a scan of the bump, and the updated model.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "cocone/reconstruct.h"
#include "update/update_model.h"

// Evenly spread over the unit sphere, up to `reach` radians from the north pole; within 0.6 radians
// moved outward to a bump of height `bump`.
std::vector<cocoon::Point> cap(int n, double reach, double bump) {
  std::vector<cocoon::Point> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2.0 * i + 1) / n;
    const double latitude = std::acos(z);
    if (latitude > reach) break;
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1 - z * z);
    const double rise = std::min(1.0, latitude / 0.6) * std::numbers::pi;
    const double height = 1 + bump * (std::cos(rise) + 1) / 2;
    points.push_back(height * cocoon::Vec3{r * std::cos(angle), r * std::sin(angle), z});
  }
  return points;
}

int main() {
  const cocoon::TriangleMesh model = cocoon::reconstruct_tight(cap(2000, 4, 0)).mesh;
  const std::vector<std::vector<cocoon::Point>> clouds = {cap(6000, 0.8, 0.3)};

  const cocoon::UpdateResult update = cocoon::update_model(model, clouds);
  if (update.status != cocoon::UpdateStatus::ok) {
    std::printf("%s\n", update.message.c_str());
    return 1;
  }
  for (const cocoon::GroupAngle& group : update.clouds[0].groups) {
    std::printf("group %u: mean angle %.2f degrees, %s\n", group.group.value, group.mean_angle_deg,
                group.under_cloud ? "replaced" : "kept");
  }
  std::printf("%zu points replaced, %zu triangles in the updated model\n",
              update.replacement.replaced, update.mesh.triangles.size());
  return update.replaced_groups.size() == 1 ? 0 : 1;
}
