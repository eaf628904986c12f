#include "cocone/umbrella.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <utility>
#include <vector>

#include "cocone/shared_flags.h"

namespace cocoon {
namespace {

constexpr std::size_t triangles_per_chunk = 8192;
constexpr std::size_t vertices_per_chunk = 8192;

// Drops triangles without a partner at one of their spokes; true iff some survive.
class UmbrellaSearch {
 public:
  UmbrellaSearch(const LinkedFacets& triangles, double sharp_cosine)
      : triangles_(triangles), sharp_cosine_(sharp_cosine) {}

  // `fan`: all triangles at the vertex, ascending.
  bool exists(VertexId center, std::span<const std::uint32_t> fan) {
    if (fan.size() < 3) return false;
    alive_.assign(fan.begin(), fan.end());
    while (drop_round(center)) {
    }
    return !alive_.empty();
  }

 private:
  // What survives a round is judged by the survivors of the one before.
  bool drop_round(VertexId center) {
    survivors_.clear();
    for (const std::uint32_t t : alive_) {
      const Triangle& corners = triangles_.corners[t];
      bool held = true;
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (corners[i] != center) held = held && has_partner(3 * t + i);
      }
      if (held) survivors_.push_back(t);
    }
    std::swap(alive_, survivors_);
    return alive_.size() < survivors_.size();
  }

  bool has_partner(SideId side) const {
    for (SideId other = triangles_.links[side]; other != side; other = triangles_.links[other]) {
      if (std::binary_search(alive_.begin(), alive_.end(), triangle_of_side(other)) &&
          dihedral_cosine(triangles_, side, other) <= sharp_cosine_) {
        return true;
      }
    }
    return false;
  }

  const LinkedFacets& triangles_;
  double sharp_cosine_;
  std::vector<std::uint32_t> alive_;      // ascending
  std::vector<std::uint32_t> survivors_;  // of the round
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

Fans fans_at(const LinkedFacets& triangles, const SharedFlags& flags, std::size_t num_vertices) {
  Fans fans{std::vector<std::uint32_t>(num_vertices + 2, 0), {}};
  for (const Triangle& corners : triangles.corners) {
    for (const VertexId v : corners) fans.begins[v.index() + 2] += flags.is_raised(v) ? 1U : 0U;
  }
  for (std::size_t v = 2; v < fans.begins.size(); ++v) fans.begins[v] += fans.begins[v - 1];
  fans.triangles.resize(fans.begins.back());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (const VertexId v : triangles.corners[t]) {
      if (flags.is_raised(v)) fans.triangles[fans.begins[v.index() + 1]++] = t;
    }
  }
  return fans;
}

struct FirstCorners {
  IdVector<VertexId, std::uint32_t> count;  // triangles at each vertex
  IdVector<VertexId, SideId> side;          // opposite the vertex, in one of them
};

FirstCorners first_corners(const LinkedFacets& triangles, std::size_t num_vertices) {
  FirstCorners first{IdVector<VertexId, std::uint32_t>(num_vertices, 0),
                     IdVector<VertexId, SideId>(num_vertices, 0)};
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const VertexId v = triangles.corners[t][i];
      ++first.count[v];
      first.side[v] = 3 * t + i;
    }
  }
  return first;
}

// Do the triangles around v, two at each spoke, make one single cycle?
bool is_one_cycle(const LinkedFacets& triangles, VertexId v, const FirstCorners& first) {
  if (first.count[v] < 6) return true;  // two cycles have three triangles each
  std::uint32_t walked = 0;
  SideId corner = first.side[v];
  std::size_t arrived = next_corner(corner_of_side(corner));
  do {
    // Over the other of the two spokes into the next triangle.
    const std::uint32_t t = triangle_of_side(corner);
    const std::size_t leaving = 3 - corner_of_side(corner) - arrived;
    const SideId crossed = triangles.links[3 * t + static_cast<SideId>(leaving)];
    const Triangle& corners = triangles.corners[triangle_of_side(crossed)];
    arrived = corner_of_side(crossed);
    const std::size_t at =
        corners[next_corner(arrived)] == v ? next_corner(arrived) : previous_corner(arrived);
    corner = 3 * triangle_of_side(crossed) + static_cast<SideId>(at);
    ++walked;
  } while (triangle_of_side(corner) != triangle_of_side(first.side[v]));
  return walked == first.count[v];
}

}  // namespace

VertexSet vertices_with_umbrella(const LinkedFacets& triangles, std::size_t num_vertices,
                                 double sharp_cosine, const Execution& execution) {
  SharedFlags doubtful(num_vertices);
  parallel_chunks(execution, triangles.size(), triangles_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for_each_edge(triangles, begin, end, [&](SideId side) {
                      if (triangles.is_two_sided(side) &&
                          dihedral_cosine(triangles, side, triangles.links[side]) <= sharp_cosine) {
                        return;
                      }
                      for (const VertexId v : triangles.ends(side)) doubtful.raise(v);
                    });
                  });
  VertexSet flags(num_vertices, 0);
  for (const Triangle& corners : triangles.corners) {
    for (const VertexId v : corners) flags[v] = 1;
  }
  const Fans fans = fans_at(triangles, doubtful, num_vertices);
  parallel_chunks(execution, num_vertices, vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    UmbrellaSearch search(triangles, sharp_cosine);
                    for (VertexId v(begin); v.index() < end; ++v) {
                      if (doubtful.is_raised(v)) flags[v] = search.exists(v, fans.at(v)) ? 1 : 0;
                    }
                  });
  return flags;
}

GoodVertices good_vertices(const LinkedFacets& triangles, const VertexSet& boundary,
                           const GoodVertexOptions& options, const Execution& execution) {
  const std::size_t count = boundary.size();
  SharedFlags open(count);  // some spoke has one triangle, or more than two
  SharedFlags folded(count);
  parallel_chunks(execution, triangles.size(), triangles_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for_each_edge(triangles, begin, end, [&](SideId side) {
                      const bool regular = triangles.is_two_sided(side);
                      const double cosine =
                          regular ? dihedral_cosine(triangles, side, triangles.links[side]) : 0;
                      for (const VertexId v : triangles.ends(side)) {
                        if (!regular) {
                          open.raise(v);
                        } else if (cosine >= options.fold_cosine ||
                                   (boundary[v] != 0 && cosine > options.crease_cosine)) {
                          folded.raise(v);
                        }
                      }
                    });
                  });
  const FirstCorners first = first_corners(triangles, count);
  GoodVertices result{VertexSet(count, 0), 0, 0};
  std::atomic<std::size_t> good = 0;
  std::atomic<std::size_t> demoted = 0;
  parallel_chunks(execution, count, vertices_per_chunk, [&](std::size_t begin, std::size_t end) {
    std::size_t good_here = 0;
    std::size_t demoted_here = 0;
    for (VertexId v(begin); v.index() < end; ++v) {
      if (first.count[v] < 3 || open.is_raised(v) || !is_one_cycle(triangles, v, first)) continue;
      result.good[v] = !folded.is_raised(v);
      (folded.is_raised(v) ? demoted_here : good_here) += 1;
    }
    good += good_here;
    demoted += demoted_here;
  });
  result.count = good;
  result.demoted = demoted;
  return result;
}

}  // namespace cocoon
