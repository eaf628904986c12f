#include "update/overlapping_facets.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "geom/errors.h"
#include "geom/random/random.h"
#include "geom/triangle_projection.h"
#include "tests/update/hand_made_models.h"

namespace cocoon {
namespace {

using testing::circle;
using testing::rim_of;

bool contains_xy(const TriangleMesh& mesh, TriangleId t, const Point& p) {
  const auto& [a, b, c] = mesh.triangles[t];
  auto left = [&](VertexId from, VertexId to) {
    const Vec3 along = mesh.points[to] - mesh.points[from];
    const Vec3 offset = p - mesh.points[from];
    return along.x * offset.y - along.y * offset.x >= -1e-12;
  };
  return left(a, b) && left(b, c) && left(c, a);
}

TEST(OverlappingFacets, FindsTheFacetBelowEachPoint) {
  const TriangleMesh model = testing::grid_plane(20);
  const CloudRim rim = rim_of({circle(40, {10, 10, 0.3}, 6.2)});
  for (const LocationRule rule : {LocationRule::closest_facet, LocationRule::nearest_vertex_star}) {
    const Overlap overlap = overlapping_facets(model, rim, {.rule = rule});
    ASSERT_EQ(overlap.status, OverlapStatus::ok);
    ASSERT_EQ(overlap.loops.size(), 1U);
    EXPECT_EQ(overlap.unmatched, 0U);
    EXPECT_EQ(overlap.figures.facing_away, 0U);
    EXPECT_NEAR(overlap.figures.largest_distance, 0.3, 1e-12);
    EXPECT_NEAR(overlap.figures.median_distance, 0.3, 1e-12);
    for (std::size_t i = 0; i < 40; ++i) {
      const Point& p = rim.loops[0].points[i];
      EXPECT_TRUE(contains_xy(model, overlap.loops[0].facets[i], p)) << i;
      EXPECT_LT(distance(overlap.loops[0].feet[i], {p.x, p.y, 0}), 1e-12);
    }
    EXPECT_LE(overlap.facets.size(), 40U);
    EXPECT_TRUE(std::is_sorted(overlap.facets.begin(), overlap.facets.end()));
  }
}

TEST(OverlappingFacets, OptionsOutOfRangeAreRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const TriangleMesh model = testing::grid_plane(20);
  const CloudRim rim = rim_of({circle(40, {10, 10, 0.3}, 6.2)});
  for (const OverlapOptions& options : {
           OverlapOptions{.max_distance = -1},
           OverlapOptions{.max_distance = nan},
           OverlapOptions{.min_normal_cosine = 60},  // degrees
           OverlapOptions{.facing_preference = nan},
           OverlapOptions{.max_unmatched_share = 10},
           OverlapOptions{.max_raised_share = -0.1},
           OverlapOptions{.max_raised_outline = 1.5},
           OverlapOptions{.raised_distance = nan},
           OverlapOptions{.step_distance = -2},
       }) {
    EXPECT_THROW(overlapping_facets(model, rim, options), InputError);
  }
}

// The model's facets are the spacing where the cloud is denser.
TEST(OverlappingFacets, TellsHowMuchFartherOffAPointIs) {
  const TriangleMesh model = testing::grid_plane(20);
  for (const std::size_t points : {40U, 400U}) {
    RimLoop rim = circle(points, {10, 10, 0.3}, 6.2);
    EXPECT_NEAR(overlapping_facets(model, rim_of({rim})).figures.largest_excess, 0, 1e-12);
    rim.points[7].z += 2;
    const double excess = overlapping_facets(model, rim_of({rim})).figures.largest_excess;
    EXPECT_GT(excess, 2 / 1.5);
    EXPECT_LT(excess, 2 / 0.9);
  }
}

TEST(OverlappingFacets, AgreesWithBruteForceOnASphere) {
  const TriangleMesh model = testing::sphere(4);
  Random random(11);
  RimLoop loop = testing::cap_rim(60, unit(Vec3{1, 2, 3}), 0.7);
  for (Point& p : loop.points) p = (1 + random.uniform(-0.02, 0.02)) * p;
  const Overlap overlap = overlapping_facets(model, rim_of({loop}));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    double least = 1e9;
    for (const auto& [a, b, c] : model.triangles) {
      const ClosestPoint foot = closest_point_on_triangle(
          loop.points[i], {model.points[a], model.points[b], model.points[c]});
      least = std::min(least, foot.squared_distance);
    }
    EXPECT_NEAR(squared_distance(overlap.loops[0].feet[i], loop.points[i]), least, 1e-15);
  }
}

// The cloud was scanned from above; noise moves every third rim point below the middle of the wall.
// There the far side is closer, but it faces the other way than the cloud does on the whole.
TEST(OverlappingFacets, DoesNotTakeTheFarSideOfAThinWall) {
  const TriangleMesh wall = testing::block(20, 20, 1);
  for (const double facing : {1.0, -1.0}) {  // the cloud's own orientation is arbitrary
    RimLoop loop = circle(30, {10, 10, 0.9}, 6);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (i % 3 == 0) loop.points[i].z = 0.4;
      loop.normals[i] = facing * loop.normals[i];
    }
    const Overlap overlap = overlapping_facets(wall, rim_of({loop}));
    ASSERT_EQ(overlap.status, OverlapStatus::ok);
    EXPECT_EQ(overlap.figures.facing_away, 10U);
    for (const Point& foot : overlap.loops[0].feet) EXPECT_EQ(foot.z, 1);
  }
}

// Thicker than the preference for a facet that faces as the cloud does.
TEST(OverlappingFacets, DoesNotTakeTheFarSideOfAThickerWall) {
  const TriangleMesh wall = testing::block(20, 20, 2);
  RimLoop loop = circle(30, {10, 10, 1.9}, 6);
  for (std::size_t i = 2; i < loop.size(); i += 3) loop.points[i].z = 0.3;
  const Overlap overlap = overlapping_facets(wall, rim_of({loop}));
  for (const Point& foot : overlap.loops[0].feet) EXPECT_EQ(foot.z, 2);
}

TEST(OverlappingFacets, PointsWithoutANormalHaveNoSide) {
  const TriangleMesh model = testing::grid_plane(20);
  RimLoop loop = circle(40, {10, 10, 0.3}, 6.2);
  for (Vec3& normal : loop.normals) normal = {};
  const Overlap overlap = overlapping_facets(model, rim_of({loop}));
  EXPECT_EQ(overlap.facets.size(),
            overlapping_facets(model, rim_of({circle(40, {10, 10, 0.3}, 6.2)})).facets.size());
  EXPECT_EQ(overlap.figures.facing_away, 0U);
  EXPECT_EQ(overlap.figures.steep, 0U);
}

// A one-sided surface has gone through a thin wall somewhere: half of its rim has the normals of
// the other side. Which side of the wall it is on, the points next to each tell.
TEST(OverlappingFacets, ALoopOnAOneSidedPartHasItsSideFromPointToPoint) {
  const TriangleMesh wall = testing::block(20, 20, 1);
  RimLoop loop = circle(30, {10, 10, 1}, 6);
  for (std::size_t i = 0; i < 13; ++i) loop.normals[i] = -1.0 * loop.normals[i];
  loop.points[6].z = 0.4;  // noise: nearer to the far side
  loop.points[20].z = 0.4;
  const auto points_on_top = [&] {
    const LoopOverlap found = overlapping_facets(wall, rim_of({loop})).loops[0];
    return std::count_if(found.feet.begin(), found.feet.end(),
                         [](const Point& foot) { return foot.z == 1; });
  };
  EXPECT_EQ(points_on_top(), 17);
  loop.one_sided = true;
  EXPECT_EQ(points_on_top(), 30);
}

// Where the surface of a cloud tears, its rim climbs: such a point's normal is that of a wall of
// the new shape. Its place is the floor below it and not the outer wall of the model, farther away.
TEST(OverlappingFacets, DoesNotTakeAnotherWallFromAfar) {
  const TriangleMesh model = testing::block(20, 20, 8);
  RimLoop loop = circle(30, {10, 10, 8}, 7.5);
  std::size_t first = 0;  // the point closest to the wall at x = 20
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop.points[i].x > loop.points[first].x) first = i;
  }
  loop.points[first].z = 8.5;
  loop.normals[first] = {1, 0, 0};
  const Overlap overlap = overlapping_facets(model, rim_of({loop}));
  ASSERT_EQ(overlap.status, OverlapStatus::ok);
  EXPECT_EQ(overlap.loops[0].feet[first].z, 8);
  EXPECT_EQ(overlap.figures.steep, 1U);
  // At an edge the wall is as near as the floor, and then it is the better one.
  loop.points[first].x = 19.6;
  EXPECT_EQ(overlapping_facets(model, rim_of({loop})).loops[0].feet[first].x, 20);
}

// Nor one that is farther away than any facet may be, though it is hardly farther than the floor.
TEST(OverlappingFacets, DoesNotTakeAWallBeyondTheLargestDistance) {
  TriangleMesh model = testing::block(20, 20, 8);
  for (Point& p : model.points) p = 2 * p;  // the spacing is 2
  RimLoop loop = circle(100, {20, 20, 16}, 15);
  loop.points[99] = {38.8, 20, 17};  // the wall x = 40 is 1.56 away
  loop.normals[99] = {1, 0, 0};
  const auto place = [&](double max_distance) {
    const Overlap overlap =
        overlapping_facets(model, rim_of({loop}), {.max_distance = max_distance});
    EXPECT_EQ(overlap.figures.steep, max_distance == 0.8 ? 0U : 1U);
    return overlap.loops[0].feet[99];
  };
  EXPECT_EQ(place(0.8), (Point{40, 20, 16}));
  EXPECT_EQ(place(0.7), (Point{38.8, 20, 16}));
}

// As far away as a point may be is not too far.
TEST(OverlappingFacets, ThreeSpacingsAreNear) {
  TriangleMesh model = testing::grid_plane(20);
  for (Point& p : model.points) p = 2 * p;
  const auto unmatched = [&](double height) {
    return overlapping_facets(model, rim_of({circle(60, {20, 20, height}, 12)})).unmatched;
  };
  EXPECT_EQ(unmatched(6), 0U);
  EXPECT_EQ(unmatched(std::nextafter(6, 7)), 60U);
}

// Between edges with cloud beyond them a point is not looked for, so that the border passes it by.
TEST(OverlappingFacets, InnerPointsHaveNoFacet) {
  const TriangleMesh model = testing::grid_plane(20);
  RimLoop loop = circle(40, {10, 10, 0.3}, 6.2);
  loop.inner.assign(40, 0);
  for (std::size_t i = 5; i < 9; ++i) loop.inner[i] = 1;
  const Overlap overlap = overlapping_facets(model, rim_of({loop}));
  EXPECT_EQ(overlap.loops[0].inner_points, 3U);
  EXPECT_EQ(overlap.unmatched, 0U);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(overlap.loops[0].facets[i].is_none(), 5 < i && i < 9) << i;
  }
}

TEST(OverlappingFacets, FarAwayIsNoOverlap) {
  const TriangleMesh model = testing::grid_plane(20);
  EXPECT_EQ(overlapping_facets(model, rim_of({circle(40, {10, 10, 2.9}, 6)})).status,
            OverlapStatus::ok);
  const Overlap far = overlapping_facets(model, rim_of({circle(40, {10, 10, 5}, 6)}));
  EXPECT_EQ(far.status, OverlapStatus::no_overlap);
  EXPECT_EQ(far.unmatched, 40U);
  EXPECT_TRUE(far.facets.empty());
  // Three median edges of the facets, not of their diagonals.
  EXPECT_EQ(overlapping_facets(model, rim_of({circle(40, {10, 10, 3.1}, 6)})).unmatched, 40U);
}

TEST(OverlappingFacets, ATenthOfTheRimMayBeOffTheModel) {
  const TriangleMesh model = testing::grid_plane(20);
  const auto status = [&](std::size_t raised) {
    RimLoop loop = circle(40, {10, 10, 0}, 6);
    for (std::size_t i = 0; i < raised; ++i) loop.points[i].z = 30;
    return overlapping_facets(model, rim_of({loop})).status;
  };
  EXPECT_EQ(status(4), OverlapStatus::ok);
  EXPECT_EQ(status(5), OverlapStatus::no_overlap);
}

// The first rim lies on the model; the second one over the samples of the first cloud.
struct CoveredRim {
  TriangleMesh mesh = testing::grid_plane(20);
  ModelIndex model{mesh};
  std::vector<CloudRim> rims = {rim_of({circle(40, {10, 10, 0}, 6)}),
                                rim_of({circle(40, {10, 10, 9}, 2)})};
  std::vector<std::vector<Point>> clouds;
  std::vector<Overlap> overlaps;

  CoveredRim() : clouds({rims[1].loops[0].points, {{10, 10, 9}, {10, 10.5, 9}}}) {}
  void locate() {
    overlaps.clear();
    for (const CloudRim& rim : rims) overlaps.push_back(overlapping_facets(model, rim));
    for (int round = 0; round < 2; ++round) {  // the same each time
      excuse_covered_points(rims, clouds, overlaps, {});
    }
  }
};

TEST(OverlappingFacets, ARimOverAnotherCloudIsCovered) {
  CoveredRim scene;
  scene.locate();
  const LoopOverlap& loop = scene.overlaps[1].loops[0];
  EXPECT_EQ(loop.covered, 40U);
  EXPECT_EQ(loop.match, LoopMatch::covered);
  EXPECT_EQ(scene.overlaps[0].status, OverlapStatus::ok);
  EXPECT_EQ(scene.overlaps[1].status, OverlapStatus::ok);
  // What has cloud beyond it is not looked for.
  scene.rims[1].loops[0].inner.assign(40, 0);
  for (std::size_t i = 0; i < 11; ++i) scene.rims[1].loops[0].inner[i] = 1;
  scene.locate();
  EXPECT_EQ(scene.overlaps[1].loops[0].covered, 30U);
}

// A tenth of its points may lie on the model, since it starts somewhere there.
TEST(OverlappingFacets, ACoveredRimMayTouchTheModel) {
  for (const std::size_t below : {4U, 5U}) {
    CoveredRim scene;
    for (std::size_t i = 0; i < below; ++i) scene.rims[1].loops[0].points[i].z = 0;
    scene.locate();
    EXPECT_EQ(scene.overlaps[1].loops[0].covered, 40 - below);
    EXPECT_EQ(scene.overlaps[1].loops[0].match,
              below == 4 ? LoopMatch::covered : LoopMatch::on_model);
  }
}

// Two clouds in the air over each other, and a third one that reaches from there to the model: it
// holds both, whichever other cloud a point is looked for in first.
TEST(OverlappingFacets, CloudsThatCoverEachOtherLieOnTheModelByOneOfThem) {
  CoveredRim scene;
  const CloudRim in_the_air = scene.rims[1];
  scene.rims = {in_the_air, in_the_air, scene.rims[0]};
  scene.clouds.assign(3, in_the_air.loops[0].points);
  scene.locate();
  for (const Overlap& overlap : scene.overlaps) EXPECT_EQ(overlap.status, OverlapStatus::ok);
}

TEST(OverlappingFacets, CloudsThatCoverEachOtherInTheAirDoNotOverlapTheModel) {
  CoveredRim scene;
  for (Point& p : scene.rims[0].loops[0].points) p.z = 9;
  scene.clouds[1] = scene.rims[0].loops[0].points;
  scene.locate();
  EXPECT_EQ(scene.overlaps[0].loops[0].match, LoopMatch::covered);
  EXPECT_EQ(scene.overlaps[0].status, OverlapStatus::no_overlap);
  EXPECT_EQ(scene.overlaps[1].status, OverlapStatus::no_overlap);
}

TEST(OverlappingFacets, AHoleInsideTheCloudMayBeOffTheModel) {
  const TriangleMesh model = testing::grid_plane(30);
  const CloudRim rim = rim_of({circle(60, {15, 15, 0}, 10), circle(20, {15, 15, 8}, 3)});
  const Overlap overlap = overlapping_facets(model, rim);
  EXPECT_EQ(overlap.status, OverlapStatus::ok);
  EXPECT_EQ(overlap.loops[0].match, LoopMatch::on_model);
  EXPECT_EQ(overlap.loops[1].match, LoopMatch::off_model);
}

// One side on the model, the other below it: the shadow of a wall in a dent.
TEST(OverlappingFacets, ALoopThatIsPartlyRaisedIsAHole) {
  const TriangleMesh model = testing::grid_plane(30);
  RimLoop loop = circle(20, {15, 15, 0}, 4);
  for (Point& p : loop.points) p.z = p.x > 15 ? -2 : 0;
  const auto match = [&](double height, const OverlapOptions& options = {}) {
    CloudRim rim = rim_of({circle(60, {15, 15, height}, 10), loop});
    const Overlap overlap = overlapping_facets(model, rim, options);
    EXPECT_EQ(overlap.loops[0].match, LoopMatch::on_model);
    return overlap.loops[1].match;
  };
  EXPECT_EQ(match(0), LoopMatch::off_model);
  EXPECT_EQ(match(0, {.max_raised_share = 1}), LoopMatch::on_model);
  EXPECT_EQ(match(0, {.raised_distance = 3}), LoopMatch::on_model);
  // Where all of the scan is that far off, it is not raised.
  EXPECT_EQ(match(-1.5), LoopMatch::on_model);
  // Nor is the outline of another patch, but if more of it were.
  loop.component = 1;
  EXPECT_EQ(match(0), LoopMatch::on_model);
}

// The longest loop is what others are compared with, and not raised itself: here it climbs over
// something new for two fifths of its length.
TEST(OverlappingFacets, TheLongestLoopIsNotRaised) {
  const TriangleMesh model = testing::grid_plane(30);
  RimLoop loop = circle(60, {15, 15, 0}, 10);
  for (std::size_t i = 0; i < 24; ++i) loop.points[i].z = 2;
  const Overlap overlap = overlapping_facets(model, rim_of({loop}));
  EXPECT_EQ(overlap.loops[0].raised, 0U);
  EXPECT_EQ(overlap.status, OverlapStatus::ok);
}

// Of 20 points five are raised, and two so far that they have no facet: more than three tenths.
TEST(OverlappingFacets, PointsWithoutAFacetAreRaised) {
  const TriangleMesh model = testing::grid_plane(30);
  const auto raised = [&](std::size_t far) {
    RimLoop loop = circle(20, {15, 15, 0}, 4);
    for (std::size_t i = 0; i < 7; ++i) loop.points[i].z = i < far ? 9 : 2;
    for (std::size_t i = 5 + far; i < 7; ++i) loop.points[i].z = 0;
    return overlapping_facets(model, rim_of({circle(60, {15, 15, 0}, 10), loop})).loops[1];
  };
  EXPECT_EQ(raised(0).raised, 5U);
  EXPECT_EQ(raised(0).match, LoopMatch::on_model);
  EXPECT_EQ(raised(2).raised, 7U);
  EXPECT_EQ(raised(2).match, LoopMatch::off_model);
}

// Points on another cloud are raised by what is new there, not by a shadow.
TEST(OverlappingFacets, CoveredPointsOfALoopAreExcused) {
  CoveredRim scene;
  RimLoop hole = circle(20, {10, 10, 0}, 2);
  std::vector<Point> over;
  for (std::size_t i = 0; i < 8; ++i) {
    hole.points[i].z = 9;
    over.push_back(hole.points[i]);
  }
  scene.rims[0].loops.push_back(hole);
  scene.clouds[1] = over;
  scene.locate();
  EXPECT_EQ(scene.overlaps[0].loops[1].raised, 8U);
  EXPECT_EQ(scene.overlaps[0].loops[1].covered, 8U);
  EXPECT_EQ(scene.overlaps[0].loops[1].match, LoopMatch::on_model);
}

// Nothing is raised above an outline that has no facets, being over another cloud. Its feet say
// nothing: that they are close to the origin is no height.
TEST(OverlappingFacets, NothingIsRaisedAboveAnOutlineOverAnotherCloud) {
  TriangleMesh model = testing::grid_plane(20);
  for (Point& p : model.points) p = p - Vec3{10, 10, 9};
  RimLoop hole = circle(20, {0, 0, -9}, 1);
  for (std::size_t i = 0; i < 10; ++i) hole.points[i].z = -6.2;
  const CloudRim rim = rim_of({circle(60, {0, 0, 0}, 1.5), hole});
  const LoopOverlap found = overlapping_facets(model, rim).loops[1];
  EXPECT_EQ(found.unmatched, 0U);
  EXPECT_EQ(found.raised, 0U);
  EXPECT_EQ(found.match, LoopMatch::on_model);
}

// A long facet pair (the floor) and above it a shelf whose vertices are nearer.
TriangleMesh floor_and_shelf() {
  TriangleMesh mesh;
  for (const Point& p : {Point{-50, -50, 0}, Point{50, -50, 0}, Point{0, 60, 0},   // floor
                         Point{0, 0, 2}, Point{30, 1, 2.5}, Point{0, 30, 2.5}}) {  // shelf above
    mesh.points.push_back(p);
  }
  mesh.triangles.push_back({VertexId(0), VertexId(1), VertexId(2)});
  mesh.triangles.push_back({VertexId(3), VertexId(4), VertexId(5)});
  return mesh;
}

// Nearest vertex and closest facet differ where facets are long: the nearest vertex belongs to
// facets whose planes are far from the point.
TEST(OverlappingFacets, LongFacetsMisleadTheNearestVertexRule) {
  const TriangleMesh mesh = floor_and_shelf();
  const CloudRim rim = rim_of({circle(8, {2, 2, 0.1}, 0.5)});
  const Overlap closest = overlapping_facets(mesh, rim, {.max_distance = 100});
  const Overlap star = overlapping_facets(
      mesh, rim, {.rule = LocationRule::nearest_vertex_star, .max_distance = 100});
  EXPECT_EQ(closest.facets, std::vector<TriangleId>{TriangleId(0)});
  EXPECT_EQ(star.facets, std::vector<TriangleId>{TriangleId(1)});
  EXPECT_EQ(star.figures.star_misses, 0U);
}

// Beside the shelf no facet of the nearest vertex has the projection: the closest facet is taken,
// and each such point counted.
TEST(OverlappingFacets, AProjectionInNoFacetOfTheStarIsCounted) {
  const TriangleMesh mesh = floor_and_shelf();
  const CloudRim rim = rim_of({circle(8, {-3, -3, 0.1}, 0.5)});
  const Overlap star = overlapping_facets(
      mesh, rim, {.rule = LocationRule::nearest_vertex_star, .max_distance = 100});
  EXPECT_EQ(star.facets, std::vector<TriangleId>{TriangleId(0)});
  EXPECT_EQ(star.figures.star_misses, 8U);
  EXPECT_EQ(overlapping_facets(mesh, rim, {.max_distance = 100}).figures.star_misses, 0U);
}

// Each point has its facet; the set of facets has it once.
TEST(OverlappingFacets, SeveralPointsInOneFacetGiveItOnce) {
  const TriangleMesh mesh = floor_and_shelf();
  const Overlap overlap =
      overlapping_facets(mesh, rim_of({circle(12, {-3, -3, 0.1}, 0.5)}), {.max_distance = 100});
  ASSERT_EQ(overlap.loops.size(), 1U);
  EXPECT_EQ(overlap.loops[0].facets, std::vector<TriangleId>(12, TriangleId(0)));
  EXPECT_EQ(overlap.facets, std::vector<TriangleId>{TriangleId(0)});
}

// Above a vertex of a plane six facets have the projection, at one distance.
TEST(OverlappingFacets, TiesAreDecidedByCorners) {
  const TriangleMesh model = testing::grid_plane(20);
  TriangleMesh turned = model;  // other ids, other first corners
  std::reverse(turned.triangles.begin(), turned.triangles.end());
  for (Triangle& t : turned.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
  RimLoop loop = circle(40, {10, 10, 0.3}, 6.2);
  for (Point& p : loop.points) p = {std::round(p.x), std::round(p.y), p.z};
  const CloudRim rim = rim_of({loop});
  for (const LocationRule rule : {LocationRule::closest_facet, LocationRule::nearest_vertex_star}) {
    const Overlap overlap = overlapping_facets(model, rim, {.rule = rule});
    const Overlap of_turned = overlapping_facets(turned, rim, {.rule = rule});
    ASSERT_EQ(overlap.unmatched + of_turned.unmatched, 0U);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(sorted_corners(corners_of(model, overlap.loops[0].facets[i])),
                sorted_corners(corners_of(turned, of_turned.loops[0].facets[i])));
    }
  }
}

TEST(OverlappingFacets, SameForAnyThreadCount) {
  const TriangleMesh model = testing::sphere(5);
  const CloudRim rim = rim_of({testing::cap_rim(500, unit(Vec3{1, -2, 0.5}), 1.1)});
  const Overlap one = overlapping_facets(model, rim);
  const Overlap four = overlapping_facets(model, rim, {}, {.threads = 4});
  EXPECT_EQ(one.facets, four.facets);
  EXPECT_EQ(one.loops[0].feet, four.loops[0].feet);
}

}  // namespace
}  // namespace cocoon
