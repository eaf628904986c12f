#include "cocone/solid/solid_distances.h"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "geom/errors.h"
#include "geom/signed_distance.h"
#include "tests/gallery.h"
#include "tests/mesh_gallery.h"

namespace cocoon {
namespace {

// Places that are new, known, given twice, and none.
TEST(SolidDistances, AreTheSignedDistancesWhateverWasAskedBefore) {
  const TriangleMesh box = gallery::translated(gallery::box(1, 0.8, 0.6), {0.1, 0.1, 0.1});
  const std::vector<Point> places = gallery::uniform_cube(600);
  const std::vector<double> expected = signed_distances(box, places);
  const SolidDistances once(box);
  const SolidDistances remembered(std::make_shared<const TriangleMesh>(box));
  EXPECT_EQ(once.at(places), expected);
  for (const std::size_t count : {575, 200, 0, 150, 600, 600}) {
    std::vector<Point> asked(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<double> wanted(expected.begin(),
                               expected.begin() + static_cast<std::ptrdiff_t>(count));
    asked.insert(asked.end(), places.rbegin(), places.rbegin() + 50);
    wanted.insert(wanted.end(), expected.rbegin(), expected.rbegin() + 50);
    EXPECT_EQ(remembered.at(asked), wanted);
    EXPECT_EQ(once.at(asked), wanted);
  }
}

// What is known is not looked for again: here the mesh has changed behind its back.
TEST(SolidDistances, AreRememberedByAllCopies) {
  const auto box = std::make_shared<TriangleMesh>(gallery::box(1, 1, 1));
  const std::vector<Point> places = gallery::uniform_cube(100);
  const SolidDistances remembered(std::shared_ptr<const TriangleMesh>{box});
  const SolidDistances copy = remembered;
  const std::vector<double> before = remembered.at(places);
  *box = gallery::translated(*box, {10, 0, 0});
  EXPECT_EQ(copy.at(places), before);
  EXPECT_EQ(&copy.solid(), box.get());
  EXPECT_NE(SolidDistances(*box).at(places), before);
  EXPECT_GT(copy.at(std::vector<Point>{{0.5, 0.5, 2}}).front(), 9);
}

TEST(SolidDistances, NoTrianglesAreNoSolid) {
  const TriangleMesh none;
  EXPECT_THROW(SolidDistances(none).at(std::vector<Point>{{0, 0, 0}}), InputError);
}

}  // namespace
}  // namespace cocoon
