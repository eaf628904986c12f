#include "geom/edge_components.h"

#include "geom/ids.h"
#include "geom/zeroed_array.h"

namespace cocoon {
namespace edge_components_detail {

Seeds::Seeds(std::size_t num_triangles)
    : sets_(num_triangles),
      words_(num_triangles),
      chunks_((num_triangles + triangles_per_chunk - 1) / triangles_per_chunk) {
  for (std::uint32_t t = 0; t < num_triangles; ++t) words_[t] = word_of_seed(t);
}

void Seeds::join(std::uint32_t word, std::uint32_t other, Chunk& chunk) {
  if (!sets_.join(word >> 1, other >> 1, (word ^ other) & 1U)) {
    chunk.contradicted.push_back(word >> 1);
  }
}

void Seeds::list_seeds(std::size_t begin, std::size_t end, Chunk& chunk) {
  for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
    if (words_[t] == word_of_seed(t)) chunk.seeds.push_back(t);
  }
}

EdgeComponents Seeds::number(const Execution& execution) {
  for (Chunk& chunk : chunks_) {
    for (const Join& j : chunk.to_earlier)
      join(words_[j.triangle], words_[j.other] ^ j.turned, chunk);
  }
  EdgeComponents result;
  ZeroedArray<TriangleId, std::uint32_t> numbers(
      words_.size());  // of seeds: as words_, of components
  for (const Chunk& chunk : chunks_) {
    for (const std::uint32_t seed : chunk.seeds) {
      const TurnedSets::Place place = sets_.place(seed);
      std::uint32_t& number = numbers[TriangleId(seed)];
      if (place.root == seed) {
        number = static_cast<std::uint32_t>(result.components.size()) << 1;
        result.components.emplace_back();
      } else {
        number = numbers[TriangleId(place.root)] ^ place.turned;
      }
    }
  }
  result.component_of.resize(words_.size());
  result.turned.resize(words_.size());
  parallel_chunks(
      execution, words_.size(), triangles_per_chunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          const std::uint32_t number = numbers[TriangleId(words_[t] >> 1)] ^ (words_[t] & 1U);
          result.component_of[t] = number >> 1;
          result.turned[t] = static_cast<std::uint8_t>(number & 1U);
        }
      });
  for (std::size_t t = 0; t < words_.size(); ++t) {
    EdgeComponent& component = result.components[result.component_of[t]];
    ++component.triangles;
    component.turned += result.turned[t];
  }
  for (const Chunk& chunk : chunks_) {
    for (const std::uint32_t seed : chunk.contradicted) {
      result.components[numbers[TriangleId(seed)] >> 1].is_contradictory = true;
    }
  }
  return result;
}

}  // namespace edge_components_detail

EdgeComponents edge_components(const TriangleMesh& mesh, const LinkedSides& sides,
                               const Execution& execution) {
  return edge_components(
      sides.links, execution, [](SideId) { return true; },
      [&](SideId side, SideId across) {
        return ends_of_side(mesh, side)[0] == ends_of_side(mesh, across)[0];
      });
}

}  // namespace cocoon
