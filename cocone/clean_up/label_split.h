// Do the cells of one label fall apart when some of them change it?
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay/triangulation.h"
#include "geom/arrays/zeroed_array.h"
#include "geom/id_vector.h"

namespace cocoon {

class LabelSplit {
 public:
  // Keeps references, which must outlive the object. O(1). `out`: the label of each cell, 1 = OUT.
  LabelSplit(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out)
      : triangulation_(triangulation), out_(out), front_of_(triangulation.num_cells()) {}

  // Would the cells of that label next to these no longer all hang together by facets, if these had
  // the other label? Precondition: all have one label. Fronts grow from them in turn, cell by
  // cell, until all have met or one can grow no more: O(what the smallest part that is cut off has,
  // or what is between them), for each front.
  bool splits(std::span<const CellId> cells);

 private:
  struct Front {
    std::vector<CellId> cells;  // reached, in the order of the search
    std::size_t next = 0;
    std::uint32_t joined = 0;  // 1 + the front that has gone on with its cells, 0: none
  };
  bool are_apart();
  void begin(CellId c);
  void step(std::uint32_t k);
  void join(std::uint32_t a, std::uint32_t b);
  std::uint32_t root(std::uint32_t k) const;

  const Triangulation& triangulation_;
  const IdVector<CellId, std::uint8_t>& out_;
  ZeroedArray<CellId, std::uint32_t> front_of_;  // 1 + that; zero between questions
  std::vector<Front> fronts_;                    // the first count_ of them
  std::uint32_t count_ = 0;
  std::uint32_t apart_ = 0;             // fronts that have not met
  std::vector<std::uint32_t> growing_;  // those, and some that have
  std::vector<CellId> touched_;
};

}  // namespace cocoon
