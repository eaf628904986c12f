#include "cocone/energy/label_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "cocone/clean_up_cells.h"
#include "cocone/facets/cell_order.h"
#include "geom/random/random.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/cocone/stages.h"
#include "tests/gallery.h"

namespace cocoon {
namespace {

// Samples with random marks. Labels of cells are those of a half-space, but for some.
struct Scene {
  Scene(const std::vector<Point>& points, double good_share, std::uint64_t seed,
        int thin_support = 2)
      : stages(points) {
    const Triangulation& t = stages.triangulation;
    Random random(seed);
    marks.good = VertexSet(t.num_vertices(), 0);
    marks.contradicted = VertexSet(t.num_vertices(), 0);
    marks.conflicts = 1;
    for (const VertexId v : t.vertices()) {
      marks.good[v] = random.uniform() < good_share ? 1 : 0;
      if (marks.good[v] != 0 && random.uniform() < 0.2) marks.contradicted[v] = 1;
    }
    marks.labels = IdVector<CellId, CellLabel>(t.num_cells(), CellLabel::out);
    const Vec3 up = random.on_unit_sphere();
    for (const CellId c : t.finite_cells()) {
      const bool above = dot(t.point(t.cell(c).vertices[0]) - t.point(VertexId(1)), up) > 0;
      marks.labels[c] = above ? CellLabel::out : CellLabel::in;
      if (random.uniform() < 0.3) marks.labels[c] = CellLabel::unmarked;
    }
    StarCache stars(t);
    SpacingCache spacings(t, stars);
    region = find_doubtful_region(t, marks, stars, spacings, t.num_cells(), thin_support);
  }

  bool is_thin(CellId c) const { return !is_poor(stages.triangulation, marks.good, c); }

  Stages stages;
  CellMarks marks;
  DoubtfulRegion region;
};

// The same by asking all cells at every turn.
class PlainEvidence {
 public:
  PlainEvidence(const Scene& scene, const CleanUpOptions& options)
      : scene_(scene),
        t_(scene.stages.triangulation),
        cosines_(t_, options.flat_ratio),
        stars_(t_),
        spacings_(t_, stars_),
        evidence_(t_.num_cells()),
        is_undecided_(t_.num_cells(), 0),
        poles_(t_.num_vertices()) {
    std::vector<CellId> all;
    for (const CellId c : t_.cells()) all.push_back(c);
    centers_ = cosines_.prepare(all, {});
    for (const CellId c : scene.region.undecided) is_undecided_[c] = 1;
    for (const VertexId v : t_.vertices()) poles_[v] = poles_of(v, options);
    hear_infinity();
    for (const CellId c : t_.finite_cells()) {
      if (is_undecided_[c] == 0) tell(c, is_out(c), 1);
    }
    for (const CellId c : scene.region.undecided) {
      if (has_credit(c)) hear(c, is_out(c), options.mark_credit);
    }
    settle();
  }

  const LabelEvidence& operator[](CellId c) const { return evidence_[c]; }

 private:
  // Cells that are none: at infinity, or there is no such pole.
  struct PolePair {
    bool on_hull = false;
    CellId positive;
    CellId negative;
    double trust = 1;
  };

  bool is_out(CellId c) const { return scene_.marks.labels[c] == CellLabel::out; }

  bool has_credit(CellId c) {
    if (cosines_.is_flat(c) || !scene_.is_thin(c)) return false;
    const auto& vertices = t_.cell(c).vertices;
    return std::none_of(vertices.begin(), vertices.end(),
                        [&](VertexId v) { return scene_.marks.contradicted[v] != 0; });
  }

  Vec3 arm(VertexId v, CellId c) const { return centers_[c] - t_.point(v); }

  // Farther off, then with the smaller center, then with the smaller corners.
  bool is_rather_pole(VertexId v, CellId a, CellId b) const {
    if (b.is_none()) return true;
    const double square_a = squared_norm(arm(v, a)), square_b = squared_norm(arm(v, b));
    if (square_a != square_b) return square_a > square_b;
    return std::pair(centers_[a], sorted_corners(t_, a)) <
           std::pair(centers_[b], sorted_corners(t_, b));
  }

  PolePair poles_of(VertexId v, const CleanUpOptions& options) {
    PolePair pair;
    std::vector<CellId> cells;
    for (const CellId c : scene_.stages.stars.star(v)) {
      if (t_.is_infinite(c)) pair.on_hull = true;
      if (!t_.is_infinite(c) && !cosines_.is_flat(c)) cells.push_back(c);
    }
    for (const CellId c : cells) {
      if (!pair.on_hull && is_rather_pole(v, c, pair.positive)) pair.positive = c;
    }
    for (const CellId c : cells) {
      const Vec3 normal = pair.on_hull ? scene_.stages.poles.normals[v] : arm(v, pair.positive);
      if (dot(arm(v, c), normal) < 0 && is_rather_pole(v, c, pair.negative)) pair.negative = c;
    }
    if (pair.negative.is_none()) return pair;
    const double ratio = norm(arm(v, pair.negative)) / spacings_.of(v);
    double far = 1;
    if (ratio < options.full_pole_ratio) {
      far = std::max(0.0, (ratio - options.near_pole_ratio) /
                              (options.full_pole_ratio - options.near_pole_ratio));
    }
    pair.trust = far + (1 - far) * std::min(1.0, good_around(v) / options.pole_good_share);
    return pair;
  }

  double good_around(VertexId v) {
    double good = 0;
    double corners = 0;
    for (const CellId c : scene_.stages.stars.star(v)) {
      if (t_.is_infinite(c)) continue;
      for (const VertexId w : t_.cell(c).vertices) {
        if (w == v) continue;
        good += scene_.marks.good[w];
        ++corners;
      }
    }
    return corners == 0 ? 0 : good / corners;
  }

  void hear(CellId c, bool out, double weight) {
    if (c.is_none() || is_undecided_[c] == 0 || !(weight > 0)) return;
    float& value = out ? evidence_[c].out : evidence_[c].in;
    value = std::max(value, static_cast<float>(weight));
  }

  void hear_infinity() {
    for (const VertexId v : t_.vertices()) {
      const CellId inner = poles_[v].negative;
      if (!poles_[v].on_hull || inner.is_none()) continue;
      const double cosine = dot(scene_.stages.poles.normals[v], unit(arm(v, inner)));
      hear(inner, false, poles_[v].trust * -cosine);
    }
  }

  // Both rules, from a finite cell.
  void tell(CellId c, bool out, double weight) {
    if (cosines_.is_flat(c)) return;
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(c, i);
      hear(cosines_.beyond(f), out, weight * cosines_.contact(f));
    }
    for (const VertexId v : t_.cell(c).vertices) {
      const auto [on_hull, positive, negative, trust] = poles_[v];
      if (positive.is_none() || negative.is_none() || (c != positive && c != negative)) continue;
      const double cosine = dot(unit(arm(v, positive)), unit(arm(v, negative)));
      hear(c == positive ? negative : positive, !out, weight * trust * -cosine);
    }
  }

  bool has_turn_before(CellId a, CellId b) const {
    const auto clarity = [&](CellId c) {
      const auto [out, in] = evidence_[c];
      // The contested behind all others, as floats tell them apart.
      return out == 0 || in == 0 ? std::max(out, in) : std::abs(out - in) - 1;
    };
    if (clarity(a) != clarity(b)) return clarity(a) > clarity(b);
    return sorted_ranks(a) < sorted_ranks(b);
  }

  std::array<std::uint32_t, 4> sorted_ranks(CellId c) const {
    std::array<std::uint32_t, 4> ranks;
    for (std::size_t i = 0; i < 4; ++i) ranks[i] = scene_.region.rank[t_.cell(c).vertices[i]];
    std::sort(ranks.begin(), ranks.end());
    return ranks;
  }

  void settle() {
    std::vector<CellId> left = scene_.region.undecided;
    while (true) {
      auto next = left.end();
      for (auto c = left.begin(); c != left.end(); ++c) {
        if (evidence_[*c].out == 0 && evidence_[*c].in == 0) continue;
        if (next == left.end() || has_turn_before(*c, *next)) next = c;
      }
      if (next == left.end()) return;
      const CellId c = *next;
      left.erase(next);
      tell(c, evidence_[c].out >= evidence_[c].in, std::max(evidence_[c].out, evidence_[c].in));
    }
  }

  const Scene& scene_;
  const Triangulation& t_;
  BallCosines cosines_;
  StarCache stars_;
  SpacingCache spacings_;
  ZeroedArray<CellId, Point> centers_;

  IdVector<CellId, LabelEvidence> evidence_;
  IdVector<CellId, std::uint8_t> is_undecided_;
  IdVector<VertexId, PolePair> poles_;
};

ZeroedArray<CellId, LabelEvidence> evidence_of(const Scene& scene,
                                               const CleanUpOptions& options = {}) {
  const Triangulation& t = scene.stages.triangulation;
  BallCosines cosines(t, options.flat_ratio);
  StarCache stars(t);
  SpacingCache spacings(t, stars);
  const ZeroedArray<CellId, Point> centers = cosines.prepare(scene.region.cells, {});
  return label_evidence(t, stars, cosines, centers, spacings, scene.stages.poles, scene.marks,
                        scene.region, options);
}

struct Counts {
  std::size_t contested = 0;
  std::size_t uncontested = 0;
  std::size_t thin = 0;
  std::size_t flat = 0;
};

Counts compare(const Scene& scene, const CleanUpOptions& options = {}) {
  const Triangulation& t = scene.stages.triangulation;
  const ZeroedArray<CellId, LabelEvidence> evidence = evidence_of(scene, options);
  const PlainEvidence plain(scene, options);
  BallCosines cosines(t, options.flat_ratio);
  Counts counts;
  std::size_t unlike = 0;
  for (const CellId c : t.cells()) {
    const auto [out, in] = evidence[c];
    unlike += out != plain[c].out || in != plain[c].in ? 1U : 0U;
    if (out > 0 && in > 0) ++counts.contested;
    if ((out > 0) != (in > 0)) ++counts.uncontested;
  }
  for (const CellId c : scene.region.undecided) {
    counts.flat += cosines.is_flat(c) ? 1U : 0U;
    counts.thin += scene.is_thin(c) ? 1U : 0U;
  }
  EXPECT_EQ(unlike, 0U) << "of " << scene.region.undecided.size() << " undecided cells";
  return counts;
}

// Turned, so that what lies in planes does so but for roundings.
std::vector<Point> turned(const std::vector<Point>& points) {
  std::vector<Point> result;
  for (const Point& p : points) {
    result.push_back({(2 * p.x - p.y + 2 * p.z) / 3, (2 * p.x + 2 * p.y - p.z) / 3,
                      (-p.x + 2 * p.y + 2 * p.z) / 3});
  }
  return result;
}

TEST(LabelEvidence, IsThatOfTheStrongestChains) {
  Counts all;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const auto& points :
         {shapes::noisy_sphere(300, 0.05, seed), shapes::random_cube(200, seed),
          shapes::random_torus(300, 0.4, seed)}) {
      for (const double good_share : {0.05, 0.4}) {
        const Counts counts = compare(Scene(points, good_share, seed));
        all.contested += counts.contested;
        all.uncontested += counts.uncontested;
        all.thin += counts.thin;
      }
    }
  }
  EXPECT_GT(all.contested, 1000U);
  EXPECT_GT(all.uncontested, 1000U);
  EXPECT_GT(all.thin, 1000U);
}

TEST(LabelEvidence, TiesGoToTheSmallerCorners) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const auto& points : {gallery::integer_grid(5), shapes::cube_grid(4), shapes::plate(7, 2),
                               gallery::integer_sphere(41)}) {
      for (const double good_share : {0.02, 0.3}) {
        compare(Scene(points, good_share, seed), {.flat_ratio = 0});
      }
    }
  }
}

TEST(LabelEvidence, BallsMeetThroughFlatCells) {
  std::size_t flat = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const auto& points : {turned(gallery::integer_grid(5)), turned(shapes::plate(7, 2)),
                               turned(gallery::cylinder(4))}) {
      for (const double good_share : {0.05, 0.3}) {
        flat += compare(Scene(points, good_share, seed)).flat;
      }
    }
  }
  EXPECT_GT(flat, 100U);
}

// Samples in a thick layer: their nearer poles say less, and those within one spacing nothing.
TEST(LabelEvidence, NearPolesSayLess) {
  const Scene scene(shapes::noisy_sphere(300, 0.1, 3), 0.05, 3);
  compare(scene, {.near_pole_ratio = 0, .full_pole_ratio = 0});
  compare(scene, {.near_pole_ratio = 0.5, .full_pole_ratio = 8});
  const auto all = [&](const CleanUpOptions& options) {
    const ZeroedArray<CellId, LabelEvidence> evidence = evidence_of(scene, options);
    double sum = 0;
    for (const CellId c : scene.region.undecided) sum += evidence[c].out + evidence[c].in;
    return sum;
  };
  const double always = all({.near_pole_ratio = 0, .full_pole_ratio = 0});
  const double never = all({.near_pole_ratio = 1e6, .full_pole_ratio = 2e6});
  EXPECT_LT(never, 0.95 * always);
  EXPECT_LT(all({}), always);
  EXPECT_GT(all({}), never);
}

// All that is known is infinity: what is deep within hears of it by the poles of the hull.
TEST(LabelEvidence, InfinityIsOut) {
  const Scene scene(shapes::noisy_sphere(300, 0.02, 5), 0, 5);
  EXPECT_EQ(scene.region.undecided.size(), scene.stages.triangulation.num_finite_cells());
  EXPECT_GT(compare(scene).uncontested, 100U);
}

TEST(LabelEvidence, IsNoneWhereNothingIsUndecided) {
  const Scene scene(shapes::sphere(100, 6), 1, 6, 0);
  EXPECT_TRUE(scene.region.undecided.empty());
  const Counts counts = compare(scene);
  EXPECT_EQ(counts.contested + counts.uncontested, 0U);
}

}  // namespace
}  // namespace cocoon
