#include "cocone/steps/close_surface.h"

#include <gtest/gtest.h>
#include <vector>

#include "delaunay/delaunay.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

struct Closing {
  explicit Closing(std::vector<Point> samples, const ReconstructOptions& given = {})
      : points(std::move(samples)), options(effective_options(given)) {}

  GoodUmbrellas close(const KnownLabelsSource& known = {}, const GoingOn& going_on = {}) {
    return close_surface(input, found, known, going_on, made, {});
  }

  std::vector<Point> points;
  ReconstructOptions options;
  Triangulation triangulation = delaunay(points).triangulation;
  ReconstructInput input{triangulation, points, options};
  SurfaceResult made = begin_result(input);
  FoundSurface found = find_surface(input, made.result.counters, nullptr, {});
};

// Its opening is in doubt.
std::vector<Point> dome() { return shapes::cut_sphere(500, 0.2, 3); }

TEST(CloseSurface, IsTheSecondHalfOfTheReconstruction) {
  Closing closing(dome());
  closing.close();
  const ReconstructResult expected = reconstruct_tight(closing.points);
  EXPECT_EQ(closing.made.result.mesh, expected.mesh);
  EXPECT_EQ(closing.made.result.counters.good_vertices, expected.counters.good_vertices);
}

TEST(CloseSurface, AsksOnceAtMostWhatIsKnown) {
  std::size_t asked = 0;
  const KnownLabelsSource known = [&](const auto&...) {
    ++asked;
    return KnownLabels();
  };
  Closing(dome()).close(known);
  EXPECT_EQ(asked, 1U);
  Closing(dome(), {.mode = Mode::paper}).close(known);
  EXPECT_EQ(asked, 1U);
  Closing(shapes::torus(60, 30, 0.4, 0.1, 1)).close(known);  // certain
  EXPECT_EQ(asked, 1U);
}

TEST(CloseSurface, MarksAndBodyAreKeptForWhoGoesOn) {
  Closing closing(dome());
  ReconstructStages kept;
  const GoodUmbrellas good = closing.close({}, {.stages = &kept});
  EXPECT_EQ(good.good, kept.marks.good);
  EXPECT_GE(good.umbrellas, kept.marks.good_vertices);
  ASSERT_EQ(kept.out.size(), closing.triangulation.num_cells());
  EXPECT_EQ(surface_between(closing.triangulation, kept.out).mesh.triangles,
            closing.made.result.mesh.triangles);
  // What the cells were marked by stays, without its links.
  EXPECT_EQ(closing.found.surface.triangles.set.size(), closing.found.surface.halves.size());
  EXPECT_EQ(closing.found.surface.triangles.size(), 0U);
}

TEST(CloseSurface, WithoutInteriorSamplesThereIsNone) {
  Closing closing(shapes::cube_grid(1));
  ASSERT_EQ(closing.found.boundary.interior(), 0U);
  EXPECT_TRUE(closing.close().good.empty());
  EXPECT_EQ(closing.made.result.status, SurfaceStatus::no_surface);
}

}  // namespace
}  // namespace cocoon
