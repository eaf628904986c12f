#include "update/cloud_surface.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "cocone/candidate_triangles.h"
#include "cocone/extract_manifold.h"
#include "cocone/poles.h"
#include "cocone/surface_mesh.h"
#include "delaunay/require_points.h"
#include "delaunay/voronoi_dual.h"
#include "geom/arrays/points_of.h"
#include "geom/errors.h"
#include "geom/off_plane.h"
#include "geom/search/thin_points.h"
#include "geom/spatial_order.h"
#include "update/cloud/layers.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

// What all trials share.
struct Foundation {
  Triangulation triangulation;
  Dual dual;
  Poles poles;
  Cocones cocones;
  bool is_off_plane;  // the samples are flat: those triangulated lie just off their plane
};

Foundation lay_foundation(Points cloud, const ReconstructOptions& options,
                          const Execution& execution) {
  const std::vector<Point> off_plane = moved_off_plane(cloud);
  const Points points = off_plane.empty() ? cloud : Points(off_plane);
  Triangulation triangulation = delaunay(points, options.delaunay, execution).triangulation;
  auto [dual, poles, sides] = dual_and_poles(triangulation, options.cocone.cosine, execution);
  Cocones cocones = intersect_cocones(triangulation, std::move(sides), execution);
  return {std::move(triangulation), std::move(dual), std::move(poles), std::move(cocones),
          !off_plane.empty()};
}

// The samples whose surface is looked at.
struct KeptSamples {
  Points cloud;
  Foundation foundation;      // of the samples that are kept
  std::vector<PointId> kept;  // increasing; empty: all
  std::size_t duplicates = 0;
  bool are_of_layers = false;  // by LayerOptions

  std::size_t set_aside() const {
    return kept.empty() ? 0 : cloud.size() - duplicates - kept.size();
  }
};

struct Trial {
  CloudSurface surface;
  RimTrial report;
};

struct Sheet {
  SurfaceMesh surface;
  BoundarySamples boundary;
};

// In mode paper the radius is that of the cocone, whatever the search says.
RimSearch effective(RimSearch search, const CloudSurfaceOptions& options) {
  ReconstructOptions reconstruct = options.reconstruct;
  reconstruct.boundary.radius_mode = search.radius_mode;
  search.radius_mode = effective_options(reconstruct).boundary.radius_mode;
  return search;
}

// The Cocone surface.
Sheet find_sheet(const Foundation& f, const RimSearch& search, const CloudSurfaceOptions& options,
                 const Execution& execution) {
  BoundaryOptions boundary_options = options.reconstruct.boundary;
  boundary_options.rho = search.rho;
  boundary_options.alpha_cosine = search.alpha_cosine;
  boundary_options.radius_mode = effective(search, options).radius_mode;
  BoundarySamples boundary =
      boundary_samples(f.triangulation, f.dual, f.poles, f.cocones, boundary_options, execution);
  CandidateTriangles candidates =
      list_candidate_triangles(f.triangulation, f.cocones, boundary.boundary, execution);
  PrunedCandidates pruned = prune_sharp_edges(f.triangulation, std::move(candidates),
                                              options.reconstruct.prune, execution);
  ManifoldSurface manifold =
      extract_manifold(f.triangulation, std::move(pruned.left), pruned.umbrella, execution);
  return {surface_of(f.triangulation, std::move(manifold.triangles), manifold.halves, execution),
          std::move(boundary)};
}

// Its rim, after trimming, without seams.
Trial find_rim(const KeptSamples& samples, Sheet&& found, const RimSearch& search,
               const CloudSurfaceOptions& options) {
  auto& [sheet, boundary] = found;
  TrimmedSurface trimmed = trim_long_edges(std::move(sheet.mesh), options.trim);
  Trial trial;
  CloudSurface& surface = trial.surface;
  surface.mesh = std::move(trimmed.mesh);
  surface.point_of_vertex = std::move(sheet.point_of_vertex);
  if (!samples.kept.empty()) {
    for (PointId& point : surface.point_of_vertex) point = samples.kept[point.index()];
  }
  if (samples.foundation.is_off_plane) {
    for (const VertexId v : surface.mesh.points.ids()) {
      surface.mesh.points[v] = samples.cloud[surface.point_of_vertex[v].index()];
    }
  }
  surface.boundary_sample.resize(surface.mesh.points.size());
  for (const VertexId v : surface.mesh.points.ids()) {
    surface.boundary_sample[v] = boundary.boundary[sheet.triangulation_vertex[v]];
  }
  surface.rim = cloud_rim(surface.mesh, trimmed.rings, options.rim);
  surface.literal = literal_boundary(surface.mesh, trimmed.rings, surface.boundary_sample);
  mark_rim_seams(samples.cloud, surface.rim, options.seams);
  surface.search = effective(search, options);
  surface.set_aside = samples.set_aside();
  surface.is_layered = samples.are_of_layers;
  surface.boundary_samples = boundary.count;
  surface.trimmed = trimmed.at_rim + trimmed.in_clusters;
  surface.status = surface.mesh.triangles.empty() ? CloudStatus::no_surface
                   : surface.rim.loops.empty()    ? CloudStatus::cloud_closed
                                                  : CloudStatus::ok;
  const CloudRim& rim = surface.rim;
  trial.report = {.search = surface.search,
                  .boundary_samples = boundary.count,
                  .triangles = surface.mesh.triangles.size(),
                  .trimmed = surface.trimmed,
                  .loops = rim.loops.size(),
                  .seam_loops = rim.seam_loops,
                  .seamed_loops = rim.seamed_loops,
                  .pin_holes = rim.pin_holes};
  if (rim.rim_edges > 0) {
    trial.report.seam_share =
        static_cast<double>(rim.seam_edges + rim.lone_edges) / static_cast<double>(rim.rim_edges);
  }
  if (rim.median_edge > 0) trial.report.stretch = rim.spacing / rim.median_edge;
  return trial;
}

// With these samples alone; none if they cannot be triangulated: too few, or on one line.
std::optional<KeptSamples> thinned(const KeptSamples& all, std::vector<PointId> kept,
                                   const CloudSurfaceOptions& options, const Execution& execution) {
  KeptSamples samples{all.cloud, {}, std::move(kept), all.duplicates};
  const std::vector<Point> points = points_of(samples.cloud, samples.kept);
  try {
    samples.foundation = lay_foundation(points, options.reconstruct, execution);
  } catch (const DegenerateInput&) {
    return {};
  }
  return samples;
}

// Whether the trial is to be preferred: a rim before none, a surface before none, then the less
// doubtful rim.
class Preference {
 public:
  explicit Preference(const CloudSurfaceOptions& options) : options_(options) {}

  bool good_enough(const Trial& trial) const {
    return trial.surface.status == CloudStatus::ok &&
           trial.report.seam_share <= options_.max_seam_share;
  }
  bool operator()(const Trial& a, const Trial& b) const {
    if (a.surface.status != b.surface.status) {
      return rank(a.surface.status) < rank(b.surface.status);
    }
    if (good_enough(a) != good_enough(b)) return good_enough(a);
    return doubt(a.report) < doubt(b.report);
  }

 private:
  static int rank(CloudStatus status) {
    return status == CloudStatus::ok ? 0 : status == CloudStatus::cloud_closed ? 1 : 2;
  }
  double doubt(const RimTrial& trial) const {
    return trial.seam_share + options_.stretch_weight * (trial.stretch - 1);
  }

  const CloudSurfaceOptions& options_;
};

// All trials, up to the first that is good enough.
class Search {
 public:
  Search(const CloudSurfaceOptions& options, const Execution& execution)
      : options_(options), execution_(execution), preference_(options) {}

  // `sheet`: that of options.start. Without a rim or a seam the surface is closed: finer trials
  // look more closely. Else the seams are in the way.
  void begin(const KeptSamples& samples, Sheet sheet) {
    add(find_rim(samples, std::move(sheet), options_.start, options_));
    const Trial& first = found_.front();
    const bool is_closed = first.surface.status == CloudStatus::cloud_closed &&
                           first.report.seam_share <= options_.max_seam_share;
    for (const RimSearch& search : is_closed ? options_.finer : options_.coarser) {
      if (done_) break;
      Trial trial = try_once(samples, search);
      // A finer trial that tears the surface up everywhere has found no rim.
      if (is_closed && !preference_.good_enough(trial)) {
        trials_.push_back(trial.report);
      } else {
        add(std::move(trial));
      }
    }
    std::stable_sort(found_.begin(), found_.end(), preference_);
  }

  // Goes over to the other search if its rim is preferred, or good, with edges about as long as
  // those of the surface. Returns whether it did.
  bool prefer(Search&& other) {
    const Trial& theirs = other.found_.front();
    const bool has_good_rim =
        preference_.good_enough(theirs) && theirs.report.stretch <= options_.density.max_stretch;
    if (!has_good_rim && !preference_(theirs, found_.front())) return false;
    found_ = std::move(other.found_);
    trials_ = std::move(other.trials_);
    done_ = other.done_;
    return true;
  }

  bool is_layered() const {
    const Trial& best = found_.front();
    return options_.layers.spread > 0 &&
           (options_.layers.first || best.surface.status != CloudStatus::ok ||
            best.report.seam_share > options_.layers.max_seam_share);
  }

  void go_on(const KeptSamples& samples) {
    add(try_once(samples, options_.start));
    for (const RimSearch& search : options_.coarser) {
      if (!done_) add(try_once(samples, search));
    }
    std::stable_sort(found_.begin(), found_.end(), preference_);
  }

  std::vector<CloudSurface> ranked() {
    std::vector<CloudSurface> surfaces;
    for (Trial& trial : found_) {
      trial.surface.trials = trials_;
      surfaces.push_back(std::move(trial.surface));
    }
    return surfaces;
  }

 private:
  Trial try_once(const KeptSamples& samples, const RimSearch& search) const {
    return find_rim(samples, find_sheet(samples.foundation, search, options_, execution_), search,
                    options_);
  }
  void add(Trial trial) {
    trials_.push_back(trial.report);
    done_ = preference_.good_enough(trial);
    found_.push_back(std::move(trial));
  }

  const CloudSurfaceOptions& options_;
  const Execution& execution_;
  Preference preference_;
  std::vector<Trial> found_;      // sorted when asked for
  std::vector<RimTrial> trials_;  // in the order tried
  bool done_ = false;
};

// Goes over to few of samples in rows, and to their surface, unless they cannot be triangulated.
void look_at_few_of_rows(const CloudSurfaceOptions& options, const Execution& execution,
                         KeptSamples& samples, Sheet& sheet) {
  std::optional<KeptSamples> few = thinned(
      samples,
      thin_out_rows(samples.cloud, sheet.surface.mesh, sheet.surface.point_of_vertex, options.rows),
      options, execution);
  if (!few) return;
  sheet = find_sheet(few->foundation, options.start, options, execution);
  samples = *std::move(few);
}

// If samples are dense in some places: goes over to few of them, which are about as far apart there
// as elsewhere, if their rim is to be preferred. Where a surface is steep samples are sparse, too,
// and so few may be too few.
void look_at_few_of_dense(const SpacingRange& spacing, const CloudSurfaceOptions& options,
                          const Execution& execution, KeptSamples& samples, Search& search) {
  const double distance = options.density.spread * spacing.high;
  std::optional<KeptSamples> few =
      thinned(samples, thin_points(samples.cloud, distance), options, execution);
  if (!few) return;
  Search among_few(options, execution);
  among_few.begin(*few, find_sheet(few->foundation, options.start, options, execution));
  if (search.prefer(std::move(among_few))) samples = *std::move(few);
}

}  // namespace

std::vector<CloudSurface> ranked_cloud_surfaces(Points cloud, const CloudSurfaceOptions& options,
                                                const Execution& execution) {
  require_options("cloud_surface", options);
  require_finite(cloud, execution);
  // Numbered by place, so that nothing below can depend on the order of the file.
  const std::vector<PointId> order = hilbert_order(cloud, execution);
  const std::vector<Point> sorted = points_of(cloud, order);
  KeptSamples samples{sorted, lay_foundation(sorted, options.reconstruct, execution), {}};
  samples.duplicates = samples.foundation.triangulation.num_duplicates();
  Sheet sheet = find_sheet(samples.foundation, options.start, options, execution);
  const SpacingRange spacing = spacing_range(sheet.surface.mesh);
  if (lies_in_rows(sheet.surface.mesh, options.rows)) {
    look_at_few_of_rows(options, execution, samples, sheet);
  }
  Search search(options, execution);
  search.begin(samples, std::move(sheet));
  if (samples.kept.empty() && spacing.is_uneven(options.density.min_ratio)) {
    look_at_few_of_dense(spacing, options, execution, samples, search);
  }
  if (search.is_layered()) {
    std::optional<KeptSamples> few = thinned(
        samples, few_of_layers(samples.cloud, options.layers.spread).kept, options, execution);
    if (few) {
      few->are_of_layers = true;
      search.go_on(*few);
    }
  }
  std::vector<CloudSurface> surfaces = search.ranked();
  for (CloudSurface& surface : surfaces) {
    surface.duplicates = samples.duplicates;
    surface.spacing = spacing;
    for (PointId& p : surface.point_of_vertex) p = order[p.index()];
  }
  return surfaces;
}

CloudSurface cloud_surface(Points cloud, const CloudSurfaceOptions& options,
                           const Execution& execution) {
  return std::move(ranked_cloud_surfaces(cloud, options, execution).front());
}

}  // namespace cocoon
