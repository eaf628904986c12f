// The marking of Tight Cocone by its definition, round after round, whatever the triangulation.
// Written for reading; shares no code with the stage.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cocoon::ref {

enum class Side : std::uint8_t { unmarked, out, in };

struct Votes {
  std::size_t out = 0;
  std::size_t in = 0;

  void add(Side side) {
    out += side == Side::out ? 1U : 0U;
    in += side == Side::in ? 1U : 0U;
  }
  bool differ() const { return out != 0 && in != 0; }
  // A tie is OUT.
  Side majority() const {
    return out + in == 0 ? Side::unmarked : out >= in ? Side::out : Side::in;
  }
};

// What the marking notes at a cell.
struct CellNotes {
  Side side = Side::unmarked;
  bool in_first_half = false;  // of the star looked at
  Votes told;                  // by the vertices of this round
};

struct RoundCounts {
  std::size_t rounds = 0;
  std::size_t conflicts = 0;  // halves with both sides or like the other half, cells told both
};

// `Complex` has the types Cell and Vertex, and
//
//   std::vector<Cell> star(Vertex)   the cells at a vertex, infinite ones included
//   Vertex vertex(Cell, int)         its four vertices
//   Cell neighbor(Cell, int)         neighbor i is behind facet i, opposite vertex i
//   bool on_surface(Cell, int)       whether facet i is one of the surface
//   CellNotes& notes(Cell)
//   bool take_turn(Vertex)           whether it is good and was never asked before
//
// Source: Dey & Goswami 2003 (Tight Cocone, marking). That rounds decide, and majorities where they
// disagree, is ours: then the marks are a function of the set of points.
template <class Complex>
class MarkingRounds {
 public:
  using Cell = typename Complex::Cell;
  using Vertex = typename Complex::Vertex;

  explicit MarkingRounds(Complex& complex) : complex_(complex) {}

  // The turns of those of the seeds that have not had theirs, which touch a cell with a side; then
  // of the vertices that share a triangle of the surface with them, and so on.
  RoundCounts run(const std::vector<Vertex>& seeds) {
    counts_ = {};
    std::vector<Vertex> turn;
    for (const Vertex v : seeds) {
      if (complex_.take_turn(v)) turn.push_back(v);
    }
    while (!turn.empty()) {
      ++counts_.rounds;
      for (const Vertex v : turn) decide(v);
      end_round();
      std::vector<Vertex> next;
      for (const Vertex v : turn) {
        for_each_surface_corner(v, [&](Vertex w) {
          if (complex_.take_turn(w)) next.push_back(w);
        });
      }
      turn = next;
    }
    return counts_;
  }

 private:
  // A half is on the side that most of its cells have. Without any it is opposite to the other.
  void decide(Vertex v) {
    const std::vector<Cell> star = complex_.star(v);
    if (std::all_of(star.begin(), star.end(),
                    [&](Cell c) { return complex_.notes(c).side != Side::unmarked; })) {
      return;
    }
    mark_first_half(v, star);
    Votes first;
    Votes second;
    for (const Cell c : star) {
      const CellNotes& notes = complex_.notes(c);
      (notes.in_first_half ? first : second).add(notes.side);
    }
    Side of_first = first.majority();
    Side of_second = second.majority();
    if (of_first == Side::unmarked) of_first = opposite(of_second);
    if (of_second == Side::unmarked) of_second = opposite(of_first);
    if (first.differ() || second.differ() || of_first == of_second) ++counts_.conflicts;
    for (const Cell c : star) {
      CellNotes& notes = complex_.notes(c);
      if (notes.side == Side::unmarked) {
        if (notes.told.out + notes.told.in == 0) told_.push_back(c);
        notes.told.add(notes.in_first_half ? of_first : of_second);
      }
      notes.in_first_half = false;
    }
  }

  static Side opposite(Side side) { return side == Side::out ? Side::in : Side::out; }

  // The cells at v that hang together with the first one by facets at v off the surface.
  void mark_first_half(Vertex v, const std::vector<Cell>& star) {
    std::vector<Cell> stack = {star.front()};
    complex_.notes(star.front()).in_first_half = true;
    while (!stack.empty()) {
      const Cell c = stack.back();
      stack.pop_back();
      for (int i = 0; i < 4; ++i) {
        if (complex_.vertex(c, i) == v || complex_.on_surface(c, i)) continue;
        const Cell behind = complex_.neighbor(c, i);
        if (complex_.notes(behind).in_first_half) continue;
        complex_.notes(behind).in_first_half = true;
        stack.push_back(behind);
      }
    }
  }

  // Only now: a round reads what earlier rounds have written.
  void end_round() {
    for (const Cell c : told_) {
      CellNotes& notes = complex_.notes(c);
      if (notes.told.differ()) ++counts_.conflicts;
      notes.side = notes.told.majority();
      notes.told = {};
    }
    told_.clear();
  }

  template <class Visit>
  void for_each_surface_corner(Vertex v, Visit visit) {
    for (const Cell c : complex_.star(v)) {
      for (int i = 0; i < 4; ++i) {
        if (complex_.vertex(c, i) == v || !complex_.on_surface(c, i)) continue;
        for (int k = 0; k < 4; ++k) {
          if (k != i) visit(complex_.vertex(c, k));
        }
      }
    }
  }

  Complex& complex_;
  RoundCounts counts_;
  std::vector<Cell> told_;  // in this round
};

}  // namespace cocoon::ref
