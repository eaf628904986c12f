// mark_and_peel() of cgal_triangulation.h.
#include <optional>

#include "ref/cgal_triangulation.h"

namespace cocoon::ref::on_cgal {
namespace {

class Solid {
 public:
  explicit Solid(Delaunay& delaunay) : delaunay_(delaunay) {}

  void mark_and_peel() {
    for (const VertexHandle v : delaunay_.finite_vertex_handles()) v->info().good = is_good(v);
    std::vector<CellHandle> stack;
    for (const CellHandle c : delaunay_.all_cell_handles()) {
      if (!delaunay_.is_infinite(c)) continue;
      c->info().mark = Mark::out;
      c->info().reached = true;
      stack.push_back(c);
    }
    const std::vector<CellHandle> hull = stack;
    for (const CellHandle c : hull) {
      for (int i = 0; i < 4; ++i) mark_from(c->vertex(i));
    }
    while (!stack.empty()) {
      const CellHandle c = stack.back();
      stack.pop_back();
      for (int i = 0; i < 4; ++i) {
        const CellHandle n = c->neighbor(i);
        if (n->info().reached || !may_peel({n, n->index(c)})) continue;
        n->info().reached = true;
        n->info().mark = Mark::out;
        mark_from(n->vertex(n->index(c)));
        stack.push_back(n);
      }
    }
  }

 private:
  // The surface facets at v form one closed umbrella.
  bool is_good(VertexHandle v) {
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

  // Splits the star of each good vertex that can be reached over the surface from `start`.
  void mark_from(VertexHandle start) {
    std::vector<VertexHandle> stack = {start};
    while (!stack.empty()) {
      const VertexHandle v = stack.back();
      stack.pop_back();
      if (delaunay_.is_infinite(v) || !v->info().good || v->info().visited) continue;
      if (!mark_star(v)) continue;
      v->info().visited = true;
      for (const auto& side : link_of(delaunay_, v))
        stack.insert(stack.end(), side.begin(), side.end());
    }
  }

  bool mark_star(VertexHandle v) {
    cells_.clear();
    delaunay_.incident_cells(v, std::back_inserter(cells_));
    std::vector<CellHandle> outside;
    for (const CellHandle c : cells_) {
      if (c->info().mark == Mark::out) outside.push_back(c);
    }
    if (outside.empty()) return false;
    while (!outside.empty()) {
      const CellHandle c = outside.back();
      outside.pop_back();
      for (int i = 0; i < 4; ++i) {
        const CellHandle n = c->neighbor(i);
        if (c->vertex(i) == v || c->info().surface[static_cast<std::size_t>(i)]) continue;
        if (n->info().mark != Mark::none) continue;
        n->info().mark = Mark::out;
        outside.push_back(n);
      }
    }
    for (const CellHandle c : cells_) {
      if (c->info().mark == Mark::none) c->info().mark = Mark::in;
    }
    return true;
  }

  // Whether the peel may enter the cell of f through f: it is outside, or poor and f is the
  // smallest facet neither of it nor of the cell on the other side.
  bool may_peel(const Facet& f) const {
    const CellHandle n = f.first;
    if (n->info().mark == Mark::out) return true;
    if (n->info().mark == Mark::in || !is_poor(n)) return false;
    const Facet mirror = delaunay_.mirror_facet(f);
    return stop_facet(n) != f.second &&
           (!is_poor(mirror.first) || stop_facet(mirror.first) != mirror.second);
  }
  bool is_poor(CellHandle c) const {
    if (delaunay_.is_infinite(c)) return false;
    for (int i = 0; i < 4; ++i) {
      if (c->vertex(i)->info().good) return false;
    }
    return true;
  }
  int stop_facet(CellHandle c) const {
    int smallest = 0;
    double least = infinity;
    for (int i = 0; i < 4; ++i) {
      const double square = CGAL::to_double(delaunay_.triangle(c, i).squared_area() == 0
                                                ? infinity
                                                : CGAL::squared_radius(corner({c, i}, 0)->point(),
                                                                       corner({c, i}, 1)->point(),
                                                                       corner({c, i}, 2)->point()));
      if (square >= least) continue;
      least = square;
      smallest = i;
    }
    return smallest;
  }

  Delaunay& delaunay_;
  std::vector<CellHandle> cells_;
};

}  // namespace

void mark_and_peel(Delaunay& delaunay) { Solid(delaunay).mark_and_peel(); }

}  // namespace cocoon::ref::on_cgal
