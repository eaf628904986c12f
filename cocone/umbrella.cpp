#include "cocone/umbrella.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace cocoon {
namespace {

constexpr std::size_t vertices_per_chunk = 4096;

// Drops triangles without a partner at one of their spokes; true iff some survive.
class UmbrellaSearch {
 public:
  bool exists(const TriangleFans& fans, VertexId center, double sharp_cosine) {
    if (fans.around(center).size() < 3) return false;
    collect_spokes(fans, center, spokes_);
    alive_.assign(fans.around(center).size(), 1);
    while (drop_round(fans, sharp_cosine)) {
    }
    return std::find(alive_.begin(), alive_.end(), 1) != alive_.end();
  }

 private:
  bool drop_round(const TriangleFans& fans, double sharp_cosine) {
    bool dropped = false;
    for_each_edge(spokes_, [&](std::span<const Spoke> edge) {
      for (const Spoke& spoke : edge) {
        if (alive_[spoke.local] == 0 || has_partner(fans, edge, spoke, sharp_cosine)) continue;
        alive_[spoke.local] = 0;
        dropped = true;
      }
    });
    return dropped;
  }

  bool has_partner(const TriangleFans& fans, std::span<const Spoke> edge, const Spoke& spoke,
                   double sharp_cosine) const {
    for (const Spoke& other : edge) {
      if (other.local != spoke.local && alive_[other.local] != 0 &&
          dihedral_cosine(fans, spoke, other) <= sharp_cosine) {
        return true;
      }
    }
    return false;
  }

  std::vector<Spoke> spokes_;
  std::vector<std::uint8_t> alive_;
};

// Do the triangles of these spokes make exactly one closed cycle?
bool is_one_closed_umbrella(std::span<const Spoke> spokes, std::vector<std::uint32_t>& position) {
  const std::size_t triangles = spokes.size() / 2;
  if (triangles < 3) return false;
  for (std::size_t s = 0; s < spokes.size(); s += 2) {
    if (spokes[s].other != spokes[s + 1].other) return false;
    if (s > 0 && spokes[s].other == spokes[s - 1].other) return false;
  }
  // the two spokes of each triangle; spokes 2 m and 2 m + 1 are partners
  position.assign(spokes.size(), Id<struct SpokeTag>::none_value);
  for (std::uint32_t s = 0; s < spokes.size(); ++s) {
    const std::size_t first = 2 * spokes[s].local;
    position[position[first] == Id<struct SpokeTag>::none_value ? first : first + 1] = s;
  }
  std::size_t walked = 0;
  std::uint32_t spoke = 0;
  do {
    const std::uint32_t arrived = spoke ^ 1U;
    const std::size_t first = 2 * spokes[arrived].local;
    spoke = position[first] == arrived ? position[first + 1] : position[first];
    ++walked;
  } while (spoke != 0);
  return walked == triangles;
}

bool is_folded(const TriangleFans& fans, VertexId v, const VertexSet& umbrella,
               const VertexSet& boundary, const GoodVertexOptions& options,
               std::vector<Spoke>& spokes) {
  collect_spokes(fans, v, spokes);
  const double limit = boundary[v] != 0 ? options.crease_cosine : options.fold_cosine;
  bool folded = false;
  for_each_edge(spokes, [&](std::span<const Spoke> edge) {
    if (edge.size() != 2 || (umbrella[v] == 0 && umbrella[edge[0].other] == 0)) return;
    const double cosine = dihedral_cosine(fans, edge[0], edge[1]);
    folded |= cosine >= options.fold_cosine || cosine > limit;
  });
  return folded;
}

}  // namespace

VertexSet vertices_with_umbrella(const TriangleFans& fans, double sharp_cosine,
                                 const Execution& execution) {
  VertexSet flags(fans.offsets.size() - 1, 0);
  parallel_chunks(execution, flags.size(), vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    UmbrellaSearch search;
                    for (VertexId v(begin); v.index() < end; ++v) {
                      flags[v] = search.exists(fans, v, sharp_cosine);
                    }
                  });
  return flags;
}

GoodVertices good_vertices(const TriangleFans& fans, const VertexSet& boundary,
                           const GoodVertexOptions& options, const Execution& execution) {
  const std::size_t count = fans.offsets.size() - 1;
  VertexSet umbrella(count, 0);
  parallel_chunks(execution, count, vertices_per_chunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Spoke> spokes;
    std::vector<std::uint32_t> position;
    for (VertexId v(begin); v.index() < end; ++v) {
      collect_spokes(fans, v, spokes);
      umbrella[v] = is_one_closed_umbrella(spokes, position);
    }
  });
  GoodVertices result{umbrella, 0, 0};
  std::atomic<std::size_t> good = 0;
  std::atomic<std::size_t> demoted = 0;
  parallel_chunks(execution, count, vertices_per_chunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Spoke> spokes;
    std::size_t good_here = 0;
    std::size_t demoted_here = 0;
    for (VertexId v(begin); v.index() < end; ++v) {
      if (umbrella[v] == 0) continue;
      const bool folded = is_folded(fans, v, umbrella, boundary, options, spokes);
      result.good[v] = !folded;
      (folded ? demoted_here : good_here) += 1;
    }
    good += good_here;
    demoted += demoted_here;
  });
  result.count = good;
  result.demoted = demoted;
  return result;
}

}  // namespace cocoon
