#include "geom/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

#include "geom/arrays/large_pages.h"
#include "geom/box.h"
#include "geom/id_vector.h"
#include "geom/parallel/parallel_reduce.h"
#include "geom/random/random.h"

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

// Rank among the cells of the curve's first `levels` levels.
std::uint64_t curve_rank(std::uint32_t x, std::uint32_t y, std::uint32_t z, int levels) {
  std::uint64_t rank = 0;
  unsigned state = 0;
  for (int shift = bits_per_axis - levels_per_step; shift >= bits_per_axis - levels;
       shift -= levels_per_step) {
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
using KeyedPoints = std::vector<KeyedPoint, OverwriteAllocator<KeyedPoint>>;

// What the sort looks at in one pass.
constexpr int digit_bits = 8;
constexpr std::size_t num_digits = std::size_t{1} << digit_bits;
constexpr int top_digit_shift = 3 * bits_per_axis - digit_bits;
constexpr std::size_t digit(const KeyedPoint& item, int shift) {
  return (item.key >> shift) & (num_digits - 1);
}

struct Cube {
  Point low;
  double half_side = 0;  // halved, so that the extent of huge coordinates does not overflow
};

Cube cube_of(const Box& box) {
  const Vec3 half = 0.5 * box.high - 0.5 * box.low;
  return {box.low, std::max({half.x, half.y, half.z})};
}

Cube bounding_cube(Points points, std::span<const KeyedPoint> items, const Execution& execution) {
  const auto box_of_chunk = [&](std::size_t begin, std::size_t end) {
    Box box;
    for (const KeyedPoint& item : items.subspan(begin, end - begin)) {
      box.include(points[item.id.index()]);
    }
    return box;
  };
  const auto joined = [](Box a, const Box& b) {
    a.include(b);
    return a;
  };
  return cube_of(parallel_reduce(execution, items.size(), Box{}, box_of_chunk, joined));
}

std::uint32_t curve_coordinate(double value, double low, double half_side) {
  constexpr double cells = 1 << bits_per_axis;
  const double fraction = (0.5 * value - 0.5 * low) / half_side;
  return static_cast<std::uint32_t>(std::clamp(fraction * cells, 0.0, cells - 1));
}

std::uint64_t curve_rank(const Point& p, const Cube& cube, int levels = bits_per_axis) {
  return curve_rank(curve_coordinate(p.x, cube.low.x, cube.half_side),
                    curve_coordinate(p.y, cube.low.y, cube.half_side),
                    curve_coordinate(p.z, cube.low.z, cube.half_side), levels);
}

void sort_items_lexicographically(Points points, std::span<KeyedPoint> items) {
  std::sort(items.begin(), items.end(), [&](const KeyedPoint& a, const KeyedPoint& b) {
    const Point& p = points[a.id.index()];
    const Point& q = points[b.id.index()];
    return p < q || (p == q && a.id < b.id);
  });
}

// Sorts one bucket, which lies in `from`, by the lower key bits, into `to`, which has its size.
// Least significant digit first: at an odd number of passes it ends there.
void sort_bucket(std::span<KeyedPoint> from, std::span<KeyedPoint> to) {
  constexpr std::size_t too_few_to_count = 64;
  if (from.size() < too_few_to_count) {
    std::copy(from.begin(), from.end(), to.begin());
    std::sort(to.begin(), to.end(),
              [](const KeyedPoint& a, const KeyedPoint& b) { return a.key < b.key; });
    return;
  }
  constexpr int passes = 5;
  static_assert(passes % 2 == 1 && passes * digit_bits >= top_digit_shift);
  std::array<std::array<std::uint32_t, num_digits>, passes> next{};
  for (const KeyedPoint& item : from) {
    for (int pass = 0; pass < passes; ++pass)
      ++next[static_cast<std::size_t>(pass)][digit(item, pass * digit_bits)];
  }
  for (int pass = 0; pass < passes; ++pass) {
    std::array<std::uint32_t, num_digits>& places = next[static_cast<std::size_t>(pass)];
    std::uint32_t offset = 0;
    for (std::uint32_t& count : places) offset += std::exchange(count, offset);
    for (const KeyedPoint& item : from) to[places[digit(item, pass * digit_bits)]++] = item;
    std::swap(from, to);
  }
}

// Sorts by key; `buffer` has the size of `items`. The first pass distributes by the top digit: each
// chunk counts its digits, then moves its items to places of its own. The buckets, which fit the
// caches, are sorted one by one.
void radix_sort(std::span<KeyedPoint> items, std::span<KeyedPoint> buffer,
                const Execution& execution) {
  const std::size_t grain = coarse_grain(items.size());
  const std::size_t chunks = (items.size() + grain - 1) / grain;
  std::vector<std::uint32_t> counts(chunks * num_digits);  // by chunk, then by digit
  parallel_chunks(execution, items.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t* const own = counts.data() + begin / grain * num_digits;
    for (std::size_t i = begin; i < end; ++i) ++own[digit(items[i], top_digit_shift)];
  });
  std::array<std::uint32_t, num_digits + 1> bucket_ends{};  // of the bucket before
  std::uint32_t offset = 0;
  for (std::size_t bucket = 0; bucket < num_digits; ++bucket) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
      std::uint32_t& count = counts[chunk * num_digits + bucket];
      offset += std::exchange(count, offset);
    }
    bucket_ends[bucket + 1] = offset;
  }
  parallel_chunks(execution, items.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t* const own = counts.data() + begin / grain * num_digits;
    for (std::size_t i = begin; i < end; ++i) {
      buffer[own[digit(items[i], top_digit_shift)]++] = items[i];
    }
  });
  parallel_chunks(execution, num_digits, 1, [&](std::size_t bucket, std::size_t) {
    const std::size_t begin = bucket_ends[bucket];
    const std::size_t count = bucket_ends[bucket + 1] - begin;
    sort_bucket(buffer.subspan(begin, count), items.subspan(begin, count));
  });
}

// Where points share a curve cell.
struct Group {
  std::size_t begin, end;
};

std::vector<Group> groups_of_equal_keys(std::span<const KeyedPoint> items,
                                        const Execution& execution) {
  const std::size_t grain = coarse_grain(items.size());
  std::vector<std::vector<Group>> found((items.size() + grain - 1) / grain);
  parallel_chunks(execution, items.size(), grain, [&](std::size_t first, std::size_t last) {
    // The groups that begin in this chunk.
    for (std::size_t begin = first; begin < last;) {
      std::size_t end = begin + 1;
      while (end < items.size() && items[end].key == items[begin].key) ++end;
      const bool began_before = begin > 0 && items[begin - 1].key == items[begin].key;
      if (end - begin > 1 && !began_before) found[first / grain].push_back({begin, end});
      begin = end;
    }
  });
  std::vector<Group> groups;
  for (const auto& part : found) groups.insert(groups.end(), part.begin(), part.end());
  return groups;
}

void sort_along_curve(Points points, std::span<KeyedPoint> items, std::span<KeyedPoint> buffer,
                      const Execution& execution) {
  const Cube cube = bounding_cube(points, items, execution);
  if (!(cube.half_side > 0)) {  // all points equal (or apart by the last subnormal bit)
    sort_items_lexicographically(points, items);
    return;
  }
  parallel_chunks(execution, items.size(), coarse_grain(items.size()),
                  [&](std::size_t begin, std::size_t end) {
                    for (KeyedPoint& item : items.subspan(begin, end - begin)) {
                      item.key = curve_rank(points[item.id.index()], cube);
                    }
                  });
  radix_sort(items, buffer, execution);
  // Points that share a curve cell: a finer curve of their own, or the lexicographic order.
  const std::vector<Group> groups = groups_of_equal_keys(items, execution);
  constexpr std::size_t groups_at_a_time = 256;
  parallel_chunks(
      execution, groups.size(), groups_at_a_time, [&](std::size_t first, std::size_t last) {
        for (std::size_t g = first; g < last; ++g) {
          const std::size_t begin = groups[g].begin;
          const std::size_t count = groups[g].end - begin;
          if (count > min_subcurve && count < items.size()) {
            sort_along_curve(points, items.subspan(begin, count), buffer.subspan(begin, count), {});
          } else {
            sort_items_lexicographically(points, items.subspan(begin, count));
          }
        }
      });
}

}  // namespace

std::vector<PointId> hilbert_order(Points points, const Execution& execution) {
  const std::size_t grain = coarse_grain(points.size());
  KeyedPoints items(points.size());
  prefer_large_pages(items);
  parallel_chunks(execution, items.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) items[i] = {0, PointId(i)};
  });
  if (!items.empty()) {
    KeyedPoints buffer(items.size());
    prefer_large_pages(buffer);
    sort_along_curve(points, items, buffer, execution);
  }
  std::vector<PointId> order(items.size());
  parallel_chunks(execution, items.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) order[i] = items[i].id;
  });
  return order;
}

std::vector<PointId> rough_order(Points points, const Execution& execution) {
  constexpr int levels = 2 * levels_per_step;
  constexpr std::uint32_t beyond = std::uint32_t{1} << (3 * levels);  // of what is not finite
  Box box;
  for (const Point& p : points) {
    if (is_finite(p)) box.include(p);
  }
  const Cube cube = cube_of(box);
  const auto cell_of = [&](const Point& p) {
    if (!is_finite(p)) return beyond;
    if (!(cube.half_side > 0)) return std::uint32_t{0};
    return static_cast<std::uint32_t>(curve_rank(p, cube, levels));
  };
  std::vector<std::uint32_t> cells(points.size());
  parallel_chunks(execution, points.size(), coarse_grain(points.size()),
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) cells[i] = cell_of(points[i]);
                  });
  std::vector<std::uint32_t> places(beyond + 2, 0);
  for (const std::uint32_t cell : cells) ++places[cell + 1];
  std::partial_sum(places.begin(), places.end(), places.begin());
  std::vector<PointId> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) order[places[cells[i]]++] = PointId(i);
  return order;
}

InsertionRounds insertion_rounds(std::size_t count, std::uint64_t seed,
                                 const Execution& execution) {
  // An element stays for the last round with probability 7/8, otherwise for the one before with
  // probability 7/8, and so on: three hash bits a round.
  constexpr int bits_per_round = 3;
  constexpr std::size_t smallest_round = 512;
  std::size_t rounds = 1;
  for (std::size_t size = count; size > smallest_round; size >>= bits_per_round) ++rounds;
  const auto round_of = [&](std::size_t element) {
    std::size_t round = rounds - 1;
    std::uint64_t state = seed * 0x2545F4914F6CDD1DU + element;
    for (std::uint64_t bits = splitmix64(state); round > 0 && (bits & 7U) == 0;
         bits >>= bits_per_round) {
      --round;
    }
    return round;
  };

  // How many elements of each chunk belong to each round, then where they go.
  const std::size_t grain = coarse_grain(count);
  const std::size_t chunks = (count + grain - 1) / grain;
  std::vector<std::size_t> offsets(chunks * rounds, 0);  // by chunk, then by round
  parallel_chunks(execution, count, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> sizes(rounds, 0);
    for (std::size_t i = begin; i < end; ++i) ++sizes[round_of(i)];
    std::copy(sizes.begin(), sizes.end(), offsets.data() + begin / grain * rounds);
  });
  InsertionRounds result{std::vector<std::uint32_t>(count), {}};
  std::size_t placed = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
      placed += std::exchange(offsets[chunk * rounds + round], placed);
    }
    result.ends.push_back(placed);
  }
  // Every second round, counted from the last but one, runs backwards.
  parallel_chunks(execution, count, grain, [&](std::size_t begin, std::size_t end) {
    const std::size_t* const own = offsets.data() + begin / grain * rounds;
    std::vector<std::size_t> next(own, own + rounds);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t round = round_of(i);
      const std::size_t at = next[round]++;
      const std::size_t round_begin = round == 0 ? 0 : result.ends[round - 1];
      const bool backwards = (rounds - 1 - round) % 2 == 1;
      result.order[backwards ? round_begin + result.ends[round] - 1 - at : at] =
          static_cast<std::uint32_t>(i);
    }
  });
  return result;
}

}  // namespace cocoon
