#include "cocone/energy/star_parts.h"

#include <bit>

#include "delaunay/circulate.h"

namespace cocoon {
namespace {

constexpr std::uint8_t in_part = 2;  // in the place of a side

}  // namespace

StarParts::StarParts(const Triangulation& triangulation, StarCache& stars,
                     IdVector<CellId, std::uint8_t>& out)
    : triangulation_(triangulation),
      stars_(stars),
      out_(out),
      place_(triangulation.num_vertices()),
      position_(triangulation.num_cells()) {}

StarParts::SmallStar& StarParts::small_star(VertexId v) {
  if (place_[v] != 0) return small_stars_[place_[v] - 1];
  const std::span<const CellId> star = stars_.star(v);
  for (std::size_t k = 0; k < star.size(); ++k) position_[star[k]] = static_cast<std::uint32_t>(k);
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

const StarParts::LargeStar& StarParts::large_star(VertexId v) {
  if (place_[v] != 0) return large_stars_[place_[v] - 1];
  const std::span<const CellId> star = stars_.star(v);
  for (std::size_t k = 0; k < star.size(); ++k) position_[star[k]] = static_cast<std::uint32_t>(k);
  LargeStar& links = large_stars_.emplace_back(star.size());
  for (std::size_t k = 0; k < star.size(); ++k) {
    const int opposite = index_of_vertex(triangulation_.cell(star[k]), v);
    for (int i = 0; i < 3; ++i) {
      links[k][static_cast<std::size_t>(i)] =
          position_[triangulation_.neighbor(star[k], facet_corners[opposite][i])];
    }
  }
  place_[v] = static_cast<std::uint32_t>(large_stars_.size());
  return links;
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

template <class Visit>
void StarParts::for_each_part_in_word(const std::vector<Word>& neighbors, Word outside,
                                      Visit visit) {
  Word left = ~Word{0} >> (word_size - neighbors.size());
  while (left != 0) {
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
    visit(part);
  }
}

// Many cells of a star are asked about before one of them changes sides.
std::size_t StarParts::count_parts(SmallStar& star, Word outside) {
  if (star.parts == 0 || star.outside != outside) {
    star.outside = outside;
    star.parts = 0;
    for_each_part_in_word(star.neighbors, outside, [&](Word) { ++star.parts; });
  }
  return star.parts;
}

std::size_t StarParts::count(VertexId v) {
  if (!is_large(v)) return count_parts(small_star(v), outside(v));
  std::size_t parts = 0;
  for_each_part_of_large(v, [&] { ++parts; });
  return parts;
}

std::size_t StarParts::count_after(VertexId v, std::span<const CellId> cells, std::size_t parts) {
  const bool look_around = is_large(v) && cells.size() < stars_.star(v).size() / word_size;
  auto known = static_cast<int>(parts);
  bool is_known = look_around;
  for (const CellId c : cells) {
    if (is_known && has_vertex(triangulation_.cell(c), v)) {
      const std::optional<int> change = change_by(v, c);
      is_known = change.has_value();
      known += change.value_or(0);
    }
    out_[c] ^= 1U;
  }
  const std::size_t after = is_known ? static_cast<std::size_t>(known) : count(v);
  for (const CellId c : cells) out_[c] ^= 1U;
  return after;
}

// How many parts there are more once c changes sides, where the cells around it tell. Around v, c
// has three neighbors, and a fan of cells leads from each of them to the next around a corner of c.
std::optional<int> StarParts::change_by(VertexId v, CellId c) const {
  const int at_v = index_of_vertex(triangulation_.cell(c), v);
  int same = 0;  // neighbors on the side of c
  int last_same = 0;
  int last_other = 0;
  for (const int i : facet_corners[at_v]) {
    const bool is_same = out_[triangulation_.neighbor(c, i)] == out_[c];
    same += is_same ? 1 : 0;
    (is_same ? last_same : last_other) = i;
  }
  // One neighbor alone, and two on the other side, which stay, or are, one part if the fan between
  // them is on that side: it leads around the corner opposite the one alone.
  if (same == 1 || same == 2) {
    const int corner = same == 1 ? last_same : last_other;
    return is_fan_of_one_side(v, c, corner) ? std::optional(0) : std::nullopt;
  }
  int joined = 0;
  for (const int i : facet_corners[at_v]) joined += is_fan_of_one_side(v, c, i) ? 1 : 0;
  if (joined < 2) return std::nullopt;
  return same == 0 ? -1 : 1;  // c is a part now, or will be one
}

// Are all cells around the edge of v and that corner of c, but for c, on one side?
bool StarParts::is_fan_of_one_side(VertexId v, CellId c, int corner) const {
  const VertexId w = triangulation_.vertex(c, corner);
  int off = 0;  // a facet at the edge is opposite another vertex
  while (off == corner || triangulation_.vertex(c, off) == v) ++off;
  const FacetId first = facet_id(c, off);
  FacetId f = next_facet_around_edge(triangulation_, first, v, w);
  const std::uint8_t side = out_[cell_of(f)];
  for (; f != first; f = next_facet_around_edge(triangulation_, f, v, w)) {
    if (out_[cell_of(f)] != side) return false;
  }
  return true;
}

std::vector<std::vector<CellId>> StarParts::list(VertexId v) {
  const std::span<const CellId> star = stars_.star(v);
  std::vector<std::vector<CellId>> parts;
  if (is_large(v)) {
    for_each_part_of_large(v, [&] {
      std::vector<CellId>& part = parts.emplace_back();
      part.reserve(part_.size());
      for (const std::uint32_t k : part_) part.push_back(star[k]);
    });
    return parts;
  }
  for_each_part_in_word(small_star(v).neighbors, outside(v), [&](Word word) {
    std::vector<CellId>& part = parts.emplace_back();
    part.reserve(static_cast<std::size_t>(std::popcount(word)));
    for (Word left = word; left != 0; left &= left - 1) {
      part.push_back(star[static_cast<std::size_t>(std::countr_zero(left))]);
    }
  });
  return parts;
}

// part_ is the part.
template <class Visit>
void StarParts::for_each_part_of_large(VertexId v, Visit visit) {
  const LargeStar& links = large_star(v);
  sides_.clear();
  for (const CellId c : stars_.star(v)) sides_.push_back(out_[c]);
  for (std::uint32_t k = 0; k < sides_.size(); ++k) {
    if (sides_[k] == in_part) continue;
    collect_part(links, k);
    visit();
  }
}

void StarParts::collect_part(const LargeStar& star, std::uint32_t first) {
  const std::uint8_t side = sides_[first];
  part_.assign(1, first);
  sides_[first] = in_part;
  for (std::size_t next = 0; next < part_.size(); ++next) {
    for (const std::uint32_t behind : star[part_[next]]) {
      if (sides_[behind] != side) continue;
      sides_[behind] = in_part;
      part_.push_back(behind);
    }
  }
}

}  // namespace cocoon
