// Whether linked facets are the same, to the last link.
#pragma once

#include <gtest/gtest.h>

#include "cocone/facets/linked_facets.h"

namespace cocoon {

inline void expect_equal_links(const LinkedFacets& a, const LinkedFacets& b) {
  EXPECT_EQ(a.set, b.set);
  EXPECT_EQ(a.facets, b.facets);
  EXPECT_EQ(a.mirrors, b.mirrors);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.links, b.links);
  EXPECT_EQ(a.steep, b.steep);
}

}  // namespace cocoon
