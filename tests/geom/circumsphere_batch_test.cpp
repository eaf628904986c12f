#include "geom/circumsphere_batch.h"

#include <bit>
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
