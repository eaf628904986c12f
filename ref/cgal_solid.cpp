// mark() and peel() of cgal_triangulation.h.
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "ref/cgal_triangulation.h"

namespace cocoon::ref::on_cgal {
namespace {

// What marking_rounds.h asks.
class MarkedDelaunay {
 public:
  using Cell = CellHandle;
  using Vertex = VertexHandle;

  explicit MarkedDelaunay(Delaunay& delaunay) : delaunay_(delaunay) {}

  std::vector<Cell> star(Vertex v) const {
    std::vector<Cell> cells;
    delaunay_.incident_cells(v, std::back_inserter(cells));
    return cells;
  }
  static Vertex vertex(Cell c, int i) { return c->vertex(i); }
  static Cell neighbor(Cell c, int i) { return c->neighbor(i); }
  static bool on_surface(Cell c, int i) { return is_surface({c, i}); }
  static CellNotes& notes(Cell c) { return c->info().marking; }
  bool take_turn(Vertex v) const {
    if (delaunay_.is_infinite(v) || !v->info().good) return false;
    return !std::exchange(v->info().visited, true);
  }

 private:
  Delaunay& delaunay_;
};

class Solid {
 public:
  explicit Solid(Delaunay& delaunay) : delaunay_(delaunay), marked_(delaunay) {}

  void find_good_vertices(const CgalCoconeOptions& options) {
    for (const VertexHandle v : delaunay_.finite_vertex_handles()) {
      v->info().good = has_one_umbrella(v) && !lies_at_fold(v, options);
    }
  }

  void mark_from_infinity() {
    std::vector<VertexHandle> hull;
    for (const CellHandle c : delaunay_.all_cell_handles()) {
      if (!delaunay_.is_infinite(c)) continue;
      side(c) = Side::out;
      for (int i = 0; i < 4; ++i) hull.push_back(c->vertex(i));
    }
    MarkingRounds(marked_).run(hull);
  }

  // Reaches what can be reached with the sides as they are, then marks from the good vertices come
  // to, until nothing changes. Then a second time: vertices that no mark came to are good no more.
  void peel() {
    for (const CellHandle c : delaunay_.all_cell_handles()) {
      c->info().reached = delaunay_.is_infinite(c);
    }
    while (reach_and_mark()) {
    }
    for (const VertexHandle v : delaunay_.finite_vertex_handles()) {
      v->info().good = v->info().good && v->info().visited;
    }
    reach_and_mark();
  }

 private:
  static Side& side(CellHandle c) { return MarkedDelaunay::notes(c).side; }

  // The surface facets at v form one closed umbrella.
  bool has_one_umbrella(VertexHandle v) const {
    const auto link = link_of(delaunay_, v);
    if (link.size() < 3) return false;
    VertexHandle at = link[0][1];
    std::size_t previous = 0;
    for (std::size_t steps = 1; steps < link.size(); ++steps) {
      std::optional<std::size_t> next;
      for (std::size_t i = 0; i < link.size(); ++i) {
        if (i == previous || (link[i][0] != at && link[i][1] != at)) continue;
        if (next) return false;
        next = i;
      }
      if (!next || *next == 0) return false;
      at = link[*next][0] == at ? link[*next][1] : link[*next][0];
      previous = *next;
    }
    return at == link[0][0];
  }

  // Whether two neighbors of the umbrella of v meet at a fold, or at a crease if v is a boundary
  // sample.
  bool lies_at_fold(VertexHandle v, const CgalCoconeOptions& options) const {
    const auto link = link_of(delaunay_, v);
    for (std::size_t i = 0; i < link.size(); ++i) {
      for (std::size_t j = i + 1; j < link.size(); ++j) {
        for (const auto& [spoke, far] : {link[i], std::array{link[i][1], link[i][0]}}) {
          if (link[j][0] != spoke && link[j][1] != spoke) continue;
          const VertexHandle other = link[j][0] == spoke ? link[j][1] : link[j][0];
          const double cosine = dihedral_cosine(v, spoke, far, other);
          if (cosine >= options.fold_cosine) return true;
          if (!v->info().interior && cosine > options.crease_cosine) return true;
        }
      }
    }
    return false;
  }

  // True if there were vertices to mark from.
  bool reach_and_mark() {
    std::vector<CellHandle> stack;
    for (const CellHandle c : delaunay_.all_cell_handles()) {
      if (c->info().reached) stack.push_back(c);
    }
    std::vector<VertexHandle> seeds;
    while (!stack.empty()) {
      const CellHandle c = stack.back();
      stack.pop_back();
      for (int i = 0; i < 4; ++i) {
        const VertexHandle v = c->vertex(i);
        if (v->info().good && !v->info().visited) seeds.push_back(v);
        const CellHandle n = c->neighbor(i);
        if (n->info().reached || !may_peel({n, n->index(c)})) continue;
        n->info().reached = true;
        side(n) = Side::out;
        stack.push_back(n);
      }
    }
    MarkingRounds(marked_).run(seeds);
    return !seeds.empty();
  }

  // Whether the peel may enter the cell of f through f: it is outside, or poor and f is the
  // smallest facet neither of it nor of the cell on the other side.
  bool may_peel(const Facet& f) const {
    const CellHandle n = f.first;
    if (side(n) != Side::unmarked) return side(n) == Side::out;
    const Facet mirror = delaunay_.mirror_facet(f);
    return is_poor(n) && stop_facet(n) != f.second &&
           (!is_poor(mirror.first) || stop_facet(mirror.first) != mirror.second);
  }
  bool is_poor(CellHandle c) const {
    if (delaunay_.is_infinite(c)) return false;
    for (int i = 0; i < 4; ++i) {
      if (c->vertex(i)->info().good) return false;
    }
    return true;
  }
  // The one with the smallest circle; of equal ones that with the lexicographically smaller
  // corners.
  static int stop_facet(CellHandle c) {
    const auto size = [&](int i) { return std::pair{circumradius({c, i}), sorted_places({c, i})}; };
    int smallest = 0;
    for (int i = 1; i < 4; ++i) {
      if (size(i) < size(smallest)) smallest = i;
    }
    const int wanted = c->info().stop_facet_at_ties;
    if (wanted < 0 || wanted == smallest) return smallest;
    c->info().took_tie = size(wanted).first <= (1 + rounding) * size(smallest).first;
    return c->info().took_tie ? wanted : smallest;
  }

  Delaunay& delaunay_;
  MarkedDelaunay marked_;
};

}  // namespace

void mark(Delaunay& delaunay, const CgalCoconeOptions& options) {
  Solid solid(delaunay);
  solid.find_good_vertices(options);
  solid.mark_from_infinity();
}

void peel(Delaunay& delaunay) { Solid(delaunay).peel(); }

}  // namespace cocoon::ref::on_cgal
