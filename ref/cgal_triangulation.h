// The triangulation on which cgal_cocone.cpp, cgal_surface.cpp with its parts, and
// cgal_noise_filter.cpp work, and what they note in it. Only these include it: CGAL stays out of
// all other headers.
#pragma once

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "geom/point.h"
#include "ref/cgal_cocone.h"
#include "ref/marking_rounds.h"

namespace cocoon::ref::on_cgal {

// What the algorithms note at vertices and cells, where CGAL keeps it.
struct VertexInfo {
  std::uint32_t id = 0;
  Vec3 normal;
  double height = 0;
  double radius = 0;
  bool degenerate = false;
  bool interior = false;
  bool umbrella = false;  // it has a closed fan of triangles
  bool on_surface = false;
  bool good = false;
  bool visited = false;
  // What another way has chosen, if it is to be taken at ties within rounding (cgal_stages.h).
  Vec3 normal_at_ties;
  bool took_tie = false;
};

struct CellInfo {
  Vec3 center;                       // circumcenter of a finite cell
  std::array<bool, 4> surface = {};  // facets that are candidates, then on the surface
  // Facets, as seen from here:
  std::array<bool, 4> stays = {};     // not to be pruned
  std::array<bool, 4> proposed = {};  // by a round of the walk
  std::array<bool, 4> kept = {};      // by the walk
  bool reached = false;
  CellNotes marking;
  int stop_facet_at_ties = -1;  // as normal_at_ties
  bool took_tie = false;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<VertexInfo, Kernel>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<
    Kernel, CGAL::Triangulation_cell_base_with_info_3<CellInfo, Kernel>>;
using DataStructure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, DataStructure>;
using VertexHandle = Delaunay::Vertex_handle;
using CellHandle = Delaunay::Cell_handle;
using Facet = Delaunay::Facet;

constexpr double rounding = 1e-12;  // relative: below it two lengths are a tie
constexpr double infinity = std::numeric_limits<double>::infinity();

inline Vec3 to_vec3(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }
inline Vec3 place(VertexHandle v) { return to_vec3(v->point()); }
inline VertexHandle corner(const Facet& f, int k) {
  return f.first->vertex(Delaunay::vertex_triple_index(f.second, k));
}

inline bool is_surface(const Facet& f) {
  return f.first->info().surface[static_cast<std::size_t>(f.second)];
}
inline void set_surface(const Delaunay& delaunay, const Facet& f, bool value) {
  const Facet mirror = delaunay.mirror_facet(f);
  f.first->info().surface[static_cast<std::size_t>(f.second)] = value;
  mirror.first->info().surface[static_cast<std::size_t>(mirror.second)] = value;
}

// Vertices have the positions of their points as ids. The time is that of CGAL alone.
Delaunay triangulation_of(Points points, double* processor_seconds = nullptr);

// Of the hull facet of an infinite cell, unit. CGAL numbers the corners of a facet clockwise seen
// from outside of its cell: that holds for the flattest cell, too.
inline Vec3 outward_normal(const Delaunay& delaunay, CellHandle infinite_cell) {
  const Facet f =
      delaunay.mirror_facet({infinite_cell, infinite_cell->index(delaunay.infinite_vertex())});
  const Vec3 a = place(corner(f, 0));
  return unit(cross(place(corner(f, 2)) - a, place(corner(f, 1)) - a));
}

// Of a finite facet. Both are the same bits from both of its sides.
std::array<Vec3, 3> sorted_places(const Facet& f);  // of its corners, lexicographically
double circumradius(const Facet& f);                // infinite if they are collinear

// Cosine of the dihedral at edge (a, b) between the half planes through c and d.
double dihedral_cosine(VertexHandle a, VertexHandle b, VertexHandle c, VertexHandle d);

// The surface facets at v, each by its two other corners.
std::vector<std::array<VertexHandle, 2>> link_of(const Delaunay& delaunay, VertexHandle v);

// Poles, labels, candidate facets: sets `surface` of the cells. Boundary samples are those vertices
// that are not `interior`. False if there are no others: then no surface can be begun.
bool find_candidates(Delaunay& delaunay, const CgalCoconeOptions& options);

// Takes away candidates at sharp edges.
void prune(Delaunay& delaunay);

// Takes away those beside the sheet that a walk over the candidates meets first.
void walk(Delaunay& delaunay);

// Finds the good vertices and marks cells from them.
void mark(Delaunay& delaunay, const CgalCoconeOptions& options);

// Peels the others from outside: sets `reached` there.
void peel(Delaunay& delaunay);

}  // namespace cocoon::ref::on_cgal
