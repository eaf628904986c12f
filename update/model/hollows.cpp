#include "update/model/hollows.h"

#include <algorithm>
#include <vector>

#include "geom/mesh_measure.h"
#include "geom/point.h"

namespace cocoon {

bool has_hollow(const ModelIndex& model) {
  if (model.is_connected()) return false;
  const TriangleMesh& mesh = model.mesh();
  struct Part {
    Point apex;
    double volume = 0;
    bool is_begun = false;
  };
  std::vector<Part> parts;
  for (const TriangleId t : mesh.triangles.ids()) {
    if (model.component(t) >= parts.size()) parts.resize(model.component(t) + 1);
    Part& part = parts[model.component(t)];
    if (!part.is_begun) part = {mesh.points[mesh.triangles[t][0]], 0, true};
    part.volume += volume_over(mesh, t, part.apex);
  }
  return std::any_of(parts.begin(), parts.end(), [](const Part& p) { return p.volume < 0; });
}

}  // namespace cocoon
