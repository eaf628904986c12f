#include "cocone/umbrella.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geom/parallel_list.h"

namespace cocoon {
namespace {

constexpr std::size_t vertices_per_chunk = 2048;

// Drops triangles without a partner at one of their spokes; true iff some survive.
class UmbrellaSearch {
 public:
  UmbrellaSearch(const LinkedFacets& triangles, double sharp_cosine)
      : triangles_(triangles), sharp_cosine_(sharp_cosine) {}

  // `fan`: all triangles at the vertex, ascending.
  bool exists(VertexId center, std::span<const std::uint32_t> fan) {
    if (fan.size() < 3) return false;
    partners_.assign(fan.size(), {});
    dropped_.clear();
    for (std::size_t k = 0; k < fan.size(); ++k) {
      for_each_spoke(center, fan[k], [&](SideId side) {
        std::uint32_t& count = partners_[k].left[corner_of_side(side)];
        for_each_partner(side, [&](SideId) { ++count; });
        if (count == 0) drop(k, fan[k]);
      });
    }
    for (std::size_t next = 0; next < dropped_.size(); ++next) {
      for_each_spoke(center, dropped_[next], [&](SideId side) {
        for_each_partner(side, [&](SideId other) {
          const std::uint32_t t = triangle_of_side(other);
          const auto place = std::lower_bound(fan.begin(), fan.end(), t);
          const auto k = static_cast<std::size_t>(place - fan.begin());
          if (--partners_[k].left[corner_of_side(other)] == 0) drop(k, t);
        });
      });
    }
    return dropped_.size() < fan.size();
  }

 private:
  template <class Visit>
  void for_each_spoke(VertexId center, std::uint32_t triangle, Visit visit) const {
    const Triangle& corners = triangles_.corners[triangle];
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (corners[i] != center) visit(3 * triangle + i);
    }
  }

  // Who has this one as a partner, too.
  template <class Visit>
  void for_each_partner(SideId side, Visit visit) const {
    for (SideId other = triangles_.links[side]; other != side; other = triangles_.links[other]) {
      if (dihedral_cosine(triangles_, side, other) <= sharp_cosine_) visit(other);
    }
  }

  // Once.
  void drop(std::size_t k, std::uint32_t triangle) {
    if (std::exchange(partners_[k].is_dropped, true)) return;
    dropped_.push_back(triangle);
  }

  const LinkedFacets& triangles_;
  double sharp_cosine_;
  struct Partners {
    std::array<std::uint32_t, 3> left;  // at the side opposite to each corner, if that is a spoke
    bool is_dropped;
  };
  std::vector<Partners> partners_;  // of each triangle of the fan
  std::vector<std::uint32_t> dropped_;
};

// The triangles at flagged vertices, ascending at each.
struct Fans {
  std::vector<std::uint32_t> begins;  // of each vertex, and the end of the last
  std::vector<std::uint32_t> triangles;

  std::span<const std::uint32_t> at(VertexId v) const {
    return std::span(triangles).subspan(begins[v.index()],
                                        begins[v.index() + 1] - begins[v.index()]);
  }
};

Fans fans_at(const LinkedFacets& triangles, const VertexSet& flags) {
  Fans fans{std::vector<std::uint32_t>(flags.size() + 2, 0), {}};
  const auto is_flagged = [&](std::uint32_t t) {  // nearly none is
    const auto& [a, b, c] = triangles.corners[t];
    return (flags[a] | flags[b] | flags[c]) != 0;
  };
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!is_flagged(t)) continue;
    for (const VertexId v : triangles.corners[t]) fans.begins[v.index() + 2] += flags[v];
  }
  for (std::size_t v = 2; v < fans.begins.size(); ++v) fans.begins[v] += fans.begins[v - 1];
  fans.triangles.resize(fans.begins.back());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!is_flagged(t)) continue;
    for (const VertexId v : triangles.corners[t]) {
      if (flags[v] != 0) fans.triangles[fans.begins[v.index() + 1]++] = t;
    }
  }
  return fans;
}

// The number of triangles at a vertex, and a corner there: the side opposite in one of them.
struct Corners {
  std::uint32_t count = 0;
  SideId one = 0;
};

IdVector<VertexId, Corners> corners_at(const LinkedFacets& triangles, std::size_t num_vertices) {
  IdVector<VertexId, Corners> corners(num_vertices);
  SideId side = 0;
  for (const Triangle& triangle : triangles.corners) {
    for (const VertexId v : triangle) corners[v] = {corners[v].count + 1, side++};
  }
  return corners;
}

// Do the triangles around v, two at each spoke, make one single cycle? Each cycle has three at
// least: so yes, unless the walk is back while three are left.
bool is_one_cycle(const LinkedFacets& triangles, VertexId v, const Corners& corners) {
  SideId corner = corners.one;
  std::size_t arrived = next_corner(corner_of_side(corner));
  for (std::uint32_t walked = 1; walked + 3 <= corners.count; ++walked) {
    // Over the other of the two spokes into the next triangle.
    const std::uint32_t t = triangle_of_side(corner);
    const std::size_t leaving = 3 - corner_of_side(corner) - arrived;
    const SideId crossed = triangles.links[3 * t + static_cast<SideId>(leaving)];
    const Triangle& triangle = triangles.corners[triangle_of_side(crossed)];
    arrived = corner_of_side(crossed);
    const std::size_t at =
        triangle[next_corner(arrived)] == v ? next_corner(arrived) : previous_corner(arrived);
    corner = 3 * triangle_of_side(crossed) + static_cast<SideId>(at);
    if (corner == corners.one) return false;
  }
  return true;
}

// The worst spoke of a vertex.
enum class Spoke : std::uint8_t { flat, folded, open };  // open: not two triangles
using Spokes = IdVector<VertexId, Spoke>;

Spokes spokes_at(const LinkedFacets& triangles, const VertexSet& boundary,
                 const GoodVertexOptions& options, const Execution& execution) {
  // Folds are told by >=, creases and steep edges by >.
  const double flat = std::min(std::nextafter(options.fold_cosine, -2), options.crease_cosine);
  Spokes spokes(boundary.size(), Spoke::flat);
  for (const SideId side : steep_edges(triangles, flat, execution)) {
    const bool is_open = !triangles.is_two_sided(side);
    const double cosine = is_open ? 0 : dihedral_cosine(triangles, side, triangles.links[side]);
    for (const VertexId v : triangles.ends(side)) {
      const bool is_folded =
          cosine >= options.fold_cosine || (boundary[v] != 0 && cosine > options.crease_cosine);
      const Spoke here = is_open ? Spoke::open : is_folded ? Spoke::folded : Spoke::flat;
      spokes[v] = std::max(spokes[v], here);
    }
  }
  return spokes;
}

}  // namespace

VertexSet vertices_with_umbrella(const LinkedFacets& triangles, std::size_t num_vertices,
                                 double sharp_cosine, const Execution& execution) {
  const std::vector<SideId> steep = steep_edges(triangles, sharp_cosine, execution);
  return vertices_with_umbrella(triangles, steep, num_vertices, sharp_cosine, execution);
}

VertexSet vertices_with_umbrella(const LinkedFacets& triangles, std::span<const SideId> steep,
                                 std::size_t num_vertices, double sharp_cosine,
                                 const Execution& execution) {
  VertexSet doubtful(num_vertices, 0);
  for (const SideId side : steep) {
    for (const VertexId v : triangles.ends(side)) doubtful[v] = 1;
  }
  VertexSet flags(num_vertices, 0);
  for (const Triangle& corners : triangles.corners) {
    for (const VertexId v : corners) flags[v] = 1;
  }
  const Fans fans = fans_at(triangles, doubtful);
  parallel_chunks(execution, num_vertices, vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    UmbrellaSearch search(triangles, sharp_cosine);
                    for (VertexId v(begin); v.index() < end; ++v) {
                      if (doubtful[v] != 0) flags[v] = search.exists(v, fans.at(v)) ? 1 : 0;
                    }
                  });
  return flags;
}

GoodVertices good_vertices(const LinkedFacets& triangles, const VertexSet& boundary,
                           const GoodVertexOptions& options, const Execution& execution) {
  const std::size_t count = boundary.size();
  const Spokes spokes = spokes_at(triangles, boundary, options, execution);
  const IdVector<VertexId, Corners> corners = corners_at(triangles, count);
  GoodVertices result{VertexSet(count, 0), IdVector<VertexId, SideId>(count), 0, {}};
  std::atomic<std::size_t> good = 0;
  const auto judge = [&](std::size_t begin, std::size_t end, std::vector<VertexId>& folded_here) {
    std::size_t good_here = 0;
    for (VertexId v(begin); v.index() < end; ++v) {
      result.corner_at[v] = corners[v].one;
      if (corners[v].count < 3 || spokes[v] == Spoke::open) continue;
      if (!is_one_cycle(triangles, v, corners[v])) continue;
      result.good[v] = spokes[v] == Spoke::flat;
      good_here += result.good[v];
      if (spokes[v] == Spoke::folded) folded_here.push_back(v);
    }
    good += good_here;
  };
  result.folded = parallel_list<VertexId>(execution, count, vertices_per_chunk, judge);
  result.count = good;
  return result;
}

}  // namespace cocoon
