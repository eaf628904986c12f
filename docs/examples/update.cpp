// A ball grows a bump: the old model, a scan of the bump, and the updated model.
#include <cstdio>
#include <vector>

#include "cocone/reconstruct.h"
#include "docs/examples/bump.h"
#include "update/update_model.h"

int main() {
  const cocoon::TriangleMesh model = cocoon::reconstruct_tight(cap(2000, 4, 0)).mesh;
  const std::vector<std::vector<cocoon::Point>> clouds = {cap(6000, 0.8, 0.3)};

  const cocoon::UpdateResult update = cocoon::update_model(model, clouds);
  if (update.status != cocoon::UpdateStatus::ok) {
    std::printf("%s\n", update.message.c_str());
    return 1;
  }
  for (const cocoon::RegionVerdict& group : update.clouds[0].groups) {
    std::printf("group %u: mean angle %.2f degrees, %s\n", group.region.value,
                group.mean_angle_deg(), group.under_cloud ? "replaced" : "kept");
  }
  std::printf("%zu points replaced, %zu triangles in the updated model\n",
              update.replacement.vertices.replaced, update.mesh.triangles.size());
  return update.replaced_groups.size() == 1 ? 0 : 1;
}
