#include "cocone/umbrella.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cocone/inputs/stage_inputs.h"
#include "geom/arrays/sort_by_vertex.h"
#include "geom/messages/require_size.h"
#include "geom/parallel/parallel_list.h"

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
      for_each_spoke(center, fan[k], [&](Halfedge halfedge) {
        std::uint32_t& count = partners_[k].left[corner_of_halfedge(halfedge)];
        for_each_partner(halfedge, [&](Halfedge) { ++count; });
        if (count == 0) drop(k, fan[k]);
      });
    }
    for (std::size_t next = 0; next < dropped_.size(); ++next) {
      for_each_spoke(center, dropped_[next], [&](Halfedge halfedge) {
        for_each_partner(halfedge, [&](Halfedge other) {
          const std::uint32_t t = triangle_of_halfedge(other);
          const auto place = std::lower_bound(fan.begin(), fan.end(), t);
          const auto k = static_cast<std::size_t>(place - fan.begin());
          if (--partners_[k].left[corner_of_halfedge(other)] == 0) drop(k, t);
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

  // The triangles that this one has as partners; it is one of theirs, too.
  template <class Visit>
  void for_each_partner(Halfedge halfedge, Visit visit) const {
    for (Halfedge other = triangles_.links[halfedge]; other != halfedge;
         other = triangles_.links[other]) {
      if (dihedral_cosine(triangles_, halfedge, other) <= sharp_cosine_) visit(other);
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
    std::array<std::uint32_t, 3> left;  // at the edge opposite to each corner, if that is a spoke
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

// Those that have a flagged vertex; few have one.
std::vector<std::uint32_t> triangles_at(const LinkedFacets& triangles, const VertexSet& flags) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles.corners[t];
    if ((flags[a] | flags[b] | flags[c]) != 0) found.push_back(t);
  }
  return found;
}

Fans fans_at(const LinkedFacets& triangles, const VertexSet& flags) {
  const std::vector<std::uint32_t> found = triangles_at(triangles, flags);
  Fans fans;
  fans.begins = sort_by_vertex(
      found.size(), flags.size(), {}, [&](std::size_t count) { fans.triangles.resize(count); },
      [&](std::size_t begin, std::size_t end, const auto& put) {
        for (std::size_t k = begin; k < end; ++k) {
          const auto write = [&](std::uint32_t place) { fans.triangles[place] = found[k]; };
          for (const VertexId v : triangles.corners[found[k]]) {
            if (flags[v] != 0) put(v, write);
          }
        }
      });
  return fans;
}

// The number of triangles at a vertex, and a corner there: the halfedge opposite in one of them.
struct Corners {
  std::uint32_t count = 0;
  Halfedge one = 0;
};

IdVector<VertexId, Corners> corners_at(const LinkedFacets& triangles, std::size_t num_vertices) {
  IdVector<VertexId, Corners> corners(num_vertices);
  Halfedge halfedge = 0;
  for (const Triangle& triangle : triangles.corners) {
    for (const VertexId v : triangle) {
      require_index("good_vertices", "vertex", v.index(), num_vertices);
      corners[v] = {corners[v].count + 1, halfedge++};
    }
  }
  return corners;
}

// On its way around a vertex, from a triangle to the next over a spoke with two of them.
struct Turn {
  VertexId center;
  Halfedge corner;        // of the triangle it is at, there
  std::uint32_t arrived;  // over the spoke opposite to this corner of it
  std::uint32_t left;     // to be passed before it is certain that there is one cycle alone

  void advance(const LinkedFacets& triangles) {
    const std::uint32_t leaving = 3 - corner_of_halfedge(corner) - arrived;
    const Halfedge crossed = triangles.links[3 * triangle_of_halfedge(corner) + leaving];
    const std::uint32_t t = triangle_of_halfedge(crossed);
    arrived = corner_of_halfedge(crossed);
    corner = 3 * t + static_cast<Halfedge>(corner_at_vertex(triangles.corners[t], center));
    --left;
  }
};

// Which of the vertices begin .. end - 1, two triangles at each spoke (is_regular(v)), have more
// than one cycle of them: calls split(v). Each cycle has three triangles at least: there is one
// alone, unless a walk is back while three are left. When walks end cannot be foreseen: those of a
// block of vertices go on together, and who has arrived is left out without a branch.
template <class IsRegular, class Split>
void for_each_split(const LinkedFacets& triangles, const IdVector<VertexId, Corners>& corners,
                    VertexId begin, VertexId end, IsRegular is_regular, Split split) {
  constexpr std::size_t vertices_per_block = 128;
  constexpr std::uint32_t smallest_cycle = 3;
  std::array<Turn, vertices_per_block> turns;
  for (VertexId first = begin; first < end;) {
    const VertexId last = std::min(end, VertexId(first.index() + vertices_per_block));
    std::size_t active = 0;
    for (VertexId v = first; v < last; ++v) {
      const auto& [count, one] = corners[v];
      const bool walks = count >= 2 * smallest_cycle && is_regular(v);
      const auto arrived = static_cast<std::uint32_t>(next_corner(corner_of_halfedge(one)));
      turns[active] = {v, one, arrived, count - smallest_cycle};
      active += walks ? 1U : 0U;
    }
    first = last;
    while (active != 0) {
      std::size_t left = 0;
      for (std::size_t k = 0; k < active; ++k) {
        Turn turn = turns[k];
        turn.advance(triangles);
        const bool is_back = turn.corner == corners[turn.center].one;
        if (is_back) split(turn.center);
        turns[left] = turn;
        left += turn.left != 0 && !is_back ? 1U : 0U;
      }
      active = left;
    }
  }
}

// The worst spoke of a vertex.
enum class Spoke : std::uint8_t { flat, folded, open };  // open: not two triangles
using Spokes = IdVector<VertexId, Spoke>;

Spokes spokes_at(const LinkedFacets& triangles, const VertexSet& boundary,
                 const GoodVertexOptions& options, const Execution& execution) {
  // Folds are told by >=, creases and steep edges by >.
  const double flat = std::min(std::nextafter(options.fold_cosine, -2), options.crease_cosine);
  Spokes spokes(boundary.size(), Spoke::flat);
  for (const Halfedge halfedge : steep_edges(triangles, flat, execution)) {
    const bool is_open = !triangles.has_two_triangles(halfedge);
    const double cosine =
        is_open ? 0 : dihedral_cosine(triangles, halfedge, triangles.links[halfedge]);
    for (const VertexId v : triangles.ends(halfedge)) {
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
  const std::vector<Halfedge> steep = steep_edges(triangles, sharp_cosine, execution);
  return vertices_with_umbrella(triangles, steep, num_vertices, sharp_cosine, execution);
}

VertexSet vertices_with_umbrella(const LinkedFacets& triangles, std::span<const Halfedge> steep,
                                 std::size_t num_vertices, double sharp_cosine,
                                 const Execution& execution) {
  VertexSet flags(num_vertices, 0);
  for (const Triangle& corners : triangles.corners) {
    for (const VertexId v : corners) {
      require_index("vertices_with_umbrella", "vertex", v.index(), num_vertices);
      flags[v] = 1;
    }
  }
  VertexSet doubtful(num_vertices, 0);
  for (const Halfedge halfedge : steep) {
    for (const VertexId v : triangles.ends(halfedge)) doubtful[v] = 1;
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
  require_options("good_vertices", options);
  const std::size_t count = boundary.size();
  const IdVector<VertexId, Corners> corners = corners_at(triangles, count);
  const Spokes spokes = spokes_at(triangles, boundary, options, execution);
  GoodVertices result{VertexSet(count, 0), IdVector<VertexId, Halfedge>(count), 0, {}};
  std::atomic<std::size_t> good = 0;
  const auto judge = [&](std::size_t begin, std::size_t end, std::vector<VertexId>& folded_here) {
    const auto is_regular = [&](VertexId v) { return spokes[v] != Spoke::open; };
    for (VertexId v(begin); v.index() < end; ++v) {
      result.corner_at[v] = corners[v].one;
      result.good[v] = corners[v].count >= 3 && is_regular(v) ? 1 : 0;
    }
    for_each_split(triangles, corners, VertexId(begin), VertexId(end), is_regular,
                   [&](VertexId v) { result.good[v] = 0; });
    std::size_t good_here = 0;
    for (VertexId v(begin); v.index() < end; ++v) {
      if (result.good[v] != 0 && spokes[v] == Spoke::folded) {
        result.good[v] = 0;
        folded_here.push_back(v);
      }
      good_here += result.good[v];
    }
    good += good_here;
  };
  result.folded = parallel_list<VertexId>(execution, count, vertices_per_chunk, judge);
  result.count = good;
  return result;
}

}  // namespace cocoon
