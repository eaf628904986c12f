// Points on a torus become a closed mesh, and the mesh gets its certificate; and what can be asked
// for besides: a proof that it keeps what Tight Cocone promises, and what is doubtful about it.
#include "cocone/reconstruct.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "cocone/checks/surface_doubts.h"
#include "geom/mesh_check.h"

std::vector<cocoon::Point> torus(int around, int across) {
  std::vector<cocoon::Point> points;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around;
      const double v = 2 * std::numbers::pi * (j + 0.5 * (i % 2)) / across;
      const double r = 2 + std::cos(v);
      points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
  }
  return points;
}

int main() {
  const std::vector<cocoon::Point> points = torus(80, 40);
  cocoon::ReconstructOptions options;
  options.verify = true;
  const cocoon::ReconstructResult result = cocoon::reconstruct_tight(points, options);
  if (result.status != cocoon::SurfaceStatus::ok) return 1;

  const cocoon::MeshReport report = cocoon::mesh_check(result.mesh);
  std::printf("%zu points, %zu triangles, watertight: %s, genus %zu\n", points.size(),
              result.mesh.triangles.size(), report.watertight ? "yes" : "no",
              report.genus.value_or(99));
  const cocoon::SurfaceDoubts doubts = cocoon::surface_doubts(result, points);
  std::printf("verified: %s; %zu samples at gaps, noise %.2f spacings\n",
              result.verification.ok() ? "yes" : "no", doubts.gap_samples, doubts.roughness / 0.7);
  const bool is_right = report.is_closed_manifold() && report.genus == 1U;
  return is_right && result.verification.ok() && doubts.gap_samples == 0 ? 0 : 1;
}
