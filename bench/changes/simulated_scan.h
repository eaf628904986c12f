// Scans of a changed place, as scanners of several kinds would make them. The unit of length is the
// spacing of the samples of the model.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bench/changes/local_frame.h"
#include "geom/random/random.h"
#include "geom/search/nearest_point.h"
#include "geom/triangle_mesh.h"
#include "io/models/implicit_solid.h"
#include "io/models/surface_sampling.h"

namespace cocoon::bench {

enum class ScanKind {
  even,          // blue noise from all around
  random,        // random places, from all around
  one_view,      // a depth image: a grid of parallel rays, with what they hide missing
  three_views,   // in one file
  single_views,  // three, a file each
  lines          // three views with lines 2 to 5 times as far apart as samples along them
};
inline constexpr ScanKind scan_kinds[] = {ScanKind::even,         ScanKind::random,
                                          ScanKind::one_view,     ScanKind::three_views,
                                          ScanKind::single_views, ScanKind::lines};
const char* name_of(ScanKind kind);

struct ScanSetting {
  ScanKind kind = ScanKind::even;
  double spacing = 1;       // of its samples
  double margin = 3;        // how far it reaches around what changed
  double ragged = 0;        // the share of the margin by which its edge goes to and fro
  double noise = 0;         // each sample is off by up to this, in spacings of the scan
  double registration = 0;  // each cloud is off by up to this, in spacings of the scan
};

ScanSetting random_setting(ScanKind kind, Random& random);

// What is scanned: the surface after the change within the margin of a changed place.
class ScannedRegion {
 public:
  // `truth` is a mesh of the surface after the change. There is no region if the change changes
  // nothing that is left.
  static std::optional<ScannedRegion> around_change(const ImplicitFunction& before,
                                                    const TriangleMesh& truth,
                                                    const ScanSetting& setting, Random& random);

  bool holds(const Point& p) const;
  // The triangles of `truth` with a corner within the reach of the region, with all points.
  TriangleMesh part_of(const TriangleMesh& truth) const;
  const std::vector<Point>& changed() const { return changed_; }
  // A ball with all of it.
  Point center() const { return center_; }
  double radius() const { return radius_; }

 private:
  ScannedRegion(std::vector<Point> changed, const ScanSetting& setting, Random& random);

  std::vector<Point> changed_;  // vertices of the truth
  NearestPointTree tree_;
  double margin_;
  double ragged_;
  std::array<Vec3, 3> waves_;  // along which the edge goes to and fro, radians per unit
  Point center_;
  double radius_ = 0;
};

// The clouds, without errors if `setting` has none. `up` is a direction from which most of the
// change is seen. A cloud may be empty. Deterministic from the state of `random`.
std::vector<std::vector<Point>> simulated_scan(const ImplicitSolid& solid,
                                               const TriangleMesh& truth,
                                               const ScannedRegion& region, const Vec3& up,
                                               const ScanSetting& setting, Random& random);

}  // namespace cocoon::bench
