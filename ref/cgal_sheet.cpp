// prune_and_walk() of cgal_triangulation.h.
#include <algorithm>

#include "ref/cgal_triangulation.h"

namespace cocoon::ref::on_cgal {
namespace {

constexpr double pruning_cosine = 0.5;  // 60 degrees
constexpr double flat_cosine = -0.7;    // of the dihedral: 134.4 degrees

// Cosine of the dihedral at edge (a, b) between the half planes through c and d.
double dihedral_cosine(VertexHandle a, VertexHandle b, VertexHandle c, VertexHandle d) {
  const Vec3 edge = place(b) - place(a);
  const Vec3 u = cross(edge, place(c) - place(a));
  const Vec3 v = cross(edge, place(d) - place(a));
  return dot(u, v) / (norm(u) * norm(v));
}

double squared_circumradius(const Facet& f) {
  const Vec3 u = place(corner(f, 1)) - place(corner(f, 0));
  const Vec3 v = place(corner(f, 2)) - place(corner(f, 0));
  const double twice_area = norm(cross(u, v));
  if (twice_area == 0) return infinity;
  const double radius = norm(u) * norm(v) * norm(v - u) / (2 * twice_area);
  return radius * radius;
}

// Where a walk may begin.
struct Start {
  bool on_hull;
  double size;
  Facet facet;  // seen from the side of the walk
};

class Sheet {
 public:
  explicit Sheet(Delaunay& delaunay) : delaunay_(delaunay) {}

  void prune() {
    for (const VertexHandle v : delaunay_.finite_vertex_handles()) find_umbrella(v);
    std::vector<Facet> work;
    for (const Facet& f : delaunay_.finite_facets()) {
      if (is_surface(f)) work.push_back(f);
    }
    while (!work.empty()) {
      const Facet f = work.back();
      work.pop_back();
      if (is_surface(f)) prune_at(f, work);
    }
  }

  // From each facet on the hull and then each other one that is not reached, the smallest circle
  // first: nothing of that depends on where the axes lie.
  void walk() {
    std::vector<Start> starts;
    for (const Facet& f : delaunay_.finite_facets()) {
      if (!may_start(f)) continue;
      const Facet wider = on_wider_side(f);
      starts.push_back({delaunay_.is_infinite(wider.first), squared_circumradius(f), wider});
    }
    std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) {
      return a.on_hull != b.on_hull ? a.on_hull : a.size < b.size;
    });
    for (const Start& start : starts) {
      if (may_start(start.facet)) walk_from(start.facet);
    }
  }

 private:
  struct Step {
    Facet facet;  // of the cell on the side where the walk is
    VertexHandle a;
    VertexHandle b;
  };

  static bool may_start(const Facet& f) {
    if (!is_surface(f)) return false;
    for (int k = 0; k < 3; ++k) {
      if (!corner(f, k)->info().umbrella || corner(f, k)->info().on_surface) return false;
    }
    return true;
  }

  // Seen from where the fourth vertex of the cell is farther from the corners.
  Facet on_wider_side(const Facet& f) const {
    const auto reach = [&](const Facet& half) {
      const VertexHandle ahead = half.first->vertex(half.second);
      double sum = 0;
      for (int k = 0; k < 3; ++k) {
        sum += delaunay_.is_infinite(ahead) ? infinity
                                            : squared_norm(place(corner(f, k)) - place(ahead));
      }
      return sum;
    };
    const Facet mirror = delaunay_.mirror_facet(f);
    return reach(mirror) > reach(f) ? mirror : f;
  }

  bool& visited(const Facet& f) const {
    return f.first->info().visited[static_cast<std::size_t>(f.second)];
  }

  void visit(const Facet& f, std::vector<Step>& stack) const {
    visited(f) = visited(delaunay_.mirror_facet(f)) = true;
    for (int k = 0; k < 3; ++k) {
      const VertexHandle a = corner(f, k);
      const VertexHandle b = corner(f, (k + 1) % 3);
      a->info().on_surface = true;
      if (a->info().umbrella || b->info().umbrella) stack.push_back({f, a, b});
    }
  }

  // Turns about each edge into the cell of the side: the first facet met is the next one of the
  // sheet, those behind it are not seen.
  void walk_from(const Facet& start) const {
    std::vector<Step> stack;
    visit(start, stack);
    while (!stack.empty()) {
      const auto [f, a, b] = stack.back();
      stack.pop_back();
      const VertexHandle back = third(f, a, b);
      CellHandle cell = f.first;
      VertexHandle behind = back;
      VertexHandle ahead = cell->vertex(f.second);
      for (bool first = true; ahead != back;) {
        const Facet g{cell, cell->index(behind)};
        if (is_surface(g)) {
          if (first && !visited(g)) visit(g, stack);
          if (!first && !visited(g)) set_surface(delaunay_, g, false);
          first = false;
        }
        const CellHandle next = cell->neighbor(g.second);
        behind = ahead;
        ahead = next->vertex(next->index(cell));
        cell = next;
      }
    }
  }

  // Takes away triangles that at one of their spokes have no partner at 60 degrees or more.
  void find_umbrella(VertexHandle v) {
    auto link = link_of(delaunay_, v);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < link.size() && !changed; ++i) {
        for (const int s : {0, 1}) {
          const VertexHandle spoke = link[i][static_cast<std::size_t>(s)];
          const VertexHandle far = link[i][static_cast<std::size_t>(1 - s)];
          const bool partner = std::any_of(link.begin(), link.end(), [&](const auto& other) {
            if (&other == &link[i] || (other[0] != spoke && other[1] != spoke)) return false;
            return dihedral_cosine(v, spoke, far, other[0] == spoke ? other[1] : other[0]) <=
                   pruning_cosine;
          });
          if (partner) continue;
          link.erase(link.begin() + static_cast<std::ptrdiff_t>(i));
          changed = true;
          break;
        }
      }
    }
    v->info().umbrella = link.size() >= 3;
  }

  // The surface facets at the edge (a, b) of a cell.
  std::vector<Facet> facets_at(const CellHandle c, VertexHandle a, VertexHandle b) const {
    std::vector<Facet> result;
    auto circulator = delaunay_.incident_facets(c, c->index(a), c->index(b));
    const auto begin = circulator;
    do {
      if (!delaunay_.is_infinite(*circulator) && is_surface(*circulator))
        result.push_back(*circulator);
    } while (++circulator != begin);
    return result;
  }

  static VertexHandle third(const Facet& f, VertexHandle a, VertexHandle b) {
    for (int k = 0; k < 3; ++k) {
      if (corner(f, k) != a && corner(f, k) != b) return corner(f, k);
    }
    return {};
  }

  // Deletes the facets at a sharp edge of f, but for those that lie flat against their neighbor.
  void prune_at(const Facet& f, std::vector<Facet>& work) {
    for (int k = 0; k < 3; ++k) {
      const VertexHandle a = corner(f, k);
      const VertexHandle b = corner(f, (k + 1) % 3);
      if (!a->info().umbrella || !b->info().umbrella) continue;
      const std::vector<Facet> fan = facets_at(f.first, a, b);
      bool sharp = true;
      for (std::size_t i = 0; i < fan.size(); ++i) {
        for (std::size_t j = i + 1; j < fan.size(); ++j) {
          sharp = sharp &&
                  dihedral_cosine(a, b, third(fan[i], a, b), third(fan[j], a, b)) > pruning_cosine;
        }
      }
      if (!sharp) continue;
      for (const Facet& g : fan) {
        if (lies_flat(g)) continue;
        set_surface(delaunay_, g, false);
        for (int m = 0; m < 3; ++m) {
          const auto around = facets_at(g.first, corner(g, m), corner(g, (m + 1) % 3));
          work.insert(work.end(), around.begin(), around.end());
        }
      }
      if (!is_surface(f)) return;
    }
  }

  bool lies_flat(const Facet& f) const {
    for (int k = 0; k < 3; ++k) {
      const VertexHandle a = corner(f, k);
      const VertexHandle b = corner(f, (k + 1) % 3);
      const std::vector<Facet> fan = facets_at(f.first, a, b);
      if (fan.size() == 2 &&
          dihedral_cosine(a, b, third(fan[0], a, b), third(fan[1], a, b)) <= flat_cosine) {
        return true;
      }
    }
    return false;
  }

  Delaunay& delaunay_;
};

}  // namespace

void prune_and_walk(Delaunay& delaunay) {
  Sheet sheet(delaunay);
  sheet.prune();
  sheet.walk();
}

}  // namespace cocoon::ref::on_cgal
