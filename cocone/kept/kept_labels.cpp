#include "cocone/kept/kept_labels.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "cocone/facets/half_star.h"
#include "cocone/marking/old_triangles.h"
#include "delaunay/star_finder.h"
#include "geom/arrays/zeroed_array.h"

namespace cocoon {
namespace {

class KeptLabels {
 public:
  KeptLabels(const Triangulation& triangulation, const IdVector<VertexId, CellId>& cell_at,
             BodyBefore before, const KnownTriangles& triangles)
      : triangulation_(triangulation),
        cell_at_(cell_at),
        before_(std::move(before)),
        at_(triangulation.num_vertices()),
        told_(triangulation.num_cells()) {
    list_asked(triangles.torn());
    triangles_ = triangles.at(asked_points());
  }

  KnownLabels run() {
    // None is known at all: each vertex of the mesh has been asked.
    if (triangles_.empty() && asked_.size() == triangulation_.num_vertices()) return {};
    StarFinder finder;
    stars_ = finder.stars(triangulation_, cell_at_, asked_);
    OldTriangles old(triangulation_, triangles_);
    find_facets(old);
    tell_what_was();
    HalfStar half(triangulation_, old.facets());
    for (const VertexId v : asked_) {
      if (!old.is_corner(v)) continue;
      at_[v] |= corner;
      if (!old.is_intact(v)) continue;
      at_[v] |= intact;
      old.tell_around(v, told_in, half, told_);
      old.tell_around(v, told_out, half, told_);
    }
    return labels();
  }

 private:
  // 0: not asked.
  enum AtVertex : std::uint8_t { asked = 1, corner = 2, intact = 4 };

  void list_asked(std::span<const PointId> torn) {
    for (const PointId p : torn) ask(triangulation_.vertex_of_point()[p]);
    for (const CellId c : before_.created) {
      for (const VertexId v : triangulation_.cell(c).vertices) {
        if (v != infinite_vertex) ask(v);
      }
    }
  }
  void ask(VertexId v) {
    if (std::exchange(at_[v], std::uint8_t{asked}) == 0) asked_.push_back(v);
  }

  std::vector<PointId> asked_points() const {
    const auto& vertex_of_point = triangulation_.vertex_of_point();
    std::vector<PointId> points;
    for (const PointId p : vertex_of_point.ids()) {
      if (at_[vertex_of_point[p]] != 0) points.push_back(p);
    }
    return points;
  }

  void find_facets(OldTriangles& old) const {
    std::vector<OldTriangles::Found> found;
    for (const CellId c : stars_) {
      if (triangulation_.is_infinite(c)) continue;
      for (int i = 0; i < 4; ++i) {
        const FacetId f = facet_id(c, i);
        if (triangulation_.mirror(f) < f) continue;  // the other cell is a finite one of these, too
        const auto [x, y, z] = triangulation_.facet_vertices(f);
        if ((at_[x] | at_[y] | at_[z]) != 0) old.find(f, found);
      }
    }
    for (const OldTriangles::Found& one : found) old.enter(one);
  }

  // By the vertices that are not asked.
  void tell_what_was() {
    for (const CellId c : stars_) {
      const CellLabel label = before_.labels[c];
      if (label == CellLabel::unmarked) continue;
      const auto& vertices = triangulation_.cell(c).vertices;
      const bool is_told =
          std::any_of(vertices.begin(), vertices.end(), [&](VertexId v) { return at_[v] == 0; });
      if (is_told) told_[c] = label == CellLabel::out ? told_out : told_in;
    }
  }

  // Bit i: vertex i of the cell has this flag, or is not asked, and so is all that it was.
  unsigned vertices_with(unsigned flag, const Cell& cell) const {
    unsigned found = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned here = at_[cell.vertices[i]];
      if (here == 0 || (here & flag) != 0) found |= 1U << i;
    }
    return found;
  }

  KnownLabels labels() {
    KnownLabels known;
    known.labels = std::move(before_.labels);
    for (const CellId c : stars_) {
      if (triangulation_.is_infinite(c)) continue;
      if (told_[c] == told_both) ++known.contradictions;
      const Cell& cell = triangulation_.cell(c);
      known.labels[c] = is_believed(vertices_with(corner, cell), vertices_with(intact, cell))
                            ? label_told(told_[c])
                            : CellLabel::unmarked;
    }
    for (const CellLabel label : known.labels)
      known.cells += label != CellLabel::unmarked ? 1U : 0U;
    return known;
  }

  const Triangulation& triangulation_;
  const IdVector<VertexId, CellId>& cell_at_;
  BodyBefore before_;
  ZeroedArray<VertexId, std::uint8_t> at_;
  std::vector<VertexId> asked_;
  std::vector<KnownTriangle> triangles_;  // at these
  std::span<const CellId> stars_;         // of these
  ZeroedArray<CellId, std::uint8_t> told_;
};

}  // namespace

KnownLabels kept_labels(const Triangulation& triangulation,
                        const IdVector<VertexId, CellId>& cell_at, BodyBefore before,
                        const OldSurface& old, const Execution& execution) {
  KnownLabels known = KeptLabels(triangulation, cell_at, std::move(before), old.triangles).run();
  if (old.add_likely) old.add_likely(triangulation, known, execution);
  return known;
}

}  // namespace cocoon
