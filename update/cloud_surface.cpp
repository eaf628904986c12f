#include "update/cloud_surface.h"

#include <utility>

#include "cocone/candidate_triangles.h"
#include "cocone/extract_manifold.h"
#include "cocone/poles.h"
#include "cocone/surface_mesh.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"

namespace cocoon {

namespace {

// What does not depend on rho.
struct Foundation {
  Triangulation triangulation;
  Dual dual;
  VertexStars stars;
  Poles poles;
  Cocones cocones;
};

Foundation lay_foundation(Points cloud, const ReconstructOptions& options,
                          const Execution& execution) {
  Foundation f;
  f.triangulation = delaunay(cloud, options.delaunay, execution).triangulation;
  f.dual = voronoi_dual(f.triangulation, execution);
  f.stars = vertex_stars(f.triangulation);
  f.poles = compute_poles(f.triangulation, f.dual, f.stars, execution);
  f.cocones = intersect_cocones(f.triangulation, f.dual, f.poles, options.cocone, execution);
  return f;
}

struct Trial {
  CloudSurface surface;
  RhoTrial report;
};

std::size_t stray_samples(const CloudSurface& surface) {
  IdVector<VertexId, std::uint8_t> on_rim(surface.mesh.points.size(), 0);
  for (const RimLoop& loop : surface.rim.loops) {
    for (const VertexId v : loop.vertices) on_rim[v] = 1;
  }
  std::size_t stray = 0;
  for (const VertexId v : on_rim.ids()) {
    if (surface.boundary_sample[v] != 0 && on_rim[v] == 0) ++stray;
  }
  return stray;
}

Trial try_rho(const Foundation& f, double rho, const CloudSurfaceOptions& options,
              const Execution& execution) {
  // 1. The Cocone surface with this rho.
  BoundaryOptions boundary_options = options.reconstruct.boundary;
  boundary_options.rho = rho;
  const BoundarySamples boundary = boundary_samples(f.triangulation, f.dual, f.stars, f.poles,
                                                    f.cocones, boundary_options, execution);
  const FacetSet candidates =
      candidate_triangles(f.triangulation, f.cocones, boundary.boundary, execution);
  const PrunedCandidates pruned =
      prune_sharp_edges(f.triangulation, candidates, options.reconstruct.prune, execution);
  const ManifoldSurface manifold =
      extract_manifold(f.triangulation, pruned.facets, pruned.umbrella, execution);
  SurfaceMesh sheet = surface_of(f.triangulation, manifold.halves);

  // 2. Its rim, after trimming.
  TrimmedSurface trimmed = trim_long_edges(sheet.mesh, options.trim);
  Trial trial;
  CloudSurface& surface = trial.surface;
  surface.mesh = std::move(trimmed.mesh);
  surface.point_of_vertex = std::move(sheet.point_of_vertex);
  surface.boundary_sample.resize(surface.mesh.points.size());
  for (const VertexId v : surface.mesh.points.ids()) {
    surface.boundary_sample[v] = boundary.boundary[sheet.triangulation_vertex[v]];
  }
  surface.rim = cloud_rim(surface.mesh, options.rim);
  surface.rho = rho;
  surface.boundary_samples = boundary.count;
  surface.trimmed = trimmed.at_rim + trimmed.in_clusters;
  surface.duplicates = f.triangulation.num_duplicates();
  surface.status = surface.mesh.triangles.empty() ? CloudStatus::no_surface
                   : surface.rim.loops.empty()    ? CloudStatus::cloud_closed
                                                  : CloudStatus::ok;
  trial.report = {.rho = rho,
                  .boundary_samples = boundary.count,
                  .stray_samples = stray_samples(surface),
                  .triangles = surface.mesh.triangles.size(),
                  .trimmed = surface.trimmed,
                  .loops = surface.rim.loops.size(),
                  .pin_holes = surface.rim.pin_holes};
  return trial;
}

bool has_strays(const RhoTrial& report, std::size_t samples, const CloudSurfaceOptions& options) {
  return static_cast<double>(report.stray_samples) >
         options.max_stray_share * static_cast<double>(samples);
}

bool is_noisy(const RhoTrial& report, std::size_t samples, const CloudSurfaceOptions& options) {
  return has_strays(report, samples, options) &&
         static_cast<double>(report.pin_holes) >
             options.max_pin_holes_per_rim * static_cast<double>(report.loops);
}

}  // namespace

CloudSurface cloud_surface(Points cloud, const CloudSurfaceOptions& options,
                           const Execution& execution) {
  const Foundation foundation = lay_foundation(cloud, options.reconstruct, execution);
  const std::size_t samples = foundation.triangulation.num_vertices();
  std::vector<RhoTrial> trials;
  auto attempt = [&](double rho) {
    Trial trial = try_rho(foundation, rho, options, execution);
    trials.push_back(trial.report);
    return trial;
  };

  Trial best = attempt(options.start_rho);
  if (is_noisy(best.report, samples, options)) {
    // Noise: a larger rho is taken only if it leaves a rim.
    for (const double rho : options.larger_rhos) {
      Trial trial = attempt(rho);
      if (trial.surface.status != CloudStatus::ok) break;
      best = std::move(trial);
      if (!is_noisy(best.report, samples, options)) break;
    }
  }
  for (const double rho : options.smaller_rhos) {
    if (best.surface.status != CloudStatus::cloud_closed) break;
    Trial trial = attempt(rho);
    // Boundary samples all over: rho asks for more than the sampling gives, its holes are no rims.
    if (has_strays(trial.report, samples, options)) break;
    if (trial.surface.status == CloudStatus::ok) best = std::move(trial);
  }
  for (const double rho : options.larger_rhos) {
    if (best.surface.status != CloudStatus::no_surface) break;
    best = attempt(rho);
  }
  CloudSurface result = std::move(best.surface);
  result.trials = std::move(trials);
  return result;
}

}  // namespace cocoon
