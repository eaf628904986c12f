#include "cocone/samples/farthest_cells.h"

#include <algorithm>
#include <atomic>
#include <bit>

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

FarthestCells::FarthestCells(const Triangulation& triangulation, const Dual& dual,
                             const Execution& execution)
    : triangulation_(triangulation),
      dual_(dual),
      words_(triangulation.num_vertices(), 0),
      alone_(thread_count(execution) == 1) {}

void FarthestCells::offer(CellId first, const CellBlock& block, const ArmWords& words) {
  alone_ ? offer_alone(first, block, words) : offer_beside_others(first, block, words);
}

CellId FarthestCells::farthest(VertexId p) const {
  return unpack(std::atomic_ref<std::uint64_t>(words_[p]).load(std::memory_order_relaxed));
}

// No branch on which corners a cell wins, which cannot be foreseen.
void FarthestCells::offer_alone(CellId first, const CellBlock& block, const ArmWords& words) {
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

void FarthestCells::offer_beside_others(CellId first, const CellBlock& block,
                                        const ArmWords& words) {
  for (std::size_t k = 0; k < block.size; ++k) {
    const Cell& cell = triangulation_.cell(CellId(first.index() + k));
    unsigned open = 0;  // corners that are not done
    for (unsigned j = 0; j < 4; ++j) {
      const std::atomic_ref<std::uint64_t> word(words_[cell.vertices[j]]);
      const std::uint64_t known = word.load(std::memory_order_relaxed);
      open |= static_cast<unsigned>(known >> 32 <= words.at(k, j) >> 32) << j;
    }
    for (; open != 0; open &= open - 1) {
      const auto j = static_cast<unsigned>(std::countr_zero(open));
      offer_at(cell.vertices[j], block.center(k), words.at(k, j));
    }
  }
}

void FarthestCells::offer_at(VertexId p, const Point& center, std::uint64_t offered) {
  const std::atomic_ref<std::uint64_t> word(words_[p]);
  std::uint64_t known = word.load(std::memory_order_relaxed);
  while (known >> 32 <= offered >> 32) {
    if (negative_if_tied(known, offered) < 0 && !precedes(p, center, known)) return;
    if (word.compare_exchange_weak(known, offered, std::memory_order_relaxed)) return;
  }
}

bool FarthestCells::precedes(VertexId p, const Point& center, std::uint64_t known) const {
  return Arm(center - triangulation_.point(p))
      .precedes(arm_of(triangulation_, dual_, unpack(known), p));
}

}  // namespace cocoon
