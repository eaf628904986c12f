// Whether a body that goes on from one before is smooth, and what has changed, is as if both had
// been looked at as a whole.
#include "cocone/kept/kept_body.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geom/random/random.h"
#include "tests/cocone/kept/live_body.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/gallery.h"
#include "tests/long_tests.h"

namespace cocoon {
namespace {

using Surface = std::set<CornerPoints>;

class Following {
 public:
  explicit Following(const std::vector<Point>& points) : live_(points) {}

  void change_nearby(double reach, Random& random) {
    live_.change_nearby(reach, random, [&](const auto& what) { follow(what); });
  }
  void change(const std::vector<VertexId>& removed, const std::vector<Point>& inserted) {
    live_.change(removed, inserted, [&](const auto& what) { follow(what); });
  }

  // Takes the body with such dents and holes. Whether it is smooth.
  bool take(std::uint64_t dents, std::uint64_t holes) {
    live_.lend([&](const Triangulation& triangulation) {
      take(triangulation, LiveBody::out(triangulation, dents, holes));
    });
    return kept_.is_smooth();
  }

  std::size_t told() const { return told_; }
  std::size_t untouched() const { return untouched_; }
  const LiveBody& live() const { return live_; }

 private:
  void follow(const DelaunayChange& change) {
    if (kept_.exists()) kept_.update(live_.delaunay(), change);
  }
  void follow(const Renumbering& renumbering) {
    if (kept_.exists()) kept_.renumber(renumbering, live_.delaunay());
  }

  void take(const Triangulation& triangulation, const IdVector<CellId, std::uint8_t>& out) {
    const auto& cell_at = live_.delaunay().cells_at_vertices();
    KeptBody whole;
    EXPECT_FALSE(whole.take(triangulation, cell_at, out, true));
    EXPECT_FALSE(whole.is_smooth());
    whole.look_if_smooth(triangulation);
    const bool was_smooth = kept_.is_smooth();
    const std::optional<KeptBody::Change> change = kept_.take(triangulation, cell_at, out, true);
    kept_.look_if_smooth(triangulation);
    ASSERT_EQ(kept_.is_smooth(), whole.is_smooth());
    EXPECT_EQ(change.has_value(), was_smooth && whole.is_smooth());
    expect_sides(triangulation, out);
    Surface now;
    LiveBody::for_boundary(triangulation, out, [&](FacetId f) {
      now.insert(LiveBody::corner_points(triangulation, triangulation.facet_vertices(f)));
    });
    if (change) expect_change(triangulation, *change, now);
    before_ = std::move(now);
  }

  // What is kept is the body, as it will be before the next change.
  void expect_sides(const Triangulation& triangulation,
                    const IdVector<CellId, std::uint8_t>& out) const {
    const BodyBefore body = kept_.before(triangulation);
    EXPECT_TRUE(body.created.empty());
    for (const CellId c : triangulation.cells()) {
      const CellLabel side = out[c] != 0 ? CellLabel::out : CellLabel::in;
      EXPECT_EQ(body.labels[c], triangulation.is_infinite(c) ? CellLabel::unmarked : side);
    }
  }

  // All triangles of before without a touched corner, or one that is gone, and those told.
  void expect_change(const Triangulation& triangulation, const KeptBody::Change& change,
                     const Surface& now) {
    std::set<Point> untouched;
    for (const VertexId v : triangulation.vertices()) untouched.insert(triangulation.point(v));
    for (const VertexId v : change.touched) untouched.erase(triangulation.point(v));
    Surface expected;
    std::copy_if(before_.begin(), before_.end(), std::inserter(expected, expected.end()),
                 [&](const CornerPoints& t) {
                   return std::all_of(t.begin(), t.end(),
                                      [&](const Point& p) { return untouched.contains(p); });
                 });
    for (const auto& corners : change.triangles) {
      const CornerPoints t = LiveBody::corner_points(triangulation, corners);
      EXPECT_FALSE(
          std::all_of(t.begin(), t.end(), [&](const Point& p) { return untouched.contains(p); }));
      EXPECT_TRUE(expected.insert(t).second);
    }
    EXPECT_EQ(expected, now);
    ++told_;
    untouched_ += untouched.size();
  }

  LiveBody live_;
  KeptBody kept_;
  Surface before_;
  std::size_t told_ = 0;
  std::size_t untouched_ = 0;
};

TEST(KeptBody, GoesOnAsIfItWereKeptAnew) {
  const std::size_t steps = 150 * test::long_factor();
  Random random(5);
  Following following(shapes::ellipsoid(300, 3));
  following.take(3, 0);
  std::size_t kept = 0;
  for (std::size_t step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    following.change_nearby(0.3, random);
    const std::uint64_t dents = random.below(3) == 0 ? 2 + random.below(4) : 3;
    const std::uint64_t holes = random.below(4) == 0 ? 300 : 0;
    kept += following.take(dents, holes) ? 1U : 0U;
    if (HasFailure()) return;
  }
  // Both happen, and most of the surface is not touched.
  EXPECT_GT(kept, steps / 2);
  EXPECT_LT(kept, steps);
  EXPECT_GT(following.told(), steps / 3);
  EXPECT_GT(following.untouched(), following.told() * 150);
}

struct Follow {
  KeptBody& kept;
  const LiveBody& live;
  void operator()(const DelaunayChange& change) const { kept.update(live.delaunay(), change); }
  void operator()(const Renumbering& moves) const { kept.renumber(moves, live.delaunay()); }
};

// Elsewhere nothing is touched, since what comes is in no ball of what was there; it hangs
// together, but not with that.
TEST(KeptBody, IsNotSmoothWhereAnotherOneAppears) {
  const std::vector<Point> first = gallery::scaled(gallery::integer_sphere(89), 0.125);
  const std::vector<Point> second = shapes::moved(first, {8, 0, 0});
  LiveBody live(shapes::joined(first, second));
  // Cells between the two are OUT.
  const auto out = [](const Triangulation& triangulation) {
    IdVector<CellId, std::uint8_t> labels = LiveBody::out(triangulation, 0, 0);
    for (const CellId c : triangulation.finite_cells()) {
      std::size_t right = 0;
      for (const VertexId v : triangulation.cell(c).vertices) {
        right += triangulation.point(v).x > 4 ? 1U : 0U;
      }
      if (right % 4 != 0) labels[c] = 1;
    }
    return labels;
  };
  KeptBody kept;
  std::optional<KeptBody::Change> change;
  const auto take = [&](const Triangulation& triangulation) {
    change =
        kept.take(triangulation, live.delaunay().cells_at_vertices(), out(triangulation), true);
    kept.look_if_smooth(triangulation);
  };
  live.lend(take);
  EXPECT_FALSE(kept.is_smooth());

  std::vector<VertexId> removed;
  for (const VertexId v : id_range<VertexId>(live.delaunay().num_vertices())) {
    if (live.delaunay().point(v).x > 4) removed.push_back(v);
  }
  live.change(removed, {}, Follow{kept, live});
  live.lend(take);
  ASSERT_TRUE(kept.is_smooth());
  live.change({}, second, Follow{kept, live});
  live.lend(take);
  EXPECT_FALSE(change);
  EXPECT_FALSE(kept.is_smooth());
}

// What was kept of a body is taken up from the cells that are out.
TEST(KeptBody, IsResumedFromTheCellsThatAreOut) {
  LiveBody live(shapes::ellipsoid(300, 3));
  live.lend([&](const Triangulation& triangulation) {
    const auto& cell_at = live.delaunay().cells_at_vertices();
    const auto out = LiveBody::out(triangulation, 3, 0);
    KeptBody kept;
    EXPECT_FALSE(kept.take(triangulation, cell_at, out, true));
    EXPECT_EQ(kept.out(), out);
    KeptBody resumed;
    resumed.resume(triangulation, kept.out());
    EXPECT_EQ(resumed.before(triangulation).labels, kept.before(triangulation).labels);
    EXPECT_FALSE(resumed.may_be_smooth());
    // The same cells: nothing has changed.
    EXPECT_FALSE(resumed.take(triangulation, cell_at, out, true));
    resumed.look_if_smooth(triangulation);
    ASSERT_TRUE(resumed.is_smooth());
    const std::optional<KeptBody::Change> change = resumed.take(triangulation, cell_at, out, true);
    ASSERT_TRUE(change);
    EXPECT_TRUE(change->triangles.empty());
  });
}

// A point inside the body has no facet of the boundary, and touches none.
TEST(KeptBody, IsNotSmoothWhereAPointIsLeftOut) {
  Following following(shapes::ellipsoid(200, 3));
  ASSERT_TRUE(following.take(0, 0));
  following.change({}, {{0.01, 0.02, 0.03}});
  EXPECT_FALSE(following.take(0, 0));
}

}  // namespace
}  // namespace cocoon
