#include "geom/circumsphere_batch.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <span>

#include "geom/circumsphere.h"
#include "tests/geom/near_degenerate.h"

namespace cocoon {
namespace {

using test::Family;
using test::NearDegenerate;

void set_tetrahedron(CircumcenterBatch& batch, std::size_t i, const std::array<Point, 4>& p) {
  for (std::size_t corner = 0; corner < 4; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      batch.corners[corner][static_cast<std::size_t>(axis)][i] = p[corner][axis];
    }
  }
}

Point center_in(const CircumcenterBatch& batch, std::size_t i) {
  return {batch.centers[0][i], batch.centers[1][i], batch.centers[2][i]};
}

std::array<std::uint64_t, 3> bits_of(const Point& p) {
  return {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
          std::bit_cast<std::uint64_t>(p.z)};
}

// Certified only where circumcenter() needs no integers, and then the same bits.
TEST(CircumcenterBatch, EqualsTheSingleOneBitForBit) {
  NearDegenerate random(5);
  std::size_t certified = 0;
  std::size_t in_doubles = 0;
  std::size_t in_integers = 0;
  for (int f = 0; f < static_cast<int>(Family::last); ++f) {
    for (int round = 0; round < 200; ++round) {
      CircumcenterBatch batch;
      std::array<Circumcenter, circumcenter_batch_size> expected;
      for (std::size_t i = 0; i < circumcenter_batch_size; ++i) {
        const auto [a, b, c, d, e] = random.points(static_cast<Family>(f));
        set_tetrahedron(batch, i, {a, b, c, d});
        expected[i] = circumcenter(a, b, c, d);
      }
      circumcenters_in_doubles(std::span(&batch, 1));
      for (std::size_t i = 0; i < circumcenter_batch_size; ++i) {
        (expected[i].level == CenterLevel::doubles ? in_doubles : in_integers) += 1;
        if (((batch.certified >> i) & 1U) == 0) continue;
        ++certified;
        ASSERT_EQ(expected[i].level, CenterLevel::doubles);
        ASSERT_EQ(bits_of(center_in(batch, i)), bits_of(expected[i].center));
      }
    }
  }
  // Left out beside those that need integers: a few of extreme size.
  EXPECT_GT(certified, in_doubles / 5 * 4);
  EXPECT_GT(in_integers, 100U);
}

// From regular ones to those that floating point cannot tell from flat, in batches with others, and
// of edges of all lengths; half of them with first coordinates that are equal. The bounds decide
// the same whether they are looked at or not.
TEST(CircumcenterBatch, CertifiesSliversAsTheSingleOne) {
  NearDegenerate random(9);
  std::size_t certified = 0;
  std::size_t different = 0;
  for (int flat = 0; flat <= 60; ++flat) {
    for (int round = 0; round < 50; ++round) {
      CircumcenterBatch batch;
      std::array<Circumcenter, circumcenter_batch_size> expected;
      for (std::size_t i = 0; i < circumcenter_batch_size; ++i) {
        std::array<Point, 4> p;
        const bool is_sliver = random.integer(0, 3) != 0;
        for (Point& q : p) {
          q = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
          if (round % 2 == 0) q.x = random.integer(-1, 1);
          if (is_sliver) q.z = std::ldexp(q.z, -flat);
        }
        p[1] = p[0] + std::ldexp(1.0, -random.integer(0, 30)) * (p[1] - p[0]);
        set_tetrahedron(batch, i, p);
        expected[i] = circumcenter(p[0], p[1], p[2], p[3]);
      }
      circumcenters_in_doubles(std::span(&batch, 1));
      for (std::size_t i = 0; i < circumcenter_batch_size; ++i) {
        const bool is_certified = ((batch.certified >> i) & 1U) != 0;
        different += is_certified != (expected[i].level == CenterLevel::doubles) ? 1U : 0U;
        if (!is_certified) continue;
        ++certified;
        ASSERT_EQ(bits_of(center_in(batch, i)), bits_of(expected[i].center));
      }
    }
  }
  EXPECT_GT(certified, 10000U);
  EXPECT_EQ(different, 0U);
}

TEST(CircumcenterBatch, LeavesExtremeLengthsToTheSingleOne) {
  CircumcenterBatch batch;
  const double sizes[circumcenter_batch_size] = {1, 0x1p-1060, 0x1p1022, 0, 1e300, 1e-300, 4, 8};
  for (std::size_t i = 0; i < circumcenter_batch_size; ++i) {
    const double s = sizes[i];
    set_tetrahedron(batch, i, {{{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}}});
  }
  circumcenters_in_doubles(std::span(&batch, 1));
  EXPECT_EQ(batch.certified, 0b11110001U);
  for (const std::size_t i : {0U, 4U, 5U, 6U, 7U}) {
    const double s = sizes[i];
    EXPECT_EQ(center_in(batch, i), circumcenter({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}).center);
  }
}

}  // namespace
}  // namespace cocoon
