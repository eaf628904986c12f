#include "update/report/model_places.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

namespace cocoon {
namespace {

TriangleMesh mesh_of(const std::vector<Point>& points,
                     const std::vector<std::array<std::size_t, 3>>& triangles) {
  TriangleMesh mesh;
  for (const Point& p : points) mesh.points.push_back(p);
  for (const auto& [a, b, c] : triangles) {
    mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  }
  return mesh;
}

std::vector<TriangleId> all_of(const TriangleMesh& mesh) {
  std::vector<TriangleId> all;
  for (const TriangleId t : mesh.triangles.ids()) all.push_back(t);
  return all;
}

double area_of(const std::vector<ModelPlace>& places) {
  double area = 0;
  for (const ModelPlace& place : places) area += place.area;
  return area;
}

const TriangleMesh large_and_small = mesh_of(
    {{0, 0, 0}, {32, 0, 0}, {0, 32, 0}, {40, 0, 0}, {41, 0, 0}, {40, 1, 0}, {50, 0, 0}, {51, 0, 0}},
    {{0, 1, 2}, {3, 4, 5}, {6, 7, 7}});

// 64 parts of the large one, none of the one without area.
TEST(ModelPlaces, LargeTrianglesHaveSeveral) {
  const std::vector<Point> samples = {{-20, 0, 0}};
  const Scan scans[] = {{samples, 0.5}};
  const std::vector<ModelPlace> places =
      unscanned_places(large_and_small, all_of(large_and_small), scans);
  ASSERT_EQ(places.size(), 65U);
  EXPECT_NEAR(area_of(places), 512.5, 1e-9);
  for (const ModelPlace& place : places) {
    const bool is_first = place.triangle == TriangleId(std::size_t{0});
    EXPECT_EQ(place.large, is_first);
    EXPECT_NEAR(place.area, is_first ? 8 : 0.5, 1e-12);
    EXPECT_EQ(place.reach, 0.25);  // half a spacing
    if (is_first) {
      EXPECT_GT(std::min(place.at.x, place.at.y), 0);
      EXPECT_LT(place.at.x + place.at.y, 32);
    }
  }
  EXPECT_EQ(
      unscanned_places(large_and_small, all_of(large_and_small), scans, {.most_parts = 1}).size(),
      2U);
}

TEST(ModelPlaces, AreLeftOutNearSamples) {
  const std::vector<Point> samples = {{0, 0, 0}};
  const Scan scans[] = {{samples, 3}};
  const std::vector<ModelPlace> places =
      unscanned_places(large_and_small, all_of(large_and_small), scans);
  ASSERT_GT(places.size(), 1U);
  for (const ModelPlace& place : places) EXPECT_GT(distance(place.at, samples[0]), 9);
  EXPECT_LT(area_of(places), 512.5);
}

// A corner is bent away.
TEST(ModelPlaces, AreOffWhereTheMeshDoesNotPass) {
  const TriangleMesh updated =
      mesh_of({{0, 0, 0}, {16, 0, 0}, {0, 32, 0}, {16, 0, 30}}, {{0, 1, 2}, {1, 3, 2}});
  const std::vector<Point> samples = {{-20, 0, 0}};
  const Scan scans[] = {{samples, 0.5}};
  const std::vector<ModelPlace> places =
      unscanned_places(large_and_small, std::vector<TriangleId>{TriangleId(std::size_t{0})}, scans);
  const std::vector<std::uint8_t> off = are_off(places, updated);
  double area = 0;
  for (std::size_t k = 0; k < places.size(); ++k) area += off[k] != 0 ? places[k].area : 0;
  EXPECT_NEAR(area, 256, 64);
}

}  // namespace
}  // namespace cocoon
