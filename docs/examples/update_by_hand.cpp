// An update stage by stage, in the order of Woo & Dey 2005, section 3: one cloud, whose rim is
// complete. update_model does this in one call, and handles incomplete rims, too.
#include <cstdio>
#include <numbers>
#include <vector>

#include "cocone/boundary_loops.h"
#include "cocone/reconstruct.h"
#include "docs/examples/bump.h"
#include "update/choose_regions.h"
#include "update/cloud_surface.h"
#include "update/model/model_index.h"
#include "update/overlapping_facets.h"
#include "update/regions/kept_surface.h"
#include "update/replace_points.h"
#include "update/rim_angles.h"
#include "update/segment_model.h"
#include "update/trace_border.h"
#include "update/update_model.h"

int main() {
  const cocoon::TriangleMesh model = cocoon::reconstruct_tight(cap(2000, 4, 0)).mesh;
  const std::vector<std::vector<cocoon::Point>> clouds = {cap(6000, 0.8, 0.3)};
  const cocoon::ModelIndex index(model);

  // 3.2: the open surface of the cloud, and the loop along which it ends.
  const cocoon::CloudSurface surface = cocoon::cloud_surface(clouds[0]);
  const std::vector<cocoon::CloudRim> rims = {surface.rim};
  std::printf("%zu loop of the surface, %zu of its rim\n",
              cocoon::boundary_loops(surface.mesh).rims(), surface.rim.loops.size());

  // 3.3: the facets of the model under the rim, joined to a closed band.
  const cocoon::Overlap overlap = cocoon::overlapping_facets(index, rims[0]);
  const cocoon::Border border = cocoon::trace_border(index, rims[0], overlap);

  // 3.4: what the band divides the model into; the mean angle that each region makes with the
  // cloud at the rim; the smaller one is that of the region under it.
  const cocoon::Regions regions = cocoon::segment_model(index, border.facets);
  std::vector<cocoon::RegionAngles> angles;
  for (std::size_t l = 0; l < rims[0].loops.size(); ++l) {
    angles.push_back(cocoon::mean_rim_angles(index, regions, rims[0].loops[l], border.loops[l]));
  }
  const cocoon::RegionChoice choice = cocoon::choose_regions(angles, clouds.size());
  for (const cocoon::RegionVerdict& verdict : choice.clouds[0].regions) {
    std::printf("group %u: mean angle %.2f degrees, %s\n", verdict.region.value,
                verdict.mean_angle * 180 / std::numbers::pi,
                verdict.under_cloud ? "replaced" : "kept");
  }

  // Its vertices go, the cloud comes, and all points get a closed surface. Where the samples leave
  // that in doubt, the triangles of the model that stay tell the sides.
  const cocoon::Replacement replacement =
      cocoon::replace_points(index, regions, choice, rims, clouds, clouds);
  const cocoon::KeptSurface kept(index, regions, choice, replacement);
  const cocoon::TriangleMesh updated =
      cocoon::reconstruct_tight_with_labels(replacement.points, kept.told().labels).mesh;

  std::printf("%zu facets under the rim, %zu points replaced, %zu triangles\n",
              overlap.facets.size(), replacement.vertices.replaced, updated.triangles.size());
  return updated == cocoon::update_model(model, clouds).mesh ? 0 : 1;
}
