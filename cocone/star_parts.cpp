#include "cocone/star_parts.h"

#include <bit>

#include "delaunay/circulate.h"

namespace cocoon {

StarParts::StarParts(const Triangulation& triangulation, StarCache& stars,
                     const IdVector<CellId, std::uint8_t>& out)
    : triangulation_(triangulation),
      stars_(stars),
      out_(out),
      place_(triangulation.num_vertices()),
      position_(triangulation.num_cells()),
      stamp_(triangulation.num_cells()) {}

StarParts::SmallStar& StarParts::small_star(VertexId v) {
  if (place_[v] != 0) return small_stars_[place_[v] - 1];
  const std::span<const CellId> star = stars_.star(v);
  for (std::size_t k = 0; k < star.size(); ++k) position_[star[k]] = static_cast<std::uint8_t>(k);
  std::vector<Word> links(star.size(), 0);
  for (std::size_t k = 0; k < star.size(); ++k) {
    const int opposite = index_of_vertex(triangulation_.cell(star[k]), v);
    for (int i = 0; i < 4; ++i) {
      if (i != opposite) links[k] |= Word{1} << position_[triangulation_.neighbor(star[k], i)];
    }
  }
  small_stars_.push_back({std::move(links)});
  place_[v] = static_cast<std::uint32_t>(small_stars_.size());
  return small_stars_.back();
}

// Bit k: the k-th cell of a small star is OUT.
StarParts::Word StarParts::outside(VertexId v) {
  Word word = 0;
  Word bit = 1;
  for (const CellId c : stars_.star(v)) {
    if (out_[c] != 0) word |= bit;
    bit <<= 1;
  }
  return word;
}

std::size_t StarParts::count_in_word(const std::vector<Word>& neighbors, Word outside) {
  Word left = ~Word{0} >> (word_size - neighbors.size());
  std::size_t parts = 0;
  for (; left != 0; ++parts) {
    const Word first = left & -left;
    const Word side = left & ((outside & first) != 0 ? outside : ~outside);
    Word part = first;
    for (Word open = first; open != 0;) {
      const Word reached =
          neighbors[static_cast<std::size_t>(std::countr_zero(open))] & side & ~part;
      part |= reached;
      open = (open & (open - 1)) | reached;
    }
    left &= ~part;
  }
  return parts;
}

// Many cells of a star are asked about before one of them changes sides.
std::size_t StarParts::count_parts(SmallStar& star, Word outside) {
  if (star.parts == 0 || star.outside != outside) {
    star.outside = outside;
    star.parts = count_in_word(star.neighbors, outside);
  }
  return star.parts;
}

std::size_t StarParts::count(VertexId v) {
  if (stars_.star(v).size() <= word_size) return count_parts(small_star(v), outside(v));
  std::size_t parts = 0;
  for_each_part(v, [&](const std::vector<CellId>&) { ++parts; });
  return parts;
}

std::vector<std::vector<CellId>> StarParts::list(VertexId v) {
  std::vector<std::vector<CellId>> parts;
  for_each_part(v, [&](const std::vector<CellId>& part) { parts.push_back(part); });
  return parts;
}

template <class Visit>
void StarParts::for_each_part(VertexId v, Visit visit) {
  ++token_;
  for (const CellId c : stars_.star(v)) {
    if (stamp_[c] == token_) continue;
    flood(v, c);
    visit(part_);
  }
}

void StarParts::flood(VertexId v, CellId first) {
  part_.assign(1, first);
  stamp_[first] = token_;
  for (std::size_t next = 0; next < part_.size(); ++next) {
    const int opposite = index_of_vertex(triangulation_.cell(part_[next]), v);
    for (int i = 0; i < 4; ++i) {
      const CellId behind = triangulation_.neighbor(part_[next], i);
      if (i == opposite || stamp_[behind] == token_ || out_[behind] != out_[first]) continue;
      stamp_[behind] = token_;
      part_.push_back(behind);
    }
  }
}

}  // namespace cocoon
