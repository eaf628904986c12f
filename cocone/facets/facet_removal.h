// Triangles taken out of linked facets, and put back again.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cocone/facets/linked_facets.h"
#include "delaunay/triangulation.h"

namespace cocoon {

// Where the last triangles go when those with a flag leave their places, in the order of `to`.
// Complexity: one look at every flag.
struct TriangleMove {
  std::uint32_t from;
  std::uint32_t to;
};
std::vector<TriangleMove> moves_into_places(const std::vector<std::uint8_t>& removed);

// Triangles that were taken out, with what it takes to put them back.
struct RemovedFacets {
  struct One {
    std::uint32_t place;  // its position among all
    FacetId facet, mirror;
    Triangle corners;
    Vec3 normal;
    // Of each of its halfedges: the one whose link led to it when those before it had gone.
    std::array<Halfedge, 3> before;
  };
  std::vector<One> triangles;   // by place
  std::vector<Halfedge> steep;  // LinkedFacets::steep as it was
};

// The triangles whose flag is 0. Rings close over those that go, and the last triangles move to
// their places (moves_into_places). `gone`, if given, gets what put_back() wants. Complexity: one
// look at every flag, and O(triangles removed + steep edges).
LinkedFacets without(const Triangulation& triangulation, LinkedFacets triangles,
                     const std::vector<std::uint8_t>& removed, RemovedFacets* gone = nullptr);

// What without() was given, to the last link. Precondition: both arguments are of one call of it.
// Complexity: O(triangles removed), and a byte for each triangle.
LinkedFacets put_back(LinkedFacets triangles, RemovedFacets gone);

}  // namespace cocoon
