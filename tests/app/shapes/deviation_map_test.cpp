#include "app/shapes/deviation_map.h"

#include <gtest/gtest.h>

#include "tests/mesh_gallery.h"
#include "tests/temporary_folder.h"

namespace cocoon::app {
namespace {

// A vertex in no triangle is far from everything, and tells nothing of the surface.
TEST(DeviationMap, ColorsAreThoseOfTheSurface) {
  const TemporaryFolder folder;
  const TriangleMesh b = gallery::cube();
  TriangleMesh a = b;
  for (Point& p : a.points) p.x += 0.125;
  const auto full_color = [&](const TriangleMesh& mesh) {
    SharedArguments shared;
    shared.quiet = true;
    Job job("compare", shared);
    write_deviation(job, mesh, b, {folder.file("map.ply"), {}, {}});
    return job.report().text();
  };
  const std::string expected = full_color(a);
  EXPECT_NE(expected.find("\"full_color\": 0."), std::string::npos) << expected;
  a.points.push_back({100, 0, 0});
  EXPECT_EQ(full_color(a), expected);
}

// Where nothing is tolerated, what deviates has the full color.
TEST(DeviationMap, WithoutToleranceWhatDeviatesIsRedOrBlue) {
  const TemporaryFolder folder;
  const TriangleMesh b = gallery::cube();
  TriangleMesh a = b;
  a.points[VertexId(7U)] = Point{1.5, 1.5, 1.5};
  SharedArguments shared;
  shared.quiet = true;
  Job job("compare", shared);
  write_deviation(job, a, b, {folder.file("map.ply"), {.ascii = true}, 0.0});
  job.finish();
  const std::string text = content_of(folder.file("map.ply"));
  const auto count_of = [&](const std::string& color) {
    std::size_t count = 0;
    for (std::size_t at = text.find(color); at != std::string::npos; at = text.find(color, at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(count_of(" 255 255 255\n"), 7U) << text;
  EXPECT_EQ(count_of(" 255 0 0\n") + count_of(" 0 0 255\n"), 1U) << text;
}

// As from points: without an element of faces.
TEST(DeviationMap, OfACloudIsACloud) {
  const TemporaryFolder folder;
  TriangleMesh a = gallery::cube();
  const TriangleMesh b = a;
  a.triangles.clear();
  SharedArguments shared;
  shared.quiet = true;
  Job job("compare", shared);
  write_deviation(job, a, b, {folder.file("map.ply"), {.ascii = true}, {}});
  job.finish();
  const std::string header = content_of(folder.file("map.ply"));
  EXPECT_NE(header.find("element vertex 8\n"), std::string::npos) << header;
  EXPECT_EQ(header.find("element face"), std::string::npos) << header;
}

}  // namespace
}  // namespace cocoon::app
