// Signed distances from a solid that is asked again and again.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geom/execution.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"

namespace cocoon {

// A mesh, and what it has told. While the samples of a solid are made to conform to it they are
// triangulated several times, and most cells, thus most of the places that are asked about, stay.
class SolidDistances {
 public:
  // Keeps the reference, which must outlive the object, and remembers nothing. Implicit: whoever
  // asks once gives the mesh.
  SolidDistances(const TriangleMesh& solid);  // NOLINT(google-explicit-constructor)
  // Keeps the mesh, and 32 bytes for each place that was asked about. Copies share both.
  explicit SolidDistances(std::shared_ptr<const TriangleMesh> solid);

  const TriangleMesh& solid() const { return *solid_; }

  // signed_distances() of the solid. Not to be called by several threads. Complexity and errors:
  // those, of the places that are not remembered; O(log n) for each of the others, and O(n) for n
  // remembered ones.
  std::vector<double> at(Points places, const Execution& execution = {}) const;

 private:
  struct Known {
    Point place;
    double distance = 0;
  };
  using Memory = std::vector<Known>;  // by their places
  static std::optional<double> find(const Memory& memory, const Point& place);
  void remember(Points places, const std::vector<double>& distances) const;

  std::shared_ptr<const TriangleMesh> solid_;
  std::shared_ptr<Memory> memory_;
};

}  // namespace cocoon
