// Places near which samples lie.
#pragma once

#include <memory>
#include <vector>

#include "geom/box.h"
#include "geom/point.h"
#include "geom/search/nearest_point.h"

namespace cocoon {

class ScannedPlaces {
 public:
  // Places at most this far from one of the samples, which are copied, are scanned, too; `samples`
  // may be empty. Complexity: O(n log n).
  void add(Points samples, double reach);
  // The same for samples that have a tree, which must outlive this. Complexity: O(1).
  void add(const NearestPointTree& samples, double reach);
  // Whether a sample lies near. Complexity: O(log n) for each set of samples, O(1) far from all.
  bool contain(const Point& place) const;
  // Around all that they contain; empty without samples.
  Box box() const;

 private:
  struct Reached {
    const NearestPointTree* samples;
    double reach;
    Box box;  // of what is scanned
  };
  std::vector<Reached> sets_;
  std::vector<std::unique_ptr<const NearestPointTree>> own_;  // those made here
};

}  // namespace cocoon
