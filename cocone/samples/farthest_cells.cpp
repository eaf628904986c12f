#include "cocone/samples/farthest_cells.h"

#include <algorithm>

namespace cocoon {
namespace {

CellId unpack(std::uint64_t word) { return CellId(static_cast<std::uint32_t>(word)); }

// Negative iff the upper halves of two words are equal: these are below 2^31.
std::int64_t negative_if_tied(std::uint64_t a, std::uint64_t b) {
  return static_cast<std::int64_t>(a ^ b) - (std::int64_t{1} << 32);
}

}  // namespace

bool Arm::precedes(const Arm& other) const {
  if (squared_length != other.squared_length) return squared_length > other.squared_length;
  if (is_far()) {
    const double here = squared_norm(safe());
    const double there = squared_norm(other.safe());
    if (here != there) return here > there;
  }
  return vector < other.vector;
}

Arm arm_of(const Triangulation& triangulation, const Dual& dual, CellId c, VertexId p) {
  return Arm(center_of(triangulation, dual, c) - triangulation.point(p));
}

FarthestCells::FarthestCells(const Triangulation& triangulation, const Dual& dual)
    : triangulation_(triangulation), dual_(dual), words_(triangulation.num_vertices(), 0) {}

CellId FarthestCells::farthest(VertexId p) const { return unpack(words_[p]); }

// No branch on which corners a cell wins, which cannot be foreseen.
void FarthestCells::offer(CellId first, const CellBlock& block, const ArmWords& words) {
  for (std::size_t k = 0; k < block.size; ++k) {
    const CellId c(first.index() + k);
    const Cell& cell = triangulation_.cell(c);
    Words known;
    Words offered;
    std::int64_t tied = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      std::uint64_t& word = words_[cell.vertices[j]];
      known[j] = word;
      offered[j] = words.at(k, j);
      tied |= negative_if_tied(known[j], offered[j]);
      word = std::max(known[j], offered[j]);
    }
    if (tied < 0) [[unlikely]]
      decide_ties(c, block.center(k), known, offered);
  }
}

void FarthestCells::decide_ties(CellId c, const Point& center, const Words& known,
                                const Words& offered) {
  for (std::size_t j = 0; j < 4; ++j) {
    if (negative_if_tied(known[j], offered[j]) >= 0) continue;
    const VertexId p = triangulation_.cell(c).vertices[j];
    words_[p] = precedes(p, center, known[j]) ? offered[j] : known[j];
  }
}

void FarthestCells::join(const FarthestCells& others, const Execution& execution) {
  constexpr std::size_t vertices_per_chunk = std::size_t{1} << 14;
  parallel_chunks(execution, words_.size(), vertices_per_chunk,
                  [&](std::size_t begin, std::size_t end) {
                    for (VertexId p(begin); p.index() < end; ++p) {
                      const std::uint64_t known = words_[p];
                      const std::uint64_t offered = others.words_[p];
                      words_[p] = std::max(known, offered);
                      if (known == offered || negative_if_tied(known, offered) >= 0) continue;
                      const Point center = center_of(triangulation_, dual_, unpack(offered));
                      words_[p] = precedes(p, center, known) ? offered : known;
                    }
                  });
}

bool FarthestCells::precedes(VertexId p, const Point& center, std::uint64_t known) const {
  return Arm(center - triangulation_.point(p))
      .precedes(arm_of(triangulation_, dual_, unpack(known), p));
}

}  // namespace cocoon
