// Signed distances from a solid that is asked again and again.
#pragma once

#include <memory>
#include <vector>

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/search/point_welder.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// A mesh, and what it has told. While the samples of a solid are made to conform to it they are
// triangulated several times, and most cells, thus most of the places that are asked about, stay.
class SolidDistances {
 public:
  // Keeps the reference, which must outlive the object, and remembers nothing. Implicit: whoever
  // asks once gives the mesh.
  SolidDistances(const TriangleMesh& solid);  // NOLINT(google-explicit-constructor)
  // Keeps the mesh, and 48 to 96 bytes for each place that was asked about. Copies share both.
  explicit SolidDistances(std::shared_ptr<const TriangleMesh> solid);

  const TriangleMesh& solid() const { return *solid_; }

  // signed_distances() of the solid. Not to be called by several threads. Complexity and errors:
  // those, of the places that are not remembered, and O(1) for each of the others.
  std::vector<double> at(Points places, const Execution& execution = {}) const;

 private:
  struct Memory {
    std::vector<Point> places;
    PointWelder welder{places};
    std::vector<double> distances;  // of each place
  };

  std::shared_ptr<const TriangleMesh> solid_;
  std::shared_ptr<Memory> memory_;
};

}  // namespace cocoon
