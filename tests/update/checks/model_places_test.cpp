#include "update/checks/model_places.h"

#include <algorithm>
#include <array>
#include <cstddef>
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

double area_of(const std::vector<ModelPlace>& places) {
  double area = 0;
  for (const ModelPlace& place : places) area += place.area;
  return area;
}

const TriangleMesh large_and_small = mesh_of(
    {{0, 0, 0}, {32, 0, 0}, {0, 32, 0}, {40, 0, 0}, {41, 0, 0}, {40, 1, 0}, {50, 0, 0}, {51, 0, 0}},
    {{0, 1, 2}, {3, 4, 5}, {6, 7, 7}});

const std::vector<TriangleId> large_alone = {TriangleId(std::size_t{0})};

// 64 parts of the large one, none of the one without area.
TEST(ModelPlaces, LargeTrianglesHaveSeveral) {
  const std::vector<Point> samples = {{-20, 0, 0}};
  const Scan scans[] = {{samples, 0.5}};
  const UnscannedPlaces unscanned(scans);
  EXPECT_EQ(unscanned.reach(), 0.25);  // half a spacing
  const std::vector<ModelPlace> places = unscanned.of(large_and_small);
  ASSERT_EQ(places.size(), 65U);
  EXPECT_NEAR(area_of(places), 512.5, 1e-9);
  EXPECT_EQ(unscanned.of(large_and_small, large_alone).size(), 64U);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const ModelPlace& place = places[k];
    const bool is_first = k < 64;
    EXPECT_NEAR(place.area, is_first ? 8 : 0.5, 1e-12);
    if (is_first) {
      EXPECT_GT(std::min(place.at.x, place.at.y), 0);
      EXPECT_LT(place.at.x + place.at.y, 32);
    }
  }
  EXPECT_EQ(UnscannedPlaces(scans, {.most_parts = 1}).of(large_and_small).size(), 2U);
}

TEST(ModelPlaces, AreLeftOutNearSamples) {
  const std::vector<Point> samples = {{0, 0, 0}};
  const Scan scans[] = {{samples, 3}};
  const std::vector<ModelPlace> places = UnscannedPlaces(scans).of(large_and_small);
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
  const UnscannedPlaces unscanned(scans);
  const double area = unscanned.area_off(unscanned.of(large_and_small, large_alone), updated);
  EXPECT_NEAR(area, 256, 64);
}

}  // namespace
}  // namespace cocoon
