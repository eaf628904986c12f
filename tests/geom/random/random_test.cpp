#include "geom/random/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

#include "geom/random/random_point.h"

namespace cocoon {
namespace {

// The words of the sources, by another program: sample models and insertion orders rest on them.
TEST(Random, FirstWords) {
  std::uint64_t state = 0;
  EXPECT_EQ(splitmix64(state), 0xE220A8397B1DCDAFU);
  EXPECT_EQ(splitmix64(state), 0x6E789E6AA1B965F4U);
  EXPECT_EQ(splitmix64(state), 0x06C45D188009454FU);
  Random random(1);
  for (const std::uint64_t word :
       {0xB3F2AF6D0FC710C5U, 0x853B559647364CEAU, 0x92F89756082A4514U, 0x642E1C7BC266A3A7U}) {
    EXPECT_EQ(random.bits(), word);
  }
  Random same(1);
  EXPECT_EQ(same.uniform(), static_cast<double>(0xB3F2AF6D0FC710C5U >> 11) / 0x1p53);
}

TEST(Random, NumbersAreInTheirRanges) {
  Random random(2);
  std::array<int, 5> counts{};
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < 20000; ++i) {
    const double u = random.uniform(-3, 2);
    EXPECT_TRUE(u >= -3 && u < 2) << u;
    ++counts.at(random.below(counts.size()));
    const double g = random.gaussian();
    sum += g;
    squares += g * g;
  }
  for (const int count : counts) EXPECT_NEAR(count, 4000, 300);
  EXPECT_NEAR(sum / 20000, 0, 0.03);
  EXPECT_NEAR(squares / 20000, 1, 0.05);
}

TEST(Random, PointsAreWhereTheySay) {
  Random random(3);
  Vec3 mean;
  for (int i = 0; i < 20000; ++i) {
    const Point p = random.on_unit_sphere();
    EXPECT_NEAR(norm(p), 1, 1e-15);
    mean = mean + p / 20000;
    const Point q = random_point_in({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, random);
    EXPECT_NEAR(q.x + q.y + q.z, 1, 1e-15);
    EXPECT_GE(std::min({q.x, q.y, q.z}), -1e-15);
    const Point r = random.in_unit_cube();
    EXPECT_TRUE(std::min({r.x, r.y, r.z}) >= 0 && max_norm(r) < 1);
  }
  EXPECT_LT(norm(mean), 0.03);
}

TEST(Random, ShuffledAreTheSameElements) {
  Random random(4);
  std::vector<int> shuffled(100);
  std::iota(shuffled.begin(), shuffled.end(), 0);
  const std::vector<int> all = shuffled;
  random.shuffle(shuffled);
  EXPECT_NE(shuffled, all);
  std::sort(shuffled.begin(), shuffled.end());
  EXPECT_EQ(shuffled, all);
}

}  // namespace
}  // namespace cocoon
