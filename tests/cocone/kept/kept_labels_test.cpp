// Sides told where something has changed are those that the whole old mesh tells.
#include "cocone/kept/kept_labels.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cocone/kept/kept_body.h"
#include "geom/random/random.h"
#include "tests/cocone/kept/live_body.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/long_tests.h"

namespace cocoon {
namespace {

class Following {
 public:
  explicit Following(const std::vector<Point>& points) : live_(points) { take_body(3); }

  bool exists() const { return kept_.exists(); }

  // After a change nearby: one of `unknown` triangles is not known (0: all that can be are).
  KnownLabels step(double reach, std::uint64_t unknown, Random& random) {
    live_.change_nearby(reach, random, [&](const auto& what) { follow(what); });
    KnownLabels sides;
    live_.lend([&](const Triangulation& triangulation) {
      sides = compare(triangulation, unknown, random);
    });
    return sides;
  }

  void take_body(std::uint64_t dents) {
    live_.lend([&](const Triangulation& triangulation) {
      const IdVector<CellId, std::uint8_t> out = LiveBody::out(triangulation, dents, 0);
      kept_.take(triangulation, live_.delaunay().cells_at_vertices(), out, false);
      mesh_.clear();
      LiveBody::for_boundary(triangulation, out, [&](FacetId f) {
        mesh_.push_back(LiveBody::corner_points(triangulation, triangulation.facet_vertices(f)));
      });
    });
  }

 private:
  void follow(const DelaunayChange& change) { kept_.update(live_.delaunay(), change); }
  void follow(const Renumbering& renumbering) { kept_.renumber(renumbering, live_.delaunay()); }

  KnownLabels compare(const Triangulation& triangulation, std::uint64_t unknown, Random& random) {
    std::map<Point, PointId> now;
    for (const VertexId v : triangulation.vertices())
      now[triangulation.point(v)] = PointId(v.value);
    std::vector<PointId> torn;
    std::vector<KnownTriangle> known;
    for (const CornerPoints& t : mesh_) {
      std::vector<PointId> stay;
      for (const Point& p : t) {
        if (now.contains(p)) stay.push_back(now[p]);
      }
      if (stay.size() < 3 || (unknown != 0 && random.below(unknown) == 0)) {
        torn.insert(torn.end(), stay.begin(), stay.end());
      } else {
        known.push_back({stay[0], stay[1], stay[2]});
      }
    }
    std::size_t asked = 0;
    OldSurface old;
    old.triangles = {[&] { return torn; },
                     [&](std::span<const PointId> points) {
                       const std::set<PointId> at(points.begin(), points.end());
                       asked = at.size();
                       std::vector<KnownTriangle> found;
                       std::copy_if(known.begin(), known.end(), std::back_inserter(found),
                                    [&](const KnownTriangle& t) {
                                      return std::ranges::any_of(
                                          t, [&](PointId p) { return at.contains(p); });
                                    });
                       return found;
                     }};
    old.add_likely = [](const Triangulation& of, KnownLabels& so_far, const Execution&) {
      so_far.likely = IdVector<CellId, CellLabel>(of.num_cells(), CellLabel::in);
    };
    const KnownLabels actual = kept_labels(triangulation, live_.delaunay().cells_at_vertices(),
                                           kept_.before(triangulation), old);
    const KnownLabels expected =
        known_labels(triangulation, known, FacetSet(triangulation.num_cells()));
    EXPECT_EQ(actual.labels, expected.labels);
    EXPECT_EQ(actual.cells, expected.cells);
    EXPECT_EQ(actual.contradictions, expected.contradictions);
    EXPECT_EQ(actual.likely.size(), triangulation.num_cells());
    not_asked_ += triangulation.num_vertices() - asked;
    return actual;
  }

 public:
  std::size_t not_asked() const { return not_asked_; }

 private:
  LiveBody live_;
  KeptBody kept_;
  std::vector<CornerPoints> mesh_;
  std::size_t not_asked_ = 0;
};

TEST(KeptLabels, AreThoseOfTheWholeMesh) {
  const std::size_t steps = 60 * test::long_factor();
  Random random(7);
  Following following(shapes::ellipsoid(300, 3));
  std::size_t known = 0;
  for (std::size_t step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    ASSERT_TRUE(following.exists());
    const std::array<std::uint64_t, 4> unknown{0, 100, 10, 1};
    const KnownLabels sides =
        following.step(random.below(8) == 0 ? 0.8 : 0.3, unknown[random.below(4)], random);
    known += sides.cells;
    if (HasFailure()) return;
    following.take_body(3);
  }
  EXPECT_GT(known, steps * 300);
  EXPECT_GT(following.not_asked(), steps * 50);
}

}  // namespace
}  // namespace cocoon
