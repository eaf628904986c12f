#include "geom/mesh/edge_components.h"

namespace cocoon {
namespace edge_components_detail {

Seeds::Seeds(std::size_t num_triangles)
    : sets_(num_triangles),
      chunks_((num_triangles + triangles_per_chunk - 1) / triangles_per_chunk) {}

void Seeds::join(std::uint32_t word, std::uint32_t other, Chunk& chunk) {
  if (!sets_.join(word >> 1, other >> 1, (word ^ other) & 1U)) {
    chunk.contradicted.push_back(word >> 1);
  }
}

void Seeds::list_seeds(std::size_t begin, std::size_t end, Chunk& chunk) {
  for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
    if (sets_.word(t) == TurnedSets::word_of_root(t)) chunk.seeds.push_back(t);
  }
}

// Joins the chunks, and hangs every seed right under its root.
void Seeds::flatten() {
  for (Chunk& chunk : chunks_) {
    for (const Join& j : chunk.to_earlier) {
      join(sets_.word(j.triangle), sets_.word(j.other) ^ j.turned, chunk);
    }
  }
  for (const Chunk& chunk : chunks_) {
    for (const std::uint32_t seed : chunk.seeds) {
      const TurnedSets::Place place = sets_.place(seed);
      sets_.hang(seed, TurnedSets::word_of_root(place.root) | place.turned);
    }
  }
}

EdgeComponents Seeds::number(const Execution& execution) && {
  flatten();
  EdgeComponents result;
  std::vector<std::uint32_t> words = std::move(sets_).take();
  // Of seeds from now on: 2 * component, + 1 if they are turned against its first triangle.
  for (const Chunk& chunk : chunks_) {
    for (const std::uint32_t seed : chunk.seeds) {
      if (words[seed] == TurnedSets::word_of_root(seed)) {
        words[seed] = static_cast<std::uint32_t>(result.components.size()) << 1;
        result.components.emplace_back();
      } else {
        words[seed] = words[words[seed] >> 1] ^ (words[seed] & 1U);
      }
    }
  }
  result.turned.resize(words.size());
  const auto set = [&](std::size_t t, std::uint32_t word) {
    result.turned[t] = static_cast<std::uint8_t>(word & 1U);
    words[t] = word >> 1;
  };
  parallel_chunks(
      execution, words.size(), triangles_per_chunk, [&](std::size_t begin, std::size_t end) {
        const std::vector<std::uint32_t>& seeds = chunks_[begin / triangles_per_chunk].seeds;
        auto seed = seeds.begin();
        for (std::size_t t = begin; t < end; ++t) {
          if (seed != seeds.end() && *seed == t) {
            ++seed;  // others ask it; its turn comes
          } else {
            set(t, words[words[t] >> 1] ^ (words[t] & 1U));
          }
        }
        for (const std::uint32_t t : seeds) set(t, words[t]);
      });
  result.component_of = std::move(words);
  for (std::size_t t = 0; t < result.component_of.size(); ++t) {
    EdgeComponent& component = result.components[result.component_of[t]];
    ++component.triangles;
    component.turned += result.turned[t];
  }
  for (const Chunk& chunk : chunks_) {
    for (const std::uint32_t seed : chunk.contradicted) {
      result.components[result.component_of[seed]].is_contradictory = true;
    }
  }
  return result;
}

}  // namespace edge_components_detail

EdgeComponents edge_components(const TriangleMesh& mesh, const HalfedgeRings& rings,
                               const Execution& execution) {
  return edge_components(
      rings.links, execution, [](Halfedge) { return true; },
      [&](Halfedge halfedge, Halfedge across) {
        return ends_of_halfedge(mesh, halfedge)[0] == ends_of_halfedge(mesh, across)[0];
      });
}

}  // namespace cocoon
