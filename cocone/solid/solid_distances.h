// Signed distances from a solid that is asked again and again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
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
  // Keeps the mesh, and 40 to 48 bytes for each place that was asked about. Copies share both.
  explicit SolidDistances(std::shared_ptr<const TriangleMesh> solid);

  const TriangleMesh& solid() const { return *solid_; }

  // signed_distances() of the solid. Not to be called by several threads. Complexity and errors:
  // those, of the places that are not remembered, and O(1) for each of the others.
  std::vector<double> at(Points places, const Execution& execution = {}) const;

 private:
  // An open hash table, at most half full.
  class Memory {
   public:
    // nullptr: not there. O(1).
    const double* find(const Point& place) const;
    // Of equal places the last counts. Precondition: fewer than 2^31 in all. O(places), amortized.
    void add(Points places, const std::vector<double>& distances);

   private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Known {
      Point place;
      double distance = 0;
    };
    std::size_t slot_of(const Point& place) const;

    std::vector<Known> known_;
    std::vector<std::uint32_t> table_;  // which of `known_`; as many as a power of 2
  };

  std::shared_ptr<const TriangleMesh> solid_;
  std::shared_ptr<Memory> memory_;
};

}  // namespace cocoon
