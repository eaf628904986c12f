// prune() and walk() of cgal_triangulation.h.
#include <algorithm>
#include <array>
#include <vector>

#include "ref/cgal_triangulation.h"

namespace cocoon::ref::on_cgal {
namespace {

constexpr double pruning_cosine = 0.5;  // 60 degrees
constexpr double flat_cosine = -0.7;    // of the dihedral: 134.4 degrees

// Where a walk may begin, seen from the side of the walk. All on the hull come before all others.
struct Start {
  bool inside;
  double size;
  std::array<Vec3, 3> corners;  // they settle ties
  Facet facet;

  friend bool operator<(const Start& a, const Start& b) {
    if (a.inside != b.inside) return b.inside;
    return a.size != b.size ? a.size < b.size : a.corners < b.corners;
  }
};

class Sheet {
 public:
  explicit Sheet(Delaunay& delaunay) : delaunay_(delaunay) {}

  // Flags of vertices and marks of triangles that stay are those before anything goes.
  void prune() {
    for (const VertexHandle v : delaunay_.finite_vertex_handles()) find_umbrella(v);
    std::vector<Facet> work;
    for (const Facet& f : delaunay_.finite_facets()) {
      if (!is_surface(f)) continue;
      work.push_back(f);
      stays(f) = stays(delaunay_.mirror_facet(f)) = lies_flat(f);
    }
    while (!work.empty()) {
      const Facet f = work.back();
      work.pop_back();
      if (is_surface(f)) prune_at(f, work);
    }
  }

  // From each facet on the hull and then each other one that shares no vertex with what is kept,
  // the smallest circle first. What no walk met stays where it is apart from all walks.
  void walk() {
    std::vector<Start> starts;
    for (const Facet& f : delaunay_.finite_facets()) {
      if (may_start(f)) add_start(f, starts);
    }
    std::sort(starts.begin(), starts.end());
    for (const Start& start : starts) {
      if (may_start(start.facet)) walk_from(start.facet);
    }
    for (const Facet& f : delaunay_.finite_facets()) {
      const bool is_kept = kept(f) || kept(delaunay_.mirror_facet(f));
      if (is_surface(f) && !is_kept && touches_walk(f)) set_surface(delaunay_, f, false);
    }
  }

 private:
  bool& stays(const Facet& f) const { return note(f.first->info().stays, f); }
  bool& kept(const Facet& f) const { return note(f.first->info().kept, f); }
  bool& proposed(const Facet& f) const { return note(f.first->info().proposed, f); }
  static bool& note(std::array<bool, 4>& notes, const Facet& f) {
    return notes[static_cast<std::size_t>(f.second)];
  }

  static bool touches_walk(const Facet& f) {
    return corner(f, 0)->info().on_surface || corner(f, 1)->info().on_surface ||
           corner(f, 2)->info().on_surface;
  }
  static bool may_start(const Facet& f) {
    return is_surface(f) && !touches_walk(f) && corner(f, 0)->info().umbrella &&
           corner(f, 1)->info().umbrella && corner(f, 2)->info().umbrella;
  }

  // Seen from its wider side, if that is not inside a flat cell all of whose facets are candidates;
  // inside of two of them no walk begins.
  void add_start(const Facet& f, std::vector<Start>& starts) const {
    const auto is_inside_flat = [](const Facet& half) {
      const auto& surface = half.first->info().surface;
      return std::find(surface.begin(), surface.end(), false) == surface.end();
    };
    Facet from = on_wider_side(f);
    if (is_inside_flat(from)) from = delaunay_.mirror_facet(from);
    if (is_inside_flat(from)) return;
    starts.push_back({!delaunay_.is_infinite(from.first), circumradius(f), sorted_places(f), from});
  }

  // Seen from where the fourth vertex of the cell is farther from the corners; of equally far ones
  // from where the sorted corners run counterclockwise.
  Facet on_wider_side(const Facet& f) const {
    const Facet mirror = delaunay_.mirror_facet(f);
    const double here = reach(f);
    const double behind = reach(mirror);
    if (here != behind) return here > behind ? f : mirror;
    return sees_positive_side(f) ? f : mirror;
  }
  double reach(const Facet& f) const {
    const VertexHandle ahead = f.first->vertex(f.second);
    if (delaunay_.is_infinite(ahead)) return infinity;
    double sum = 0;
    for (const Vec3& p : sorted_places(f)) sum += squared_distance(p, place(ahead));
    return sum;
  }
  // CGAL numbers the corners of a facet clockwise seen from outside of its cell.
  static bool sees_positive_side(const Facet& f) {
    const std::array<Vec3, 3> sorted = sorted_places(f);
    int k = 0;
    while (place(corner(f, k)) != sorted[0]) ++k;
    return place(corner(f, (k + 1) % 3)) == sorted[1];
  }

  void keep(const Facet& f) const {
    kept(f) = true;
    for (int k = 0; k < 3; ++k) corner(f, k)->info().on_surface = true;
  }

  // In rounds: all facets that the last one kept turn about their edges at once. What is kept or
  // dropped stays so. Of the two sides from which one round may propose a facet the wider one
  // counts; what it would both keep and drop is kept.
  void walk_from(const Facet& start) const {
    keep(start);
    for (std::vector<Facet> frontier = {start}; !frontier.empty();) {
      std::vector<Facet> first;
      std::vector<Facet> later;
      for (const Facet& f : frontier) {
        for (int k = 0; k < 3; ++k) turn(f, corner(f, k), corner(f, (k + 1) % 3), first, later);
      }
      for (const Facet& f : first) proposed(f) = true;
      frontier.clear();
      for (const Facet& f : first) {
        if (kept(f)) continue;  // it was met from several edges
        const bool both = proposed(delaunay_.mirror_facet(f));
        if (both && on_wider_side(f) != f) continue;
        keep(f);
        frontier.push_back(f);
      }
      for (const Facet& f : first) proposed(f) = false;
      for (const Facet& f : later) {
        if (!kept(f) && !kept(delaunay_.mirror_facet(f))) set_surface(delaunay_, f, false);
      }
    }
  }

  // Turns about an edge into the cell of the side: the first facet met is the next one of the
  // sheet, those behind it are not seen.
  void turn(const Facet& f, VertexHandle a, VertexHandle b, std::vector<Facet>& first,
            std::vector<Facet>& later) const {
    if (!a->info().umbrella && !b->info().umbrella) return;
    const VertexHandle back = third(f, a, b);
    CellHandle cell = f.first;
    VertexHandle behind = back;
    VertexHandle ahead = cell->vertex(f.second);
    for (bool is_first = true; ahead != back;) {
      const Facet g{cell, cell->index(behind)};
      if (is_surface(g)) {
        const bool is_kept = kept(g) || kept(delaunay_.mirror_facet(g));
        if (!is_kept) (is_first ? first : later).push_back(g);
        is_first = false;
      }
      const CellHandle next = cell->neighbor(g.second);
      behind = ahead;
      ahead = next->vertex(next->index(cell));
      cell = next;
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

  // Deletes the facets at a sharp edge of f, but for those that are to stay.
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
        if (stays(g)) continue;
        set_surface(delaunay_, g, false);
        for (int m = 0; m < 3; ++m) {
          const auto around = facets_at(g.first, corner(g, m), corner(g, (m + 1) % 3));
          work.insert(work.end(), around.begin(), around.end());
        }
      }
      if (!is_surface(f)) return;
    }
  }

  // Against its only neighbor at some edge.
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

void prune(Delaunay& delaunay) { Sheet(delaunay).prune(); }
void walk(Delaunay& delaunay) { Sheet(delaunay).walk(); }

}  // namespace cocoon::ref::on_cgal
