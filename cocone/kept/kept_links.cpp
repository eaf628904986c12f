#include "cocone/kept/kept_links.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geom/arrays/sort_ids.h"
#include "geom/arrays/visit_where.h"

namespace cocoon {
namespace {

constexpr unsigned is_new = 16;  // of a cell: not as it was, or not there

// Puts triangles in and takes others out, and links what that concerns.
class Relinking {
 public:
  Relinking(const Triangulation& triangulation, LinkedFacets& triangles)
      : triangulation_(triangulation), triangles_(triangles) {
    VertexId last(triangulation.num_vertices());
    for (const Triangle& corners : triangles.corners) {
      last = std::max({last, corners[0], corners[1], corners[2]});
    }
    touched_.resize(last.index() + 1, 0);
  }

  // `removed`: positions, ascending. `added`: canonical ids.
  void run(std::vector<std::uint32_t> removed, std::vector<FacetId> added,
           const Execution& execution) {
    drop_behind_end(removed, added);
    for (const std::uint32_t t : removed) touch(triangles_.corners[t]);
    std::vector<std::uint32_t> places;  // of those added
    for (const std::uint32_t t : removed) {
      if (t < size_) places.push_back(t);
    }
    for (std::size_t t = triangles_.size(); t < size_; ++t) {
      places.push_back(static_cast<std::uint32_t>(t));
    }
    triangles_.resize(size_);
    std::vector<std::uint8_t> is_added(size_, 0);
    for (std::size_t k = 0; k < added.size(); ++k) {
      put(added[k], places[k]);
      is_added[places[k]] = 1;
    }
    link(is_added, execution);
  }

 private:
  // Triangles that stay, but behind the end to come, go and come again.
  void drop_behind_end(std::vector<std::uint32_t>& removed, std::vector<FacetId>& added) {
    const std::size_t before = triangles_.size();
    size_ = before + added.size() - removed.size();
    auto gone = std::lower_bound(removed.begin(), removed.end(), size_);
    std::vector<std::uint32_t> moved;
    for (std::size_t t = size_; t < before; ++t) {
      if (gone != removed.end() && *gone == t) {
        ++gone;
      } else {
        moved.push_back(static_cast<std::uint32_t>(t));
      }
    }
    for (const std::uint32_t t : moved) added.push_back(triangles_.facets[t]);
    removed.insert(removed.end(), moved.begin(), moved.end());
  }

  void touch(const Triangle& corners) {
    for (const VertexId v : corners) touched_[v] = 1;
  }

  void put(FacetId f, std::uint32_t t) {
    triangles_.facets[t] = f;
    triangles_.mirrors[t] = triangulation_.mirror(f);
    triangles_.corners[t] = triangulation_.facet_vertices(f);
    touch(triangles_.corners[t]);
  }

  // All triangles at edges between touched vertices, as a mesh of their own.
  void link(const std::vector<std::uint8_t>& is_added, const Execution& execution) {
    std::vector<std::uint32_t> near;
    LinkedFacets local;
    for (std::uint32_t t = 0; t < size_; ++t) {
      const auto& [a, b, c] = triangles_.corners[t];
      if (touched_[a] + touched_[b] + touched_[c] < 2) continue;
      near.push_back(t);
      local.facets.push_back(triangles_.facets[t]);
      local.corners.push_back(triangles_.corners[t]);
    }
    link_corners(triangulation_.points(), local, execution);
    for (std::uint32_t k = 0; k < near.size(); ++k) {
      if (is_added[near[k]] != 0) triangles_.normals[near[k]] = local.normals[k];
      for (std::uint32_t i = 0; i < 3; ++i) {
        const auto [from, to] = local.ends(3 * k + i);
        if ((touched_[from] & touched_[to]) == 0) continue;
        const Halfedge next = local.links[3 * k + i];
        triangles_.links[3 * near[k] + i] =
            3 * near[triangle_of_halfedge(next)] + corner_of_halfedge(next);
      }
    }
    update_steep(near, local);
  }

  // `near`: the triangles that are linked anew, in `local`.
  void update_steep(const std::vector<std::uint32_t>& near, const LinkedFacets& local) {
    std::vector<Halfedge>& steep = triangles_.steep;
    const auto is_linked_anew = [&](Halfedge halfedge) {
      const auto [from, to] = triangles_.ends(halfedge);
      return (touched_[from] & touched_[to]) != 0;
    };
    std::erase_if(steep, [&](Halfedge halfedge) {
      return triangle_of_halfedge(halfedge) >= size_ || is_linked_anew(halfedge);
    });
    const auto kept = static_cast<std::ptrdiff_t>(steep.size());
    for (const Halfedge halfedge : local.steep) {
      const Halfedge here = 3 * near[triangle_of_halfedge(halfedge)] + corner_of_halfedge(halfedge);
      if (is_linked_anew(here)) steep.push_back(here);  // the first there as in `local`
    }
    std::inplace_merge(steep.begin(), steep.begin() + kept, steep.end());
  }

  const Triangulation& triangulation_;
  LinkedFacets& triangles_;
  std::size_t size_ = 0;  // to come
  VertexSet touched_;     // corners of triangles that come or go
};

}  // namespace

void KeptLinks::keep(LinkedFacets surface, RemovedFacets rest) {
  exists_ = true;
  triangles_ = put_back(std::move(surface), std::move(rest));
  cells_ = std::exchange(triangles_.set, {}).release();
}

void KeptLinks::update(const DynamicDelaunay& delaunay, const DelaunayChange& change) {
  // Cells are created in slots of deleted ones, of this change or earlier ones, or in new slots.
  cells_.resize(std::max(cells_.size(), delaunay.view().cell_records().size()), is_new);
  for (const CellId c : change.deleted) cells_[c] = is_new;
}

void KeptLinks::renumber(const Renumbering& renumbering, const DynamicDelaunay& delaunay) {
  for (const auto& [a, b] : renumbering.cells) cells_[a] = cells_[b] = is_new;
  std::vector<VertexId> moved;
  for (const auto& move : renumbering.vertices) moved.push_back(move.to);
  for (const CellId c : stars_.stars(delaunay, moved)) cells_[c] = is_new;
}

// Precondition: one of those kept.
bool KeptLinks::is_kept(const FacetSet& facets, FacetId facet, FacetId mirror) const {
  return ((cells_[cell_of(facet)] | cells_[cell_of(mirror)]) & is_new) == 0 &&
         facets.contains(facet);
}

// Those that are not kept, by canonical ids.
std::vector<FacetId> KeptLinks::new_facets(const Triangulation& triangulation,
                                           const FacetSet& facets) const {
  std::vector<FacetId> found;
  const auto is_changed = [&](std::size_t cell) {
    const unsigned before = cells_[CellId(cell)];
    return ((facets.bits(CellId(cell)) & ~before) | (before & is_new)) != 0;
  };
  visit_where(triangulation.num_cells(), is_changed, [&](std::size_t cell) {
    for (int i = 0; i < 4; ++i) {
      const FacetId f = facet_id(CellId(cell), i);
      if (facets.contains(f)) found.push_back(triangulation.canonical(f));
    }
  });
  make_set(found);
  std::erase_if(found, [&](FacetId f) {
    const bool was_there = ((unsigned{cells_[cell_of(f)]} >> index_of(f)) & 1U) != 0;
    return was_there && is_kept(facets, f, triangulation.mirror(f));
  });
  return found;
}

LinkedFacets KeptLinks::link(const Triangulation& triangulation, FacetSet facets,
                             const Execution& execution) {
  if (!exists_) return link_facets(triangulation, std::move(facets), execution);
  std::vector<std::uint32_t> removed;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (!is_kept(facets, triangles_.facets[t], triangles_.mirrors[t])) removed.push_back(t);
  }
  std::vector<FacetId> added = new_facets(triangulation, facets);
  LinkedFacets triangles = std::move(triangles_);
  clear();
  if (2 * (removed.size() + added.size()) > triangles.size()) {
    return link_facets(triangulation, std::move(facets), execution);
  }
  Relinking(triangulation, triangles).run(std::move(removed), std::move(added), execution);
  triangles.set = std::move(facets);
  return triangles;
}

}  // namespace cocoon
