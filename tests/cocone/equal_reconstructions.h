// Two reconstructions of the same points, made in different ways, must agree in everything.
#pragma once

#include <cstring>
#include <gtest/gtest.h>
#include <type_traits>

#include "cocone/reconstruct.h"

namespace cocoon {

// Counters are plain numbers; those of the Delaunay kernel tell of the history and are left out.
inline void expect_equal_counters(ReconstructCounters actual, ReconstructCounters expected) {
  static_assert(std::has_unique_object_representations_v<ReconstructCounters>);
  actual.delaunay = {};
  expected.delaunay = {};
  EXPECT_EQ(std::memcmp(&actual, &expected, sizeof actual), 0);
  EXPECT_EQ(actual.candidates, expected.candidates);
  EXPECT_EQ(actual.pruned, expected.pruned);
  EXPECT_EQ(actual.umbrellas, expected.umbrellas);
  EXPECT_EQ(actual.boundary_samples, expected.boundary_samples);
  EXPECT_EQ(actual.recovered_samples, expected.recovered_samples);
  EXPECT_EQ(actual.surface_triangles, expected.surface_triangles);
  EXPECT_EQ(actual.good_vertices, expected.good_vertices);
}

inline void expect_equal_reconstruction(const ReconstructResult& actual,
                                        const ReconstructResult& expected) {
  EXPECT_EQ(actual.status, expected.status);
  EXPECT_TRUE(actual.mesh == expected.mesh);
  EXPECT_TRUE(actual.point_of_vertex == expected.point_of_vertex);
  EXPECT_TRUE(actual.normals == expected.normals);
  EXPECT_TRUE(actual.boundary_sample == expected.boundary_sample);
  EXPECT_TRUE(actual.contradicted == expected.contradicted);
  EXPECT_EQ(actual.points, expected.points);
  EXPECT_EQ(actual.duplicates, expected.duplicates);
  EXPECT_EQ(actual.unused_points, expected.unused_points);
  EXPECT_EQ(actual.vertices, expected.vertices);
  EXPECT_EQ(actual.tetrahedra, expected.tetrahedra);
  expect_equal_counters(actual.counters, expected.counters);
}

}  // namespace cocoon
