#include "geom/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace cocoon {
namespace {

constexpr int bits_per_axis = 15;  // finer levels only where points share a curve cell
constexpr int levels_per_step = 3;
constexpr std::size_t min_subcurve = 256;  // smaller groups are sorted lexicographically at once

// --- The curve ------------------------------------------------------------------------------
// A state of the 3D Hilbert curve is (entry corner e of the current cube, direction d in which the
// curve leaves it); 8 * 3 = 24 states. One step maps an octant to its rank on the curve and to the
// state inside that octant (Hamilton & Rau-Chaplin, section 2).

struct CurveStep {
  std::uint8_t rank;
  std::uint8_t state;
};

constexpr unsigned rotate_right(unsigned bits, unsigned by) {
  by %= 3;
  return ((bits >> by) | (bits << (3 - by))) & 7U;
}
constexpr unsigned rotate_left(unsigned bits, unsigned by) {
  by %= 3;
  return ((bits << by) | (bits >> (3 - by))) & 7U;
}
constexpr unsigned gray_code(unsigned i) { return i ^ (i >> 1); }
constexpr unsigned gray_rank(unsigned g) { return g ^ (g >> 1) ^ (g >> 2); }
constexpr unsigned entry_corner(unsigned rank) {
  return rank == 0 ? 0 : gray_code(2 * ((rank - 1) / 2));
}
constexpr unsigned inner_direction(unsigned rank) {
  if (rank == 0) return 0;
  const unsigned odd = rank % 2 == 0 ? rank - 1 : rank;
  return static_cast<unsigned>(std::countr_one(odd)) % 3;
}

constexpr CurveStep curve_step(unsigned state, unsigned octant) {
  const unsigned e = state / 3;
  const unsigned d = state % 3;
  const unsigned rank = gray_rank(rotate_right(octant ^ e, d + 1));
  const unsigned next_e = e ^ rotate_left(entry_corner(rank), d + 1);
  const unsigned next_d = (d + inner_direction(rank) + 1) % 3;
  return {static_cast<std::uint8_t>(rank), static_cast<std::uint8_t>(next_e * 3 + next_d)};
}

// Three levels of the curve in one look-up: entry = 9 bits of rank above 5 bits of state.
using StepTable = std::array<std::array<std::uint16_t, 512>, 24>;

// Made from a table of single steps: compilers bound the work of a constant expression.
constexpr StepTable make_step_table() {
  CurveStep steps[24][8] = {};
  for (unsigned state = 0; state < 24; ++state) {
    for (unsigned octant = 0; octant < 8; ++octant) {
      steps[state][octant] = curve_step(state, octant);
    }
  }
  StepTable table{};
  for (unsigned state = 0; state < 24; ++state) {
    for (unsigned octants = 0; octants < 512; ++octants) {
      const CurveStep first = steps[state][octants >> 6];
      const CurveStep second = steps[first.state][(octants >> 3) & 7U];
      const CurveStep third = steps[second.state][octants & 7U];
      const unsigned rank = (static_cast<unsigned>(first.rank) << 6) |
                            (static_cast<unsigned>(second.rank) << 3) | third.rank;
      table[state][octants] = static_cast<std::uint16_t>((rank << 5) | third.state);
    }
  }
  return table;
}

constexpr StepTable step_table = make_step_table();

// Spreads three bits to positions 0, 3, 6.
constexpr std::array<std::uint16_t, 8> spread_bits = {0, 1, 8, 9, 64, 65, 72, 73};

std::uint64_t curve_rank(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  std::uint64_t rank = 0;
  unsigned state = 0;
  for (int shift = bits_per_axis - levels_per_step; shift >= 0; shift -= levels_per_step) {
    const unsigned octants = static_cast<unsigned>(spread_bits[(x >> shift) & 7U]) |
                             static_cast<unsigned>(spread_bits[(y >> shift) & 7U] << 1) |
                             static_cast<unsigned>(spread_bits[(z >> shift) & 7U] << 2);
    const unsigned entry = step_table[state][octants];
    rank = (rank << 9) | (entry >> 5);
    state = entry & 31U;
  }
  return rank;
}

// --- Sorting --------------------------------------------------------------------------------

struct KeyedPoint {
  std::uint64_t key;
  PointId id;
};

struct Cube {
  Point low;
  double half_side = 0;  // halved, so that the extent of huge coordinates does not overflow
};

Cube bounding_cube(Points points, std::span<const KeyedPoint> items) {
  Point low = points[items.front().id.index()];
  Point high = low;
  for (const KeyedPoint& item : items) {
    const Point& p = points[item.id.index()];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double half_side = std::max(
      {0.5 * high.x - 0.5 * low.x, 0.5 * high.y - 0.5 * low.y, 0.5 * high.z - 0.5 * low.z});
  return {low, half_side};
}

std::uint32_t curve_coordinate(double value, double low, double half_side) {
  constexpr double cells = 1 << bits_per_axis;
  const double fraction = (0.5 * value - 0.5 * low) / half_side;
  return static_cast<std::uint32_t>(std::clamp(fraction * cells, 0.0, cells - 1));
}

void sort_lexicographically(Points points, std::span<KeyedPoint> items) {
  std::sort(items.begin(), items.end(), [&](const KeyedPoint& a, const KeyedPoint& b) {
    const Point& p = points[a.id.index()];
    const Point& q = points[b.id.index()];
    return p < q || (p == q && a.id < b.id);
  });
}

// Stable radix sort by key; `buffer` has the size of `items`. The number of passes is even, so
// the result ends in `items`.
void radix_sort(std::span<KeyedPoint> items, std::span<KeyedPoint> buffer) {
  constexpr int digit_bits = 12;
  constexpr std::size_t buckets = std::size_t{1} << digit_bits;
  constexpr int passes = 4;
  static_assert(passes * digit_bits >= 3 * bits_per_axis && passes % 2 == 0);
  std::vector<std::uint32_t> counts(buckets);
  for (int pass = 0; pass < passes; ++pass) {
    const int shift = pass * digit_bits;
    const auto digit = [&](const KeyedPoint& item) { return (item.key >> shift) & (buckets - 1); };
    std::fill(counts.begin(), counts.end(), 0U);
    for (const KeyedPoint& item : items) ++counts[digit(item)];
    std::uint32_t offset = 0;
    for (std::uint32_t& count : counts) {
      const std::uint32_t bucket_size = count;
      count = offset;
      offset += bucket_size;
    }
    for (const KeyedPoint& item : items) buffer[counts[digit(item)]++] = item;
    std::swap(items, buffer);
  }
}

void sort_along_curve(Points points, std::span<KeyedPoint> items, std::span<KeyedPoint> buffer) {
  const Cube cube = bounding_cube(points, items);
  if (!(cube.half_side > 0)) {  // all points equal (or apart by the last subnormal bit)
    sort_lexicographically(points, items);
    return;
  }
  for (KeyedPoint& item : items) {
    const Point& p = points[item.id.index()];
    item.key = curve_rank(curve_coordinate(p.x, cube.low.x, cube.half_side),
                          curve_coordinate(p.y, cube.low.y, cube.half_side),
                          curve_coordinate(p.z, cube.low.z, cube.half_side));
  }
  radix_sort(items, buffer);
  // Points that share a curve cell: a finer curve of their own, or the lexicographic order.
  for (std::size_t begin = 0; begin < items.size();) {
    std::size_t end = begin + 1;
    while (end < items.size() && items[end].key == items[begin].key) ++end;
    if (end - begin > min_subcurve && end - begin < items.size()) {
      sort_along_curve(points, items.subspan(begin, end - begin),
                       buffer.subspan(begin, end - begin));
    } else if (end - begin > 1) {
      sort_lexicographically(points, items.subspan(begin, end - begin));
    }
    begin = end;
  }
}

std::uint64_t hash(std::uint64_t value) {  // the finalizer of splitmix64
  value += 0x9E3779B97F4A7C15U;
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9U;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBU;
  return value ^ (value >> 31);
}

}  // namespace

std::vector<PointId> hilbert_order(Points points, const Execution& execution) {
  std::vector<KeyedPoint> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) items[i].id = PointId(i);
  if (!items.empty()) {
    report_progress(execution, "delaunay", 0);
    std::vector<KeyedPoint> buffer(items.size());
    sort_along_curve(points, items, buffer);
  }
  std::vector<PointId> order(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].id;
  return order;
}

std::vector<std::uint32_t> insertion_rounds(std::size_t count, std::uint64_t seed) {
  // An element stays for the last round with probability 7/8, otherwise for the one before with
  // probability 7/8, and so on: three hash bits a round.
  constexpr int bits_per_round = 3;
  constexpr std::size_t smallest_round = 512;
  int rounds = 1;
  for (std::size_t size = count; size > smallest_round; size >>= bits_per_round) ++rounds;
  const auto round_of = [&](std::size_t element) {
    int round = rounds - 1;
    for (std::uint64_t bits = hash(seed * 0x2545F4914F6CDD1DU + element);
         round > 0 && (bits & 7U) == 0; bits >>= bits_per_round) {
      --round;
    }
    return round;
  };

  std::vector<std::size_t> offsets(static_cast<std::size_t>(rounds) + 1, 0);
  for (std::size_t i = 0; i < count; ++i) ++offsets[static_cast<std::size_t>(round_of(i)) + 1];
  for (std::size_t r = 1; r < offsets.size(); ++r) offsets[r] += offsets[r - 1];
  std::vector<std::uint32_t> order(count);
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t i = 0; i < count; ++i) {
    order[next[static_cast<std::size_t>(round_of(i))]++] = static_cast<std::uint32_t>(i);
  }
  for (int r = rounds - 2; r >= 0; r -= 2) {
    std::reverse(
        order.begin() + static_cast<std::ptrdiff_t>(offsets[static_cast<std::size_t>(r)]),
        order.begin() + static_cast<std::ptrdiff_t>(offsets[static_cast<std::size_t>(r) + 1]));
  }
  return order;
}

}  // namespace cocoon
