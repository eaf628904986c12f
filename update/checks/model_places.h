// Places all over a mesh where nothing was scanned, and whether another mesh passes there, too.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/checks/lost_triangles.h"
#include "update/cloud/scan.h"
#include "update/cloud/scanned_places.h"

namespace cocoon {

struct ModelPlace {
  Point at;
  double area = 0;  // that it stands for
};

// Spacings are the largest of the scans. Of the options reach, most_spacings, coarse_ratio and
// most_parts are used. Source: ours.
class UnscannedPlaces {
 public:
  // Keeps copies of the samples. Complexity: O(n log n). Errors: InputError for options out of
  // range.
  explicit UnscannedPlaces(std::span<const Scan> scans, const AstrayOptions& options = {});

  // The middles of the triangles; those of large ones (longer than coarse_ratio spacings) are
  // divided into parts, for what is lost of them is seldom all. Places near a sample are left out,
  // and all without a spacing. Complexity: O(log n) for each triangle, and most_parts^2 times as
  // much for large ones.
  std::vector<ModelPlace> of(const TriangleMesh& mesh, std::span<const TriangleId> triangles) const;
  std::vector<ModelPlace> of(const TriangleMesh& mesh) const;  // all of them

  // The largest of the scans.
  double spacing() const { return spacing_; }
  // A mesh passes at a place if it is no farther than this.
  double reach() const { return options_.most_spacings * spacing_; }
  // Of each place whether the mesh, which has triangles, does not pass there. Complexity: O(log t).
  std::vector<std::uint8_t> are_off(std::span<const ModelPlace> places,
                                    const TriangleMesh& mesh) const;
  // The area of these places. Complexity: the same.
  double area_off(std::span<const ModelPlace> places, const TriangleMesh& mesh) const;

 private:
  void append(const TriangleMesh& mesh, TriangleId t, std::vector<ModelPlace>& places) const;

  AstrayOptions options_;
  double spacing_;
  ScannedPlaces scanned_;
};

}  // namespace cocoon
